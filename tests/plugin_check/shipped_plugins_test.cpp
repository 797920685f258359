// The plug-ins that walk have no finding; built a second time for the check's long form.
#include "plugin_check_command.hpp"

namespace gaitway::tests {
namespace {

#ifdef GAITWAY_CHECK_FULL
constexpr const char* kForm = "--full";
#else
constexpr const char* kForm = "";
#endif

class ShippedPlugins : public testing::TestWithParam<const char*> {};

TEST_P(ShippedPlugins, HasNoFinding) {
  const auto library = std::filesystem::path(GAITWAY_SHIPPED_PLUGINS) /
                       (std::string("libgaitway_plugin_") + GetParam() + ".so");
  const CheckOutcome outcome = check_plugin(library, kForm);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  EXPECT_EQ(outcome.report.value("findings", 99), 0);
  EXPECT_EQ(outcome.report.value("name", ""), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Every, ShippedPlugins,
                         testing::Values("trajectory", "kinematics", "zmp", "stability", "navigation",
                                         "behaviour"),
                         [](const auto& tried) {
                           return tried.param + std::string(kForm[0] == '\0' ? "" : "_full");
                         });

}  // namespace
}  // namespace gaitway::tests
