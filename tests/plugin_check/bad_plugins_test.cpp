// Each bad plug-in fails the check that is there for its fault, and no other.
#include <gmock/gmock.h>

#include "plugin_check_command.hpp"

namespace gaitway::tests {
namespace {

using testing::HasSubstr;

struct BadPlugin {
  const char* library;
  const char* check;
  const char* text;  // what the finding says
};

void PrintTo(const BadPlugin& plugin, std::ostream* out) {
  *out << plugin.library;
}

class BadPlugins : public testing::TestWithParam<BadPlugin> {};

TEST_P(BadPlugins, FailsItsOwnCheckAlone) {
  const BadPlugin& bad = GetParam();
  const CheckOutcome outcome =
      check_plugin(std::filesystem::path(GAITWAY_BAD_PLUGINS) / (std::string(bad.library) + ".so"));
  EXPECT_EQ(outcome.exit_code, 2) << outcome.text;
  EXPECT_EQ(outcome.failed_checks(), std::set<std::string>{bad.check}) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr(bad.text));
  EXPECT_THAT(outcome.text, HasSubstr("remedy: "));
}

const std::vector<BadPlugin>& bad_plugins() {
  static const std::vector<BadPlugin> all{
      {"second_symbol", "abi", "more symbol"},
      {"bad_version", "descriptor", "no semantic version"},
      {"no_unit", "descriptor", "parameter 'gain' has no unit"},
      {"bad_default", "descriptor", "outside of its range"},
      {"hangs_in_create", "life_cycle", "does not return"},
      {"fails_in_create", "life_cycle", "no calibration file"},
      {"crashes_on_destroy_without_activate", "life_cycle", "destroy without activate: in destroy"},
      {"crashes_on_second_activate", "life_cycle", "activate twice: in activate"},
      {"starts_thread", "unload", "still there after destroy"},
      {"leaks_descriptor", "unload", "descriptors open"},
      {"stays_loaded", "unload", "-z nodelete"},
      {"shares_static", "two_instances", "when a second instance runs beside it"},
      {"depends_on_address", "determinism", "in another process"},
      {"depends_on_uninitialised", "determinism", "in another process"},
      {"depends_on_time", "determinism", "in another process"},
      {"too_slow", "budget", "more than its budget"},
      {"publishes_nan", "values", "trim.angle[3] is nan"},
      {"out_of_range", "values", "trim.softness is 1.5 1, allowed is 0 to 1"},
      {"jumps", "values", "jumps from"},
      {"crashes_on_missing_input", "values", "missing: in step"},
      {"crashes_on_joint_count", "values", "joint_count = 64: in step"},
      {"publishes_nan_on_nan", "values", "not a number"},
      {"never_recovers", "values", "publishes nothing any more"},
      {"crashes_on_parameter", "parameters", "filter = '10': in create"},
      {"hangs_on_parameter", "parameters", "filter = '10': in create"},
      {"nan_on_parameter", "parameters", "is taken, but then"},
      {"crashes_on_live_change", "parameters", "live changes of gain: in step"},
      {"forgets_state", "state", "outputs differ"},
      {"wrong_state_size", "state", "its own state is refused"},
      {"takes_any_state", "state", "8 bytes too many"},
      {"leaks_memory", "unload", "leaks"},
      {"keeps_memory_on_refusal", "life_cycle", "a create that fails keeps"},
      {"allocates", "real_time", "calls malloc()"},
      {"locks", "real_time", "calls pthread_mutex_lock()"},
      {"calls_system", "real_time", "makes the system call"},
      {"throws_in_step", "real_time", "throws an exception"},
  };
  return all;
}

INSTANTIATE_TEST_SUITE_P(Faults, BadPlugins, testing::ValuesIn(bad_plugins()),
                         [](const auto& tried) { return std::string(tried.param.library); });

TEST(BadPlugins, TheSamePluginWithoutAFaultHasNoFinding) {
  const CheckOutcome outcome = check_plugin(std::filesystem::path(GAITWAY_BAD_PLUGINS) / "none.so");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
}

TEST(BadInput, IsNoFinding) {
  EXPECT_EQ(check_plugin("/nowhere/plugin.so").exit_code, 1);
  EXPECT_THAT(check_plugin("/nowhere/plugin.so").text, HasSubstr("there is no such file"));
  const auto robot = check_plugin(std::filesystem::path(GAITWAY_BAD_PLUGINS) / "none.so", "--robot /nowhere");
  EXPECT_EQ(robot.exit_code, 1);
}

TEST(BadInput, WhatIsNoPluginFailsTheAbiCheck) {
  const CheckOutcome outcome = check_plugin(GAITWAY_COMMAND);
  EXPECT_EQ(outcome.exit_code, 2) << outcome.text;
  EXPECT_EQ(outcome.failed_checks(), std::set<std::string>{"abi"}) << outcome.text;
}

}  // namespace
}  // namespace gaitway::tests
