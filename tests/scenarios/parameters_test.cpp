// The parameters of the plug-ins that are shipped: each says what it is for, and those that may change while
// the robot walks do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "gaitway/isolation/plugin_probe.hpp"
#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

class ShippedPlugin : public testing::TestWithParam<const char*> {};

TEST_P(ShippedPlugin, SaysWhatEachParameterIsFor) {
  const auto library =
      std::filesystem::path(GAITWAY_PLUGIN_DIR) / (std::string("libgaitway_plugin_") + GetParam() + ".so");
  const core::PluginDescription plugin = core::probe_plugin(
      library,
      {.robot_directory = std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf/humanoid22", .plugin_path = {}});
  EXPECT_FALSE(plugin.parameters.empty());
  for (const core::Parameter& parameter : plugin.parameters) {
    EXPECT_GT(parameter.doc.size(), 8U) << parameter.name << ": what is it for?";
    EXPECT_TRUE(parameter.kind != core::ParameterKind::number || !parameter.unit.empty()) << parameter.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Every, ShippedPlugin,
                         testing::Values("trajectory", "kinematics", "zmp", "stability", "api"),
                         [](const auto& tried) { return std::string(tried.param); });

TEST(LiveParameters, TheDocumentedExampleWorksWhileTheRobotWalks) {
  SimulatedRun run{3};
  run.apply(walk_at(0.0, 0.2));
  while (run.time_s() < 3.0) run.cosimulation.advance_millisecond();
  std::ifstream file(std::filesystem::path(GAITWAY_SOURCE_DIR) / "docs/api_examples.json");
  const auto documented = nlohmann::json::parse(file);
  int tried = 0;
  for (const auto& example : documented) {
    if (example.at("name") != "/plugins/set_parameter") continue;
    const auto& asked = example.at("send").at("args");
    run.cosimulation.plugins().changes().set_parameter(asked.at("plugin").get<std::string>(),
                                                       asked.at("parameter").get<std::string>(),
                                                       asked.at("value").get<std::string>());
    ++tried;
  }
  EXPECT_EQ(tried, 1);
  while (run.time_s() < 6.0) run.cosimulation.advance_millisecond();
  EXPECT_FALSE(run.cosimulation.plant().fallen());
}

// A trim that may be no larger is none.
TEST(LiveParameters, AreInForceAtOnce) {
  SimulatedRun run{3};
  run.apply(walk_at(0.0, 0.2));
  while (run.time_s() < 3.0) run.cosimulation.advance_millisecond();
  run.cosimulation.plugins().changes().set_parameter("stability", "trim_limit", "0.001 rad");
  auto trims = run.cosimulation.client().read<TrimCommand>("trim");
  for (int tick = 0; tick < 20; ++tick) {
    for (int i = 0; i < 10; ++i) run.cosimulation.advance_millisecond();
    TrimCommand trim{};
    trims.read(trim);
    for (const double angle_rad : trim.angle) ASSERT_LE(std::abs(angle_rad), 0.001);
  }
}

TEST(LiveParameters, OnesThatARunningPlanRestsOnAreRefusedByName) {
  SimulatedRun run{3};
  EXPECT_THROW(run.cosimulation.plugins().changes().set_parameter("trajectory", "hip_height", "0.35 m"),
               std::runtime_error);
  run.cosimulation.plugins().changes().set_parameter("trajectory", "forward_acceleration", "0.2 m/s^2");
}

}  // namespace
}  // namespace gaitway::scenarios
