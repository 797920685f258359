// The simulated robot's links stop each other, but for neighbours and what touches at home.
#include "gaitway/simulator/self_collision.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "gaitway/urdf/forward_kinematics.hpp"
#include "robots/mesh_files.hpp"
#include "world_fixture.hpp"

namespace gaitway::simulator {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class SelfCollisionTest : public WorldTest {
 protected:
  [[nodiscard]] urdf::Link& link_of(urdf::RobotModel& robot, const std::string& name) const {
    return robot.links[static_cast<std::size_t>(link(name))];
  }
  [[nodiscard]] LinkPair pair(const std::string& one, const std::string& other) const {
    return {std::min(link(one), link(other)), std::max(link(one), link(other))};
  }
  [[nodiscard]] urdf::RobotModel legs_turned_in(double by_rad) const {
    urdf::RobotModel robot = model_;
    robot.joints[static_cast<std::size_t>(robot.joint_index("left_hip_roll"))].home_rad -= by_rad;
    robot.joints[static_cast<std::size_t>(robot.joint_index("right_hip_roll"))].home_rad += by_rad;
    return robot;
  }
  // A ball that belongs to `link` and lies, at home, in the middle of the other's first shape.
  [[nodiscard]] urdf::RobotModel with_ball(const std::string& link, const std::string& in) const {
    urdf::RobotModel robot = model_;
    const urdf::ForwardKinematics home(robot);
    urdf::Shape ball{.kind = urdf::Shape::Kind::sphere, .size_m = Eigen::Vector3d::Constant(0.02)};
    ball.pose = home.link_pose(this->link(link)).inverse() * home.link_pose(this->link(in)) *
                link_of(robot, in).collision.front().pose;
    link_of(robot, link).collision.push_back(ball);
    return robot;
  }
  // It stands as one does whose links leave each other alone.
  void expect_stands(const urdf::RobotModel& robot) const {
    Plant plant(robot, exact_);
    HomeServo servo(robot);
    for (int ms = 0; ms < 1000; ++ms) {
      servo.hold(plant, 1);
      ASSERT_THAT(plant.body_contacts(), IsEmpty()) << ms << " ms";
    }
    EXPECT_FALSE(plant.fallen());
    EXPECT_LT(plant.truth().trunk_tilt_rad, 0.01);
    for (const Eigen::Isometry3d& sole : plant.ground_contact().sole) {
      EXPECT_NEAR(sole.translation().z(), 0.0, 0.001);
    }
  }
  // In the air; tells the least distance between the middles of the soles.
  double throw_legs_together(const PlantOptions& options) {
    const urdf::RobotModel goal = legs_turned_in(0.5);
    Plant plant(model_, options);
    HomeServo stand(model_), close(goal);
    throw_up(plant, model_);
    stand.hold(plant, 100);
    double nearest_m = 1.0;
    for (int ms = 0; ms < 600; ++ms) {
      close.hold(plant, 1);
      const GroundContact& ground = plant.ground_contact();
      const Eigen::Vector3d between = ground.sole[0].translation() - ground.sole[1].translation();
      nearest_m = std::min(nearest_m, between.norm());
      EXPECT_EQ(ground.normal_force_N[0] + ground.normal_force_N[1] + ground.body_force_N, 0.0);
      for (const BodyContact& contact : plant.body_contacts()) contacts_.push_back(contact);
    }
    return nearest_m;
  }

  PlantOptions exact_{.mismatch = 0.0, .sensor_noise = false};
  std::vector<BodyContact> contacts_;
};

TEST_F(SelfCollisionTest, FeetThatAreDrivenIntoEachOtherStopAndAreTold) {
  PlantOptions with_play = exact_, in_a_world = options("{}\n");
  with_play.conditions.body.backlash_rad = 0.0035;
  for (const PlantOptions& options : {exact_, with_play, in_a_world}) {
    contacts_.clear();
    const double width_m = model_.feet[0].size_m.y();
    EXPECT_NEAR(throw_legs_together(options), width_m, 0.01);
    double hardest_N = 0.0;
    for (const BodyContact& contact : contacts_) {
      ASSERT_TRUE(contact.is_within_robot());
      EXPECT_LT(contact.link, contact.other_link);
      EXPECT_EQ(contact.solid, BodyContact::kFloor);
      const bool feet = LinkPair{contact.link, contact.other_link} == pair("left_foot", "right_foot");
      if (feet) hardest_N = std::max(hardest_N, contact.force_N);
    }
    EXPECT_GT(hardest_N, 5.0);
  }
}

TEST_F(SelfCollisionTest, NeighboursPassThroughEachOther) {
  EXPECT_EQ(joints_between(model_, pair("trunk", "left_forearm")), 3);
  expect_stands(with_ball("left_forearm", "trunk"));
  EXPECT_THAT(links_touching_at_home(with_ball("left_forearm", "trunk")), IsEmpty());
}

TEST_F(SelfCollisionTest, CountsTheJointsOverTheCommonLink) {
  EXPECT_EQ(joints_between(model_, {0, 0}), 0);
  EXPECT_EQ(joints_between(model_, pair("pelvis", "left_foot")), 6);
  EXPECT_EQ(joints_between(model_, pair("left_foot", "right_foot")), 12);
  EXPECT_EQ(joints_between(model_, pair("left_thigh", "trunk")), 5);
  const std::vector<LinkPair> neighbours = neighbouring_links(model_);
  EXPECT_THAT(neighbours, testing::Contains(pair("left_shin", "left_foot")));
  EXPECT_THAT(neighbours, testing::Not(testing::Contains(pair("pelvis", "left_shin"))));
}

TEST_F(SelfCollisionTest, TheShippedRobotHasNothingThatTouchesAtHome) {
  EXPECT_THAT(links_touching_at_home(model_), IsEmpty());
}

TEST_F(SelfCollisionTest, WhatTouchesAtHomeIsLeftOutAndStands) {
  const urdf::RobotModel robot = with_ball("left_forearm", "left_shin");
  EXPECT_THAT(links_touching_at_home(robot), ElementsAre(pair("left_shin", "left_forearm")));
  expect_stands(robot);
}

// Shapes from files, too, lie where they did when the model is compiled again without a pair.
TEST_F(SelfCollisionTest, MeshesBearARobotThatOverlapsAtHome) {
  urdf::RobotModel robot = with_ball("left_forearm", "left_shin");
  const std::filesystem::path file = file_.string() + ".stl";
  const std::array<float, 3> centre{0.003F, 0.002F, 0.001F};
  gaitway::test::write_file(
      file, gaitway::test::stl_bytes(gaitway::test::box_triangles({0.135F, 0.085F, 0.01F}, centre)));
  for (const urdf::Foot& foot : robot.feet) {
    urdf::Shape& shape = robot.links[static_cast<std::size_t>(foot.link)].collision.front();
    shape.kind = urdf::Shape::Kind::mesh;
    shape.mesh = {.file = file, .centre_m = {0.003, 0.002, 0.001}};
  }
  expect_stands(robot);
  std::filesystem::remove(file);
}

TEST_F(SelfCollisionTest, FacesThatLieFlushAtHomeTouch) {
  urdf::RobotModel robot = model_;
  const urdf::ForwardKinematics home(robot);
  const auto y_m = [&](const char* name) { return home.link_pose(link(name)).translation().y(); };
  const double gap_m = y_m("left_foot") - y_m("right_foot");
  for (const char* foot : {"left_foot", "right_foot"})
    link_of(robot, foot).collision.front().size_m.y() = gap_m;
  EXPECT_THAT(links_touching_at_home(robot), testing::Contains(pair("left_foot", "right_foot")));
  expect_stands(robot);
}

// Only what is in the way of the robot is no room.
TEST_F(SelfCollisionTest, ARobotThatBeginsInItselfIsNotRefused) {
  PlantOptions options = this->options("{}\n");
  const urdf::RobotModel start = legs_turned_in(0.15);
  for (const urdf::Joint& joint : start.joints) options.start_rad.push_back(joint.home_rad);
  EXPECT_NO_THROW(Plant(model_, options));
}

}  // namespace
}  // namespace gaitway::simulator
