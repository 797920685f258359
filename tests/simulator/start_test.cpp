// A robot that does not begin in its home posture.
#include <gmock/gmock.h>

#include <cmath>

#include "world_fixture.hpp"

namespace gaitway::simulator {
namespace {

using testing::HasSubstr;

std::vector<double> crouched(const urdf::RobotModel& robot, double by_rad) {
  std::vector<double> joints;
  for (const urdf::Joint& joint : robot.joints) {
    const double share = joint.name.ends_with("knee")          ? 1.0
                         : joint.name.ends_with("hip_pitch")   ? -0.5
                         : joint.name.ends_with("ankle_pitch") ? -0.5
                                                               : 0.0;
    joints.push_back(joint.home_rad + share * by_rad);
  }
  return joints;
}

TEST_F(WorldTest, BeginsInThePostureThatIsAsked) {
  PlantOptions options{.mismatch = 0.0, .sensor_noise = false};
  options.start_rad = crouched(model_, 0.5);
  const Plant robot(model_, options), upright(model_, PlantOptions{.mismatch = 0.0});
  EXPECT_LT(robot.truth().base.translation().z(), upright.truth().base.translation().z() - 0.02);
  for (const Eigen::Isometry3d& sole : robot.ground_contact().sole) {
    EXPECT_NEAR(sole.translation().z(), 0.0, 1e-6);
    EXPECT_NEAR(sole.linear()(2, 2), 1.0, 1e-9);
  }
}

// A bent ankle leans the body, not the sole.
TEST_F(WorldTest, BeginsOnTheSoleThatIsLower) {
  PlantOptions options{.mismatch = 0.0, .sensor_noise = false};
  for (const urdf::Joint& joint : model_.joints) {
    const bool leans = joint.name == "left_ankle_pitch" || joint.name == "right_ankle_pitch";
    options.start_rad.push_back(joint.home_rad + (leans ? 0.1 : 0.0) +
                                (joint.name == "right_knee" ? 0.4 : 0.0));
  }
  const Plant robot(model_, options);
  EXPECT_NEAR(robot.ground_contact().sole[0].linear()(2, 2), 1.0, 1e-9);
  EXPECT_NEAR(robot.ground_contact().sole[0].translation().z(), 0.0, 1e-9);
  EXPECT_GT(robot.ground_contact().sole[1].translation().z(), 0.0);
  EXPECT_NEAR(robot.truth().trunk_tilt_rad, 0.1, 0.02);
}

// Joints that are measured with errors put one sole askew: its lower edge bears, and nothing is in the floor.
TEST_F(WorldTest, ASoleThatIsAskewBeginsOnItsEdge) {
  PlantOptions options = this->options("floor: {friction: 0.8}\n");
  for (const urdf::Joint& joint : model_.joints) {
    options.start_rad.push_back(joint.home_rad + (joint.name == "right_ankle_roll" ? 0.05 : 0.0));
  }
  const Plant robot(model_, options);
  double lowest_m = 1.0;
  for (std::size_t side = 0; side < 2; ++side) {
    for (const Eigen::Vector2d& corner : model_.feet[side].corners_m()) {
      const Eigen::Vector3d point(corner.x(), corner.y(), 0.0);
      lowest_m = std::min(lowest_m, (robot.ground_contact().sole[side] * point).z());
    }
  }
  EXPECT_NEAR(lowest_m, 0.0, 1e-6);
}

TEST_F(WorldTest, AStartThatNoRobotCanHaveIsRefused) {
  const auto refusal = [this](const std::vector<double>& start_rad) {
    PlantOptions options;
    options.start_rad = start_rad;
    try {
      const Plant robot(model_, options);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("not refused");
  };
  EXPECT_THAT(refusal({0.0, 0.1}), HasSubstr("has 22 joints, not 2"));
  std::vector<double> start = crouched(model_, 0.1);
  start[static_cast<std::size_t>(model_.joint_index("left_knee"))] = -1.5;
  EXPECT_THAT(refusal(start), HasSubstr("left_knee begins at -1.5"));
  start[0] = std::nan("");
  EXPECT_THAT(refusal(start), HasSubstr(model_.joints[0].name + " begins at nan"));
}

}  // namespace
}  // namespace gaitway::simulator
