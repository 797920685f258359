// What a calibration is for: a robot that is loaded with it knows its joints and forces, and stands upright.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <fstream>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/tilt.hpp"
#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/motion_planner.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "robots/robot_variants.hpp"
#include "tools/calibrate/calibration_report.hpp"

namespace gaitway::calibration {
namespace {

// Of a standing robot: RMS over the legs' joints; of the feet's loads; of the pelvis against the vertical,
// and against what inclinometer and joints say of it.
struct Errors {
  double joint_rad = 0.0, force_N = 0.0, tilt_rad = 0.0, told_tilt_rad = 0.0;
};

// The balance feedback takes a lean out whether the robot knows its joints or not: what is left would say
// nothing.
core::Configuration without_lean_feedback() {
  core::Configuration configuration = core::read_configuration(GAITWAY_CONFIGURATION);
  for (core::PluginEntry& plugin : configuration.plugins) {
    if (plugin.name == "stability") plugin.parameters.push_back({.name = "lean_gain", .text = "0"});
  }
  return configuration;
}

class CalibratedRobot : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  // Through the whole chain: what the message controller says of a robot that has stood for a second.
  [[nodiscard]] Errors stand() const {
    simulator::CosimulationOptions options;
    options.plant.seed = GetParam();
    options.plant.conditions.body.cell_gain_deviation = 0.03;
    options.main_controller.configuration = GAITWAY_CONFIGURATION;
    options.main_controller.plugins = without_lean_feedback();
    options.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
    const urdf::RobotModel robot = urdf::load_robot(built_.folder());
    simulator::Cosimulation run(robot, options);
    for (int i = 0; i < 1500; ++i) run.advance_millisecond();
    auto joint_reader = run.client().read<JointStates>("joint_states");
    auto imu_reader = run.client().read<Imu>("imu");
    auto force_reader = run.client().read<FootForces>("foot_forces");
    JointStates joints{};
    joint_reader.read(joints);
    Errors errors;
    for (const urdf::Leg& leg : robot.legs) {
      for (const int joint : leg.joints) {
        const auto j = static_cast<std::size_t>(joint);
        errors.joint_rad += std::pow(joints.position[j] - run.plant().positions()[7 + j], 2) / 12.0;
      }
    }
    errors.joint_rad = std::sqrt(errors.joint_rad);
    // Cells' noise is averaged away.
    constexpr int kSlots = 50;
    std::array<double, 2> off_N{};
    urdf::ForwardKinematics kinematics(robot);
    kinematics.compute({joints.position, robot.joints.size()});
    Eigen::Vector3d told_up = Eigen::Vector3d::Zero(), up = Eigen::Vector3d::Zero();  // in the pelvis
    for (int slot = 0; slot < kSlots; ++slot) {
      for (int i = 0; i < 10; ++i) run.advance_millisecond();
      FootForces forces{};
      force_reader.read(forces);
      for (std::size_t side = 0; side < 2; ++side) {
        double load_N = 0.0;
        for (const double force : forces.force[side]) load_N += force;
        off_N[side] += (load_N - run.plant().ground_contact().normal_force_N[side]) / kSlots;
      }
      Imu imu{};
      imu_reader.read(imu);
      told_up += kinematics.link_rotation(robot.imu.link) *
                 geometry::up_at_tilt(Eigen::Map<const Eigen::Vector2d>(imu.inclination));
      up += run.plant().truth().base.linear().row(2);
    }
    errors.force_N = std::hypot(off_N[0], off_N[1]);
    errors.tilt_rad = std::acos(std::min(1.0, up.normalized().z()));
    errors.told_tilt_rad = std::acos(std::min(1.0, told_up.normalized().dot(up.normalized())));
    return errors;
  }

  test::RobotVariant built_;
};

TEST_P(CalibratedRobot, KnowsItsJointsAndStandsUpright) {
  const urdf::RobotModel described = urdf::load_robot(built_.folder());
  const motion::MotionPlan poses =
      motion::plan_motion(described, motion::read_motion(GAITWAY_POSES, described), {}).plan;
  const Errors before = stand();
  const SimulatedCalibration found = calibrate_simulated(described, poses, {.seed = GetParam()});
  std::ofstream(built_.folder() / "calibration.yaml")
      << calibration_text(described, found.calibration, std::time(nullptr));
  const Errors after = stand();
  EXPECT_GT(before.joint_rad, 0.25 * facts::kRadPerDegree);
  EXPECT_LT(after.joint_rad, 0.08 * facts::kRadPerDegree);
  EXPECT_LT(after.tilt_rad, 0.5 * before.tilt_rad);
  EXPECT_LT(after.force_N, before.force_N);
  EXPECT_LT(after.told_tilt_rad, 0.1 * facts::kRadPerDegree);
  EXPECT_LT(after.told_tilt_rad, 0.3 * before.told_tilt_rad);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CalibratedRobot, ::testing::Values(1U, 2U));

}  // namespace
}  // namespace gaitway::calibration
