// The plug-ins that walk have no finding in the long form, either.
#include "plugin_check_command.hpp"

namespace gaitway::tests {
namespace {

class ShippedPlugins : public testing::TestWithParam<const char*> {};

TEST_P(ShippedPlugins, HasNoFinding) {
  const auto library = std::filesystem::path(GAITWAY_SHIPPED_PLUGINS) /
                       (std::string("libgaitway_plugin_") + GetParam() + ".so");
  const CheckOutcome outcome = check_plugin(library, "--full");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_EQ(outcome.report.value("findings", 99), 0);
  EXPECT_EQ(outcome.report.value("name", ""), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Full, ShippedPlugins,
                         testing::Values("trajectory", "kinematics", "zmp", "stability"),
                         [](const auto& tried) { return std::string(tried.param); });

}  // namespace
}  // namespace gaitway::tests
