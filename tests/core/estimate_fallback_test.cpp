// The built-in estimate: from encoders and IMU, continuous with the last good one.
#include <gmock/gmock.h>

#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "plugin_fixture.hpp"

namespace gaitway::core {
namespace {

class EstimateFallbackTest : public PluginFixture {
 protected:
  EstimateFallbackTest() {
    joints.joint_count = static_cast<std::uint32_t>(robot.joints.size());
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      joints.position[joint] = robot.joints[joint].home_rad;
    }
    imu.acceleration[2] = 9.81;
    for (auto& foot : forces.force) {
      for (double& cell_N : foot) {
        cell_N = robot.total_mass_kg() * 9.81 / 8.0;
      }
    }
    PluginManagerOptions options;
    options.robot_directory = GAITWAY_TEST_ROBOT;
    options.stopped = {"zmp"};
    manager = std::make_unique<PluginManager>(
        parse_configuration("plugins:\n  - {name: zmp, library: nowhere.so}\n", "test.yaml"), options,
        client);
  }
  void roll_to(double angle_rad) {
    imu.acceleration[1] = facts::kGravity_m_per_s2 * std::sin(angle_rad);
    imu.acceleration[2] = facts::kGravity_m_per_s2 * std::cos(angle_rad);
  }
  Estimate step() {
    const Tick now = tick(next++);
    joints.stamp_ns = imu.stamp_ns = now.now_ns - 1'000'000;
    joint_writer.publish(joints, joints.stamp_ns);
    imu_writer.publish(imu, imu.stamp_ns);
    if (has_forces) {
      forces.stamp_ns = imu.stamp_ns;
      force_writer.publish(forces, forces.stamp_ns);
    }
    manager->step(now);
    Estimate estimate{};
    EXPECT_TRUE(other.read<Estimate>("estimate").read(estimate));
    return estimate;
  }

  urdf::RobotModel robot = urdf::load_robot(GAITWAY_TEST_ROBOT);
  msgclient::Writer<JointStates> joint_writer = other.write<JointStates>("joint_states");
  msgclient::Writer<Imu> imu_writer = other.write<Imu>("imu");
  msgclient::Writer<FootForces> force_writer = other.write<FootForces>("foot_forces");
  msgclient::Writer<MotionPlan> plan_writer = other.write<MotionPlan>("motion_plan");
  JointStates joints{};
  Imu imu{};
  FootForces forces{};
  bool has_forces = true;
  std::unique_ptr<PluginManager> manager;
  std::uint32_t next = 1;
};

TEST_F(EstimateFallbackTest, StandingRobotHasItsComBetweenTheFeetAndBothInContact) {
  Estimate estimate{};
  for (int i = 0; i < 100; ++i) {
    estimate = step();
  }
  EXPECT_EQ(estimate.contact[0], 1U);
  EXPECT_EQ(estimate.contact[1], 1U);
  EXPECT_NEAR(estimate.foot_force[0], robot.total_mass_kg() * 9.81 / 2.0, 1e-9);
  EXPECT_EQ(estimate.stamp_ns, joints.stamp_ns);
  EXPECT_LT(estimate.com[1], -0.02) << "right of the left foot, which it is seen from";
  EXPECT_GT(estimate.com[2], 0.3);
  EXPECT_LT(estimate.com[2], 0.6);
  EXPECT_NEAR(estimate.com_velocity[0], 0.0, 1e-9);
  EXPECT_NEAR(estimate.attitude[0], 0.0, 1e-9);
}

TEST_F(EstimateFallbackTest, AttitudeFollowsTheGyroAndThenTheAccelerometer) {
  step();
  imu.angular_velocity[0] = 0.5;
  Estimate estimate{};
  for (int i = 0; i < 10; ++i) {
    roll_to(0.005 * (i + 1));
    estimate = step();
  }
  EXPECT_NEAR(estimate.attitude[0], 0.05, 1e-3);
  EXPECT_DOUBLE_EQ(estimate.angular_velocity[0], 0.5);
  imu.angular_velocity[0] = 0.0;
  roll_to(0.1);
  for (int i = 0; i < 300; ++i) {
    estimate = step();
  }
  EXPECT_NEAR(estimate.attitude[0], 0.1, 1e-3);
  imu.angular_velocity[2] = 0.3;
  for (int i = 0; i < 100; ++i) {
    estimate = step();
  }
  EXPECT_NEAR(estimate.attitude[2], 0.3, 0.01) << "yaw is integrated";
}

TEST_F(EstimateFallbackTest, WithoutForcesThePlanSaysWhatBears) {
  has_forces = false;
  Estimate estimate = step();
  EXPECT_EQ(estimate.contact[0] + estimate.contact[1], 2U);
  const auto plan = std::make_unique<MotionPlan>();
  plan->sequence = 1;
  plan->start_ns = tick(next).now_ns;
  for (int point = 0; point < kBatchPoints; ++point) {
    plan->support[point] = point < 4 ? 0 : 1;
  }
  plan_writer.publish(*plan, 0);
  for (int i = 0; i < 4; ++i) {
    estimate = step();
    EXPECT_EQ(estimate.contact[0], 1U);
    EXPECT_EQ(estimate.contact[1], 0U);
    EXPECT_EQ(estimate.support, 0U);
  }
  estimate = step();
  EXPECT_EQ(estimate.contact[0], 0U);
  EXPECT_EQ(estimate.contact[1], 1U);
  EXPECT_EQ(estimate.support, 1U);
  EXPECT_GT(estimate.com[1], 0.02) << "left of the right foot";
}

TEST_F(EstimateFallbackTest, NothingIsWrittenFromInputsThatAreNotNumbers) {
  const Estimate before = step();
  imu.inclination[1] = std::nan("");
  EXPECT_EQ(step().stamp_ns, before.stamp_ns);
}

}  // namespace
}  // namespace gaitway::core
