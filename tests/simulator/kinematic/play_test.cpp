// Limits that are broken on purpose are found where they are broken, and nowhere else.
#include "gaitway/kinematic/play.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "hand_made_robot.hpp"

namespace gaitway::kinematic {
namespace {

using test::angle;
using test::at_home;
using test::humanoid22;
using test::of_rule;

std::size_t joint(const char* name) {
  return static_cast<std::size_t>(humanoid22().joint_index(name));
}

TEST(Play, StandingAtHomeBreaksNothing) {
  const Course course = play(humanoid22(), at_home(humanoid22(), 50), {});
  EXPECT_TRUE(course.findings.empty()) << describe(course.findings.at(0));
  ASSERT_EQ(course.stands.size(), 2U);
  EXPECT_DOUBLE_EQ(course.stands[0].to_s, 0.49);
  const ZmpCourse& zmp = course.of(ZmpSource::all_masses);
  EXPECT_EQ(zmp.rows, 50U);
  EXPECT_LT((zmp.at_m[25] - course.com_m[25].head<2>()).norm(), 1e-9) << "at rest it is below the CoM";
  EXPECT_GT(zmp.least_margin_m, 0.02);
}

TEST(Play, AnAngleBeyondItsStopIsFoundAtItsInstant) {
  Trajectory trajectory = at_home(humanoid22(), 200);
  const urdf::Joint& neck = humanoid22().joints[joint("neck_yaw")];
  for (std::size_t row = 0; row < 200; ++row) {
    const double share = std::sin(M_PI * static_cast<double>(row) / 199.0);
    angle(trajectory, row, joint("neck_yaw")) = share * (neck.upper_rad + 0.02);
  }
  const auto found = of_rule(play(humanoid22(), trajectory, {}).findings, Rule::position);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "neck_yaw");
  EXPECT_NEAR(found[0].at_s, 0.995, 0.006);
  EXPECT_NEAR(found[0].value, neck.upper_rad + 0.02, 1e-4);
  EXPECT_DOUBLE_EQ(found[0].limit, neck.upper_rad);
  std::size_t first = 0;
  while (angle(trajectory, first, joint("neck_yaw")) <= neck.upper_rad) ++first;
  EXPECT_DOUBLE_EQ(found[0].from_s, 0.01 * static_cast<double>(first));
}

TEST(Play, AJumpIsFoundAsSpeedAndAsAStepOfTheWire) {
  Trajectory trajectory = at_home(humanoid22(), 100);
  const urdf::Joint& elbow = humanoid22().joints[joint("left_elbow")];
  const int counts = 128;
  for (std::size_t row = 60; row < 100; ++row)
    angle(trajectory, row, joint("left_elbow")) -= counts * elbow.count_rad;
  trajectory.points_of_wire = true;
  const Course course = play(humanoid22(), trajectory, {});
  const auto steps = of_rule(course.findings, Rule::count_step);
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_EQ(steps[0].what, "left_elbow");
  EXPECT_DOUBLE_EQ(steps[0].at_s, 0.60);
  EXPECT_DOUBLE_EQ(steps[0].from_s, steps[0].to_s);
  EXPECT_EQ(steps[0].value, counts);
  EXPECT_EQ(steps[0].limit, 127);
  const auto speeds = of_rule(course.findings, Rule::speed);
  ASSERT_EQ(speeds.size(), 1U);
  EXPECT_DOUBLE_EQ(speeds[0].at_s, 0.60);
  EXPECT_NEAR(speeds[0].value, counts * elbow.count_rad / 0.01, 1e-9);
  EXPECT_EQ(course.joints[joint("left_elbow")].largest_step_counts, counts);

  trajectory.points_of_wire = false;
  EXPECT_TRUE(of_rule(play(humanoid22(), trajectory, {}).findings, Rule::count_step).empty());
}

TEST(Play, OfReferencesThatDifferFromTheJointsBothAreHeldToTheStops) {
  Trajectory trajectory = at_home(humanoid22(), 50);
  trajectory.reference_rad = trajectory.joint_rad;
  const urdf::Joint& knee = humanoid22().joints[joint("right_knee")];
  trajectory.reference_rad[20 * trajectory.joint_count + joint("right_knee")] = knee.lower_rad - 0.01;
  const auto found = of_rule(play(humanoid22(), trajectory, {}).findings, Rule::position);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].what, "right_knee");
  EXPECT_DOUBLE_EQ(found[0].at_s, 0.20);
}

TEST(Play, ASoleInTheFloorAndOneThatSlidesAreFound) {
  const urdf::RobotModel& robot = humanoid22();
  const Course still = play(robot, at_home(robot, 60), {});
  Trajectory trajectory = at_home(robot, 60);
  trajectory.base = still.base;
  trajectory.contact.assign(60, motion::Contact::both);
  for (std::size_t row = 20; row < 30; ++row) trajectory.base[row].translation().z() -= 0.004;
  for (std::size_t row = 40; row < 60; ++row) trajectory.base[row].translation().x() += 0.02;
  const Course course = play(robot, trajectory, {});
  const auto deep = of_rule(course.findings, Rule::sole_in_floor);
  ASSERT_EQ(deep.size(), 2U);
  EXPECT_DOUBLE_EQ(deep[0].from_s, 0.20);
  EXPECT_DOUBLE_EQ(deep[0].to_s, 0.29);
  EXPECT_NEAR(deep[0].value, 4.0, 1e-6);
  const auto slides = of_rule(course.findings, Rule::sole_slides);
  ASSERT_EQ(slides.size(), 2U);
  EXPECT_DOUBLE_EQ(slides[0].from_s, 0.40);
  EXPECT_NEAR(slides[0].value, 20.0, 1e-6);
}

TEST(Play, WhatTheRobotIsNotSureOfIsAllowedAndWhatLeadsIsNotJudged) {
  const urdf::RobotModel& robot = humanoid22();
  Trajectory trajectory = at_home(robot, 60);
  trajectory.base = play(robot, trajectory, {}).base;
  trajectory.contact.assign(60, motion::Contact::both);
  for (std::size_t row = 20; row < 60; ++row)
    trajectory.base[row].translation() += Eigen::Vector3d(0.02, 0.0, -0.004);
  Checks soles;
  soles.joints = soles.self_collision = soles.zmp = false;
  EXPECT_EQ(play(robot, trajectory, soles).findings.size(), 4U);
  trajectory.place_error_m = 0.0016;
  EXPECT_EQ(play(robot, trajectory, soles).findings.size(), 2U) << "4 mm deep of 3 mm, 20 mm away of 5 mm";
  trajectory.place_error_m = 0.016;
  EXPECT_TRUE(play(robot, trajectory, soles).findings.empty());
  trajectory.place_error_m = 0.0;
  trajectory.leads_joints = true;
  EXPECT_TRUE(play(robot, trajectory, {}).findings.size() ==
              of_rule(play(robot, trajectory, {}).findings, Rule::torque).size());
}

TEST(Play, ALiftedFootStandsNoMore) {
  Trajectory trajectory = at_home(humanoid22(), 100);
  for (std::size_t row = 30; row < 70; ++row) {
    const double lift = 0.3 * std::sin(M_PI * static_cast<double>(row - 30) / 40.0);
    angle(trajectory, row, joint("right_hip_pitch")) -= lift;
    angle(trajectory, row, joint("right_knee")) += 2.0 * lift;
    angle(trajectory, row, joint("right_ankle_pitch")) -= lift;
  }
  const Course course = play(humanoid22(), trajectory, {});
  EXPECT_EQ(course.contact[0], motion::Contact::both);
  EXPECT_EQ(course.contact[50], motion::Contact::left);
  EXPECT_EQ(course.contact[99], motion::Contact::both);
  EXPECT_EQ(course.stands.size(), 3U) << "the left one once, the right one twice";
}

TEST(Play, RefusesWhatDoesNotFitTheRobot) {
  const auto refused = [](const Trajectory& trajectory) {
    try {
      (void)play(humanoid22(), trajectory, {});
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("taken");
  };
  Trajectory trajectory = at_home(humanoid22(), 10);
  trajectory.joint_count = 11;
  EXPECT_EQ(refused(trajectory),
            "test: joints = 11: must be the 22 of the robot 'humanoid22'. Give its own --robot");
  EXPECT_THAT(refused(at_home(humanoid22(), 2)), ::testing::HasSubstr("rows = 2: must be at least 3"));
  trajectory = at_home(humanoid22(), 10);
  angle(trajectory, 3, 0) = std::nan("");
  EXPECT_THAT(refused(trajectory), ::testing::HasSubstr("an angle is not finite"));
  trajectory = at_home(humanoid22(), 10);
  trajectory.contact.assign(9, motion::Contact::both);
  EXPECT_THAT(refused(trajectory), ::testing::HasSubstr("not equally long"));
}

TEST(Compare, TellsRmsAndWhereTheyAreFurthestApart) {
  const Trajectory one = at_home(humanoid22(), 100);
  Trajectory other = at_home(humanoid22(), 80);
  other.start_s = 7.0;
  angle(other, 30, 4) += 0.5;
  const auto differences = compare(one, other);
  EXPECT_DOUBLE_EQ(differences[4].largest_rad, 0.5);
  EXPECT_DOUBLE_EQ(differences[4].largest_at_s, 0.30) << "on the first one's clock";
  EXPECT_NEAR(differences[4].rms_rad, 0.5 / std::sqrt(80.0), 1e-12);
  EXPECT_EQ(differences[5].largest_rad, 0.0);
}

}  // namespace
}  // namespace gaitway::kinematic
