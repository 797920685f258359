// The tree pass agrees with KDL in any posture, and allocates nothing.
#include "gaitway/urdf/forward_kinematics.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <random>

#include "broken_robot.hpp"

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GAITWAY_COUNTS_ALLOCATIONS 1
namespace {
std::atomic<long> allocations{0};
}
extern "C" void* __libc_malloc(std::size_t size);  // NOLINT: glibc's own name
extern "C" void* malloc(std::size_t size) {        // NOLINT: replaces the C library's
  allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
#endif

namespace gaitway::urdf {
namespace {

RobotModel humanoid() {
  return load_robot(std::filesystem::path(GAITWAY_URDF_DIR) / "humanoid22");
}

std::vector<double> random_posture(const RobotModel& robot, std::mt19937& generator) {
  std::vector<double> position_rad;
  for (const Joint& joint : robot.joints) {
    position_rad.push_back(std::uniform_real_distribution(joint.lower_rad, joint.upper_rad)(generator));
  }
  return position_rad;
}

Eigen::Isometry3d kdl_pose(const RobotModel& robot, const std::string& link,
                           const std::vector<double>& position_rad) {
  KDL::Chain chain;
  EXPECT_TRUE(robot.tree.getChain(robot.links[0].name, link, chain));
  KDL::JntArray angles(chain.getNrOfJoints());
  for (unsigned i = 0; i < chain.getNrOfSegments(); ++i) {
    const int joint = robot.joint_index(chain.getSegment(i).getJoint().getName());
    angles(i) = position_rad[static_cast<std::size_t>(joint)];
  }
  KDL::ChainFkSolverPos_recursive solver(chain);
  KDL::Frame frame;
  EXPECT_GE(solver.JntToCart(angles, frame), 0);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      pose.linear()(row, column) = frame.M(row, column);
    }
    pose.translation()[row] = frame.p(row);
  }
  return pose;
}

// Compares links, soles and CoM with KDL's chains in 100 random postures.
void expect_agreement_with_kdl(const RobotModel& robot) {
  std::mt19937 generator(22);
  ForwardKinematics kinematics(robot);
  for (int sample = 0; sample < 100; ++sample) {
    const std::vector<double> posture = random_posture(robot, generator);
    kinematics.compute(posture);
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      const Eigen::Isometry3d expected =
          i == 0 ? Eigen::Isometry3d::Identity() : kdl_pose(robot, robot.links[i].name, posture);
      ASSERT_TRUE(kinematics.link_pose(static_cast<int>(i)).isApprox(expected, 1e-12)) << robot.links[i].name;
      moment += robot.links[i].mass_kg * (expected * robot.links[i].com_m);
    }
    ASSERT_LT((kinematics.com_m() - moment / robot.total_mass_kg()).norm(), 1e-14);
    for (const Side side : kSides) {
      const Foot& foot = robot.feet[static_cast<std::size_t>(side)];
      const Eigen::Isometry3d expected =
          kdl_pose(robot, robot.links[static_cast<std::size_t>(foot.link)].name, posture) * foot.sole;
      ASSERT_TRUE(kinematics.sole_pose(side).isApprox(expected, 1e-12));
    }
  }
}

TEST(ForwardKinematics, AgreesWithKdlInRandomPostures) {
  expect_agreement_with_kdl(humanoid());
}

TEST(ForwardKinematics, AgreesWithKdlForSlantedAndFlippedAxes) {
  test::BrokenRobot slanted;
  const auto replace = [&slanted](const std::string& joint, const std::string& before,
                                  const std::string& after) {
    slanted.replace("robot.urdf", "<joint name=\"" + joint + "\"", before, after);
  };
  replace("left_shoulder_pitch", "axis xyz=\"0 1 0\"", "axis xyz=\"0 0.6 0.8\"");
  replace("left_shoulder_pitch", "<origin xyz=\"0 0.125 0.2\"/>",
          "<origin xyz=\"0 0.125 0.2\" rpy=\"0.3 -0.2 0.1\"/>");
  replace("neck_yaw", "axis xyz=\"0 0 1\"", "axis xyz=\"0 0 -1\"");
  replace("right_shoulder_roll", "axis xyz=\"1 0 0\"", "axis xyz=\"-1 0 0\"");
  expect_agreement_with_kdl(slanted.load());
}

TEST(ForwardKinematics, StandsAtHomeAfterConstruction) {
  const RobotModel robot = humanoid();
  const ForwardKinematics kinematics(robot);
  EXPECT_NEAR(kinematics.sole_pose(Side::left).translation().z(), -0.36, 1e-6);
  EXPECT_NEAR(kinematics.sole_pose(Side::right).translation().y(), -0.05, 1e-12);
}

TEST(ForwardKinematics, AllocatesNothing) {
#ifdef GAITWAY_COUNTS_ALLOCATIONS
  const RobotModel robot = humanoid();
  ForwardKinematics kinematics(robot);
  std::mt19937 generator(1);
  const std::vector<double> posture = random_posture(robot, generator);
  const long before = allocations.load();
  kinematics.compute(posture);
  const Eigen::Isometry3d sole = kinematics.sole_pose(Side::left);
  EXPECT_EQ(allocations.load(), before);
  EXPECT_TRUE(sole.matrix().allFinite());
  EXPECT_GT(before, 0);
#else
  GTEST_SKIP() << "the sanitizer owns malloc";
#endif
}

}  // namespace
}  // namespace gaitway::urdf
