// The simulated robot takes the shipped poses through its servos, contacts and sensors: what is found is
// true, and what is claimed of it is, too.
#include "tools/calibrate/simulated_calibration.hpp"

#include <gtest/gtest.h>

#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/motion_planner.hpp"
#include "tools/calibrate/calibration_report.hpp"

namespace gaitway::calibration {
namespace {

constexpr bool kMany = GAITWAY_CALIBRATED_ROBOTS >= 20;  // so many that their RMS can be held to be near 1

struct Parts {
  const char* name;
  double deviation;
  urdf::Inclinometer inclinometer;
};

class SimulatedCalibrationTest : public ::testing::TestWithParam<Parts> {
 protected:
  SimulatedCalibrationTest() : robot_(urdf::load_robot(GAITWAY_ROBOT)) {
    robot_.parts_deviation = GetParam().deviation;
    robot_.imu.inclinometer = GetParam().inclinometer;
  }

  urdf::RobotModel robot_;
  const motion::Motion motion_ = motion::read_motion(GAITWAY_POSES, robot_);
};

TEST_P(SimulatedCalibrationTest, finds_most_of_what_robots_were_made_with) {
  const motion::MotionPlan poses = motion::plan_motion(robot_, motion_, {}).plan;
  CalibrationStatistics statistics;
  for (std::uint64_t seed = 1; seed <= GAITWAY_CALIBRATED_ROBOTS; ++seed) {
    const SimulatedCalibration simulated = calibrate_simulated(robot_, poses, {.seed = seed});
    EXPECT_LT(simulated.calibration.misfit, kLargestMisfit);
    EXPECT_EQ(simulated.measurements.size(), 10U);
    statistics.add(robot_, simulated);
  }
  const auto sections = statistics.sections();
  const auto& zeros = sections[0].all;
  EXPECT_LT(zeros.after, 0.07) << statistics.text();  // deg
  EXPECT_GT(zeros.before, 0.3);
  EXPECT_LT(sections[2].rows[0].after, 0.2 * sections[2].rows[0].before) << statistics.text();
  EXPECT_LT(sections[3].all.after, 0.25 * sections[3].all.before) << statistics.text();
  for (const auto& section : sections) {
    EXPECT_GT(section.all.error_in_deviations, kMany ? 0.7 : 0.5) << section.title << statistics.text();
    EXPECT_LT(section.all.error_in_deviations, kMany ? 1.4 : 1.6) << section.title << statistics.text();
  }
}

TEST_P(SimulatedCalibrationTest, says_in_which_pose_a_robot_falls) {
  // Leans so far that no robot stands: the plan is shifted by what no plan would allow.
  motion::MotionPlan poses = motion::plan_motion(robot_, motion_, {}).plan;
  const auto ankle = static_cast<std::size_t>(robot_.joint_index("left_ankle_pitch"));
  const auto other = static_cast<std::size_t>(robot_.joint_index("right_ankle_pitch"));
  for (std::size_t point = 0; point < poses.point_count(); ++point) {
    poses.reference_rad[point * poses.joint_count + ankle] += 0.4;
    poses.reference_rad[point * poses.joint_count + other] += 0.4;
  }
  try {
    (void)calibrate_simulated(robot_, poses, {.seed = 1});
    FAIL() << "it stood";
  } catch (const PerformanceError& error) {
    EXPECT_NE(std::string(error.what()).find("'home'"), std::string::npos) << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, SimulatedCalibrationTest,
                         ::testing::Values(Parts{"as_described", 0.0, urdf::Inclinometer::fused},
                                           Parts{"as_real_ones_are", 1.0, urdf::Inclinometer::pendulum}),
                         [](const ::testing::TestParamInfo<Parts>& tested) {
                           return std::string(tested.param.name);
                         });

}  // namespace
}  // namespace gaitway::calibration
