// How exactly the eyes see by the measure that people have, of robots with deviations of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numeric>

#include "tools/measure/vision_trial.hpp"

namespace gaitway::tools {
namespace {

double root_mean_square_mm(const std::vector<double>& errors_m) {
  const double sum = std::inner_product(errors_m.begin(), errors_m.end(), errors_m.begin(), 0.0);
  return 1e3 * std::sqrt(sum / static_cast<double>(errors_m.size()));
}

VisionOutcome outcome_of(std::uint64_t seed, double range_m, bool walks) {
  const std::filesystem::path source = GAITWAY_SOURCE_DIR;
  static const VisionRobot robot{urdf::load_robot(source / "urdf/humanoid22"),
                                 core::read_configuration(source / "core/config/eyes.yaml")};
  return run_vision_trial(robot, {.range_m = range_m, .walks = walks, .seed = seed});
}

// One side of that box is seen so aslant that what it shows is no face.
TEST(VisionAccuracy, AStandingRobotKnowsToTwoCentimetresWhereABoxIs) {
  for (const std::uint64_t seed : {2U, 3U}) {
    const VisionOutcome outcome = outcome_of(seed, 1.0, false);
    EXPECT_GT(outcome.pairs, 20);
    EXPECT_EQ(outcome.without_obstacle, 0);
    EXPECT_LT(root_mean_square_mm(outcome.obstacle_error_m), 20.0) << seed;
  }
}

TEST(VisionAccuracy, AWalkingRobotToThree) {
  EXPECT_LT(root_mean_square_mm(outcome_of(2, 1.0, true).obstacle_error_m), 30.0);
}

// That robot's lenses are off by as much as a calibration leaves: far ground looks bent.
TEST(VisionAccuracy, NothingIsToldWhereNothingIs) {
  EXPECT_EQ(outcome_of(5, 1.0, false).phantoms, 0);
}

}  // namespace
}  // namespace gaitway::tools
