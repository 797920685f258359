// Inverse dynamics against KDL's own solver and against the momentum that differences of postures give.
#include "gaitway/motion/whole_body_dynamics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <random>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/stance_map.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "motion_fixture.hpp"

namespace gaitway::motion {
namespace {

constexpr double kGravity = facts::kGravity_m_per_s2;

BodyMotion random_motion(std::mt19937& random) {
  const urdf::RobotModel& robot = humanoid22();
  std::uniform_real_distribution<double> spread(-1.0, 1.0);
  const auto count = static_cast<Eigen::Index>(robot.joints.size());
  BodyMotion motion;
  const auto draw = [&](Eigen::Index size) {
    return Eigen::VectorXd::NullaryExpr(size, [&] { return spread(random); }).eval();
  };
  motion.joint_rad = draw(count);
  motion.speed_rad_per_s = 3.0 * draw(count);
  motion.acceleration_rad_per_s2 = 20.0 * draw(count);
  return motion;
}

TEST(WholeBodyDynamics, OfAStandingPelvisAreKdlsToTheLastDigits) {
  const urdf::RobotModel& robot = humanoid22();
  WholeBodyDynamics dynamics(robot);
  std::mt19937 random(1);
  Eigen::VectorXd torque(static_cast<Eigen::Index>(robot.joints.size()));
  for (int trial = 0; trial < 20; ++trial) {
    const BodyMotion motion = random_motion(random);
    dynamics.move(motion);
    dynamics.torques({}, torque);
    KDL::Chain chain;
    ASSERT_TRUE(robot.tree.getChain("pelvis", "left_foot", chain));
    KDL::ChainIdSolver_RNE solver(chain, KDL::Vector(0.0, 0.0, -kGravity));
    KDL::JntArray q(6), speed(6), acceleration(6), expected(6);
    for (unsigned i = 0; i < 6; ++i) {
      const Eigen::Index j = robot.legs[0].joints[i];
      q(i) = motion.joint_rad[j];
      speed(i) = motion.speed_rad_per_s[j];
      acceleration(i) = motion.acceleration_rad_per_s2[j];
    }
    ASSERT_EQ(solver.CartToJnt(q, speed, acceleration, KDL::Wrenches(chain.getNrOfSegments()), expected), 0);
    for (unsigned i = 0; i < 6; ++i) {
      const Eigen::Index j = robot.legs[0].joints[i];
      const urdf::Motor& motor = robot.joints[static_cast<std::size_t>(j)].motor;
      const double rotor = motor.armature_kg_m2 * acceleration(i) + motor.damping_Nms_per_rad * speed(i) +
                           motor.friction_Nm * std::tanh(speed(i) / 0.05);
      EXPECT_NEAR(torque[j] - rotor, expected(i), 1e-9) << robot.joints[static_cast<std::size_t>(j)].name;
    }
  }
}

TEST(WholeBodyDynamics, TheGroundsForceIsTheMomentumsChange) {
  const urdf::RobotModel& robot = humanoid22();
  WholeBodyDynamics dynamics(robot);
  urdf::ForwardKinematics kinematics(robot);
  std::mt19937 random(2);
  for (int trial = 0; trial < 10; ++trial) {
    BodyMotion motion = random_motion(random);
    motion.angular_velocity_rad_per_s = {0.5, -1.0, 0.8};
    motion.acceleration_m_per_s2 = {1.0, -2.0, 3.0};
    const Wrench ground = dynamics.move(motion);
    // The CoM at three instants around; the pelvis turns at a constant speed and starts from rest.
    constexpr double kStep_s = 1e-3;
    std::array<Eigen::Vector3d, 3> com;
    for (std::size_t i = 0; i < 3; ++i) {
      const double t = (static_cast<double>(i) - 1.0) * kStep_s;
      const Eigen::VectorXd q =
          motion.joint_rad + t * motion.speed_rad_per_s + 0.5 * t * t * motion.acceleration_rad_per_s2;
      kinematics.compute({q.data(), static_cast<std::size_t>(q.size())});
      const Eigen::Vector3d w = motion.angular_velocity_rad_per_s;
      com[i] = 0.5 * t * t * motion.acceleration_m_per_s2 +
               Eigen::AngleAxisd(w.norm() * t, w.normalized()) * kinematics.com_m();
    }
    const Eigen::Vector3d expected =
        robot.total_mass_kg() *
        ((com[2] - 2.0 * com[1] + com[0]) / (kStep_s * kStep_s) + Eigen::Vector3d(0.0, 0.0, kGravity));
    EXPECT_LT((ground.force_N - expected).norm(), 2e-3 * expected.norm());
  }
}

TEST(WholeBodyDynamics, WhatTheFeetShareIsTheLegsAffairAlone) {
  const urdf::RobotModel& robot = humanoid22();
  WholeBodyDynamics dynamics(robot);
  std::mt19937 random(3);
  const BodyMotion motion = random_motion(random);
  const Wrench ground = dynamics.move(motion);
  Eigen::VectorXd left(static_cast<Eigen::Index>(robot.joints.size())), shared = left;
  dynamics.torques({ground, Wrench{}}, left);
  const Wrench half{0.5 * ground.force_N, 0.5 * ground.moment_Nm};
  dynamics.torques({half, half}, shared);
  // What the feet do changes the legs' torques, and those of nothing else.
  const StanceMap map(robot);
  for (const int joint : map.other_joints()) EXPECT_EQ(left[joint], shared[joint]);
  EXPECT_GT(std::abs(left[robot.legs[0].joints[2]] - shared[robot.legs[0].joints[2]]), 0.1);
}

}  // namespace
}  // namespace gaitway::motion
