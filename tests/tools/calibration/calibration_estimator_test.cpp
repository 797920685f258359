// Finds what robots were made with, and says honestly how sure it is.
#include "tools/calibrate/calibration_estimator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/facts/facts.hpp"
#include "synthetic_stances.hpp"
#include "tools/calibrate/calibration_report.hpp"

namespace gaitway::calibration {
namespace {

using ::testing::HasSubstr;

class CalibrationEstimator : public ::testing::Test {
 protected:
  // A robot drawn from the seed, and what is found of it.
  SimulatedCalibration simulate(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    SimulatedCalibration result;
    result.settings.standing.sole_compliance_m_per_N = 0.0;
    result.settings.standing.sole_compliance_deviation_m_per_N = 1e-9;
    result.truth = stances_.draw(random, result.settings.manufacturing);
    const double mass_kg = total_mass_kg(robot_, result.truth);
    result.settings.weighing = Weighing{std::normal_distribution<double>(mass_kg, 0.01)(random), 0.01};
    result.measurements = stances_.measure(result.truth, result.settings, random);
    result.calibration = calibrate(robot_, result.measurements, result.settings);
    return result;
  }

  std::string complaint(const std::vector<StandingMeasurement>& measurements) const {
    try {
      (void)calibrate(robot_, measurements, {});
    } catch (const CalibrationError& error) {
      return error.what();
    }
    return "(calibrated without complaint)";
  }

  const urdf::RobotModel robot_ = urdf::load_robot(GAITWAY_ROBOT);
  SyntheticStances stances_{robot_, motion::read_motion(GAITWAY_POSES, robot_)};
};

TEST_F(CalibrationEstimator, claims_the_deviations_that_its_errors_have) {
  CalibrationStatistics statistics;
  double misfit = 0.0;
  constexpr int kRobots = 24;
  for (std::uint64_t seed = 1; seed <= kRobots; ++seed) {
    const SimulatedCalibration simulated = simulate(seed);
    statistics.add(robot_, simulated);
    misfit += simulated.calibration.misfit / kRobots;
  }
  for (const auto& section : statistics.sections()) {
    EXPECT_GT(section.all.error_in_deviations, 0.7) << section.title << statistics.text();
    EXPECT_LT(section.all.error_in_deviations, 1.4) << section.title << statistics.text();
  }
  EXPECT_NEAR(misfit, 1.0, 0.15);
  const auto sections = statistics.sections();
  EXPECT_LT(sections[0].all.after, 0.2 * sections[0].all.before) << statistics.text();   // zeros of the legs
  EXPECT_LT(sections[3].all.after, 0.25 * sections[3].all.before) << statistics.text();  // cells
}

TEST_F(CalibrationEstimator, says_what_the_poses_cannot_tell) {
  const SimulatedCalibration simulated = simulate(5);
  const auto zero = [&](const char* joint) {
    return simulated.calibration.zero_rad[static_cast<std::size_t>(robot_.joint_index(joint))];
  };
  EXPECT_LT(zero("left_elbow").learned(), 0.01);  // arms never move in these poses
  EXPECT_NEAR(zero("left_elbow").value, 0.0, 0.02 * facts::kRadPerDegree);
  EXPECT_GT(zero("left_hip_roll").learned(), 0.9);
  const std::string report = report_text(robot_, simulated.calibration, nullptr);
  EXPECT_THAT(report, testing::ContainsRegex("left_elbow[^\n]*the poses cannot tell"));
  EXPECT_THAT(report, testing::Not(testing::ContainsRegex("left_hip_roll[^\n]*cannot tell")));
  EXPECT_THAT(calibration_text(robot_, simulated.calibration, 0), testing::Not(HasSubstr("left_elbow")));
}

// 1.2 degrees to the right, and an accelerometer that says 0.3 degrees more.
TEST_F(CalibrationEstimator, learns_how_the_imu_sits_and_not_from_it_how_joints_stand) {
  std::mt19937_64 random(11);
  CalibrationSettings settings;
  settings.standing.sole_compliance_m_per_N = 0.0;
  RobotDeviations truth = stances_.draw(random, settings.manufacturing);
  truth.imu = {};
  truth.imu.mounting_rad.x() = 1.2 * facts::kRadPerDegree;
  truth.imu.accelerometer_zero_m_per_s2.y() = 0.3 * facts::kRadPerDegree * facts::kGravity_m_per_s2;
  const Calibration found = calibrate(robot_, stances_.measure(truth, settings, random), settings);
  EXPECT_LT(found.misfit, 1.3);
  const auto roll_deg = [&found](ImuSensor sensor) {
    return facts::kDegreePerRad * found.imu_tilt_rad[static_cast<std::size_t>(sensor)][0].value;
  };
  EXPECT_NEAR(roll_deg(ImuSensor::accelerometer), 1.5, 0.1);
  EXPECT_NEAR(roll_deg(ImuSensor::inclinometer), 1.2, 0.1);
  EXPECT_NEAR(roll_deg(ImuSensor::gyro), 1.2, 0.5) << "by what the other two say";
  for (const char* const joint : {"left_hip_roll", "right_ankle_roll", "left_ankle_pitch"}) {
    const auto j = static_cast<std::size_t>(robot_.joint_index(joint));
    EXPECT_NEAR(found.zero_rad[j].value, truth.zero_rad[j], 0.12 * facts::kRadPerDegree) << joint;
  }
}

// The pelvis leans and the waist stands still in all poses.
TEST_F(CalibrationEstimator, tells_the_sum_of_waist_and_imu_and_keeps_both) {
  const SimulatedCalibration simulated = simulate(6);
  const auto waist = static_cast<std::size_t>(robot_.joint_index("waist_pitch"));
  const Estimate& zero = simulated.calibration.zero_rad[waist];
  EXPECT_LT(zero.learned(), kToldShare);
  EXPECT_GT(zero.learned(), kHeardShare);
  const PostureError& pitch = simulated.calibration.posture.back();
  EXPECT_EQ(pitch.name, "pitch that the IMU says");
  EXPECT_GT(pitch.estimate.learned(), 0.99);
  EXPECT_THAT(report_text(robot_, simulated.calibration, nullptr),
              testing::ContainsRegex("waist_pitch[^\n]*the poses cannot tell"));
  EXPECT_THAT(calibration_text(robot_, simulated.calibration, 0), HasSubstr("waist_pitch"));
}

TEST_F(CalibrationEstimator, one_pose_alone_tells_sums_and_not_single_joints) {
  SimulatedCalibration simulated = simulate(7);
  simulated.measurements.resize(1);
  const Calibration home = calibrate(robot_, simulated.measurements, simulated.settings);
  const std::size_t knee = static_cast<std::size_t>(robot_.joint_index("left_knee"));
  EXPECT_GT(home.zero_rad[knee].deviation, 3.0 * simulated.calibration.zero_rad[knee].deviation);
  EXPECT_LT(home.trunk_com_m[2].learned(), kToldShare);  // its height shows when the trunk leans
  EXPECT_GT(simulated.calibration.trunk_com_m[2].learned(), kToldShare);
  const auto learned = [](const Calibration& calibration, const char* quantity) {
    const auto found = std::ranges::find(calibration.posture, quantity, &PostureError::name);
    return found == calibration.posture.end() ? 0.0 : found->estimate.learned();
  };
  EXPECT_GT(learned(home, "pitch that the IMU says"), 0.99);
  const char* const trunk = "trunk pitched over the left sole";
  EXPECT_GT(learned(home, trunk), 0.7) << "the rest may be how the IMU is mounted";
  EXPECT_GT(learned(simulated.calibration, trunk), learned(home, trunk));
}

TEST_F(CalibrationEstimator, an_exact_robot_has_no_deviations) {
  std::mt19937_64 random(3);
  CalibrationSettings settings;
  settings.standing.sole_compliance_m_per_N = 0.0;
  const RobotDeviations none = no_deviations(robot_);
  const Calibration found = calibrate(robot_, stances_.measure(none, settings, random), settings);
  for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
    EXPECT_NEAR(found.zero_rad[j].value, 0.0, 4.0 * found.zero_rad[j].deviation) << robot_.joints[j].name;
  }
  for (const Estimate& axis : found.trunk_com_m) EXPECT_NEAR(axis.value, 0.0, 4.0 * axis.deviation);
}

// A foot on a pebble is no flat foot: 3 mm are found.
TEST_F(CalibrationEstimator, a_foot_on_a_pebble_does_not_fit) {
  SimulatedCalibration simulated = simulate(9);
  for (std::size_t i = 0; i < simulated.measurements.size(); i += 2) {
    auto& joint_rad = simulated.measurements[i].joint_rad;
    joint_rad[static_cast<std::size_t>(robot_.legs[1].joints[3])] += 2.0 * facts::kRadPerDegree;
    joint_rad[static_cast<std::size_t>(robot_.legs[1].joints[2])] -= 1.0 * facts::kRadPerDegree;
    joint_rad[static_cast<std::size_t>(robot_.legs[1].joints[4])] -= 1.0 * facts::kRadPerDegree;
  }
  EXPECT_GT(calibrate(robot_, simulated.measurements, simulated.settings).misfit, kLargestMisfit);
}

TEST_F(CalibrationEstimator, refuses_what_cannot_be_measured) {
  EXPECT_THAT(complaint({}), HasSubstr("there are no poses"));
  std::vector<StandingMeasurement> poses = simulate(1).measurements;
  auto broken = poses;
  broken[2].joint_rad.pop_back();
  EXPECT_THAT(complaint(broken), testing::AllOf(HasSubstr("bent forward"), HasSubstr("21 joint angles")));
  broken = poses;
  broken[1].stands = {false, false};
  EXPECT_THAT(complaint(broken), testing::AllOf(HasSubstr("low"), HasSubstr("no foot stands")));
  broken = poses;
  broken[0].stands = {true, false};  // but the other one bears half of the weight
  EXPECT_THAT(complaint(broken), testing::AllOf(HasSubstr("home"), HasSubstr("the standing feet bear")));
  broken = poses;
  broken[0].force_deviation_N[1][2] = 0.0;
  EXPECT_THAT(complaint(broken), testing::AllOf(HasSubstr("home"), HasSubstr("above 0")));
}

}  // namespace
}  // namespace gaitway::calibration
