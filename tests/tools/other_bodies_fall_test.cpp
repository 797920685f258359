// How hard robots fall whose folder says nothing about it: against the same robots whose joints hold still,
// as stiff as ever.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <vector>

#include "robots/robot_variants.hpp"
#include "tools/measure/gait_trial.hpp"

namespace gaitway::tools {
namespace {

// Pushed over to all sides, as hard as its size takes; of the force on the link that is hit hardest.
double median_force_N(const TrialRobot& robot) {
  constexpr int kFalls = 12;
  const facts::BodyScale scale = robot.model.body_scale();
  std::vector<double> forces_N;
  for (int fall = 0; fall < kFalls; ++fall) {
    Trial trial;
    trial.seed = static_cast<std::uint64_t>(fall + 1);
    trial.seconds = 3.0 * scale.factor("s");
    trial.push = TrialPush{0.5, 2.0 * std::numbers::pi * fall / kFalls, 7.0 * scale.factor("N*s")};
    trial.watches_fall = true;
    const TrialOutcome outcome = run_trial(robot, trial);
    EXPECT_TRUE(outcome.fell && outcome.fall && outcome.fall->impact_s) << "fall " << fall;
    if (outcome.fall) forces_N.push_back(outcome.fall->hardest_force_N);
  }
  std::ranges::nth_element(forces_N, forces_N.begin() + kFalls / 2);
  return forces_N[kFalls / 2];
}

TrialRobot robot_of(const test::RobotVariant& variant) {
  return {urdf::load_robot(variant.folder()),
          core::read_configuration(std::filesystem::path(GAITWAY_SOURCE_DIR) / "core/config/walk.yaml"),
          {GAITWAY_PLUGIN_DIR}};
}

// Until it lies.
TrialRobot holding_still(const test::RobotVariant& variant) {
  std::ofstream(variant.folder() / "fall_postures.yaml") << "ahead: {}\nback: {}\nleft: {}\n";
  TrialRobot robot = robot_of(variant);
  for (core::PluginEntry& plugin : robot.plugins.plugins) {
    if (plugin.name == "stability")
      plugin.parameters.push_back({.name = "fall_posture_softness", .text = "0"});
  }
  return robot;
}

// The folder is read when the plug-in starts: what falls by itself falls first.
TEST(FallOfAnotherBody, IsBrokenByItsArmsWhateverTheyAreCalled) {
  test::RobotVariant variant;
  variant.scale(1.4);
  variant.rename();
  const double by_itself_N = median_force_N(robot_of(variant));
  EXPECT_LT(by_itself_N, 0.6 * median_force_N(holding_still(variant)));
}

TEST(FallOfAnotherBody, WithoutArmsIsSoft) {
  test::RobotVariant variant;
  variant.remove_arms();
  const double by_itself_N = median_force_N(robot_of(variant));
  EXPECT_LT(by_itself_N, median_force_N(holding_still(variant)));
}

}  // namespace
}  // namespace gaitway::tools
