// Messages of the robot API as a twin reads them, and whether a robot's API and description are the right
// ones.
#include "tools/twin/robot_news.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/twin/compatibility.hpp"
#include "tools/twin/measured_pose.hpp"

#include "twin_robot.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

json stamped(double stamp_s, json fields) {
  fields["header"] = {
      {"frame_id", ""},
      {"stamp",
       {{"sec", std::floor(stamp_s)}, {"nanosec", std::round((stamp_s - std::floor(stamp_s)) * 1e9)}}}};
  return fields;
}

json joint_states(double offset_rad) {
  json names = json::array(), positions = json::array();
  // In another order than the model's, as ROS lets a robot tell them.
  for (auto joint = twin_robot().joints.rbegin(); joint != twin_robot().joints.rend(); ++joint) {
    names.push_back(joint->name);
    positions.push_back(joint->home_rad + offset_rad);
  }
  return stamped(12.5, {{"name", names}, {"position", positions}});
}

TEST(RobotReader, JointsAreInTheModelsOrder) {
  RobotReader reader(twin_robot());
  RobotNews news;
  json message = joint_states(0.1);
  message["position"][0] = nullptr;  // the model's last one
  const auto point = reader.take("/joint_states", message, news);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->what, Measurement::joints);
  EXPECT_DOUBLE_EQ(point->stamp_s, 12.5);
  EXPECT_DOUBLE_EQ(point->values[0], twin_robot().joints[0].home_rad + 0.1);
  EXPECT_TRUE(std::isnan(point->values.back()));
}

TEST(RobotReader, AttitudeIsRollAndPitchWhereItIsKnown) {
  RobotReader reader(twin_robot());
  RobotNews news;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.2, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(-0.2, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()));
  json message =
      stamped(1.0, {{"orientation", {{"x", turn.x()}, {"y", turn.y()}, {"z", turn.z()}, {"w", turn.w()}}},
                    {"orientation_covariance", {0.0}}});
  const auto point = reader.take("/imu/data", message, news);
  EXPECT_NEAR(point->values[0], 0.3, 1e-12);
  EXPECT_NEAR(point->values[1], -0.2, 1e-12);
  message["orientation_covariance"][0] = -1.0;
  EXPECT_TRUE(std::isnan(reader.take("/imu/data", message, news)->values[0]));
}

TEST(RobotReader, NewsAreKeptAndStrangersRefused) {
  RobotReader reader(twin_robot());
  RobotNews news;
  EXPECT_FALSE(reader.take("/robot_state", {{"state", "walks"}}, news));
  EXPECT_FALSE(reader.take("/commander", {{"data", "anna"}}, news));
  EXPECT_FALSE(reader.take("/walk/command",
                           {{"twist", {{"linear", {{"x", 0.1}, {"y", -0.2}}}, {"angular", {{"z", 0.3}}}}}},
                           news));
  EXPECT_EQ(news.activity, "walks");
  EXPECT_EQ(news.commander, "anna");
  EXPECT_EQ(news.walk, (std::array{0.1, -0.2, 0.3}));
  EXPECT_FALSE(reader.take("/of/a/newer/release", {{"data", 1}}, news));
  EXPECT_THROW(static_cast<void>(reader.take("/robot_state", {{"condition", "walks"}}, news)),
               json::exception);
  EXPECT_THROW(static_cast<void>(reader.take("/joint_states", {{"name", 3}}, news)), json::exception);
}

// The base is where the feet are that the robot's navigation knows the place of.
TEST(MeasuredPose, StandsWhereItsNavigationSays) {
  MeasuredPose pose(twin_robot());
  EXPECT_FALSE(pose.base());
  std::vector<double> joints;
  for (const urdf::Joint& joint : twin_robot().joints) joints.push_back(joint.home_rad);
  urdf::ForwardKinematics kinematics(twin_robot());
  const double height_m = -kinematics.sole_pose(urdf::Side::left).translation().z();
  pose.take({Measurement::joints, 0.0, joints});
  pose.take({Measurement::odometry, 0.0, {0.5, 0.0, height_m, 0.0, 0.0, std::sin(0.2), std::cos(0.2)}});
  ASSERT_TRUE(pose.base());
  EXPECT_NEAR(pose.base()->translation().x(), 0.5, 1e-9) << "no map: it begins where odometry does";
  pose.take({Measurement::place, 0.0, {2.0, -1.0, 1.5}});
  const Eigen::Isometry3d base = *pose.base();
  const Eigen::Vector3d middle = (base * kinematics.sole_pose(urdf::Side::left).translation() +
                                  base * kinematics.sole_pose(urdf::Side::right).translation()) /
                                 2.0;
  EXPECT_NEAR(middle.x(), 2.0, 1e-9);
  EXPECT_NEAR(middle.y(), -1.0, 1e-9);
  EXPECT_NEAR(middle.z(), 0.0, 1e-9);
  EXPECT_NEAR(std::atan2(base.linear()(1, 0), base.linear()(0, 0)), 1.5, 1e-9);
  pose.take({Measurement::odometry, 0.1, {std::nan(""), 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}});
  EXPECT_FALSE(pose.base()) << "what was is not what is";
}

TEST(Compatibility, ReleasesOfOneMinorNumberFit) {
  EXPECT_EQ(release_difference("gaitway/0.1.0", "0.1.7"), "");
  EXPECT_THAT(release_difference("gaitway/0.2.0", "0.1.0"),
              AllOf(HasSubstr("release 0.2.0"), HasSubstr("this is 0.1.0")));
  EXPECT_THAT(release_difference("gaitway/1.1.0", "0.1.0"), HasSubstr("release 1.1.0"));
  EXPECT_THAT(release_difference("gaitway", "0.1.0"), HasSubstr("a release before 0.1.0"));
  EXPECT_THAT(release_difference("nginx\x1b[2J", "0.1.0"),
              AllOf(HasSubstr("no robot API"), HasSubstr("\\x1B")));
  EXPECT_THAT(release_difference("", "0.1.0"), HasSubstr("no robot API"));
}

TEST(Compatibility, DescriptionsDifferByALine) {
  EXPECT_EQ(description_difference("<robot>\n <link/>\n</robot>\n", "<robot>\n\t<link/>\r\n</robot>\n"), "");
  const std::string why = description_difference("<robot>\n<limit upper='1'/>\n</robot>",
                                                 "<robot>\n<limit upper='2'/>\n</robot>");
  EXPECT_THAT(why, AllOf(HasSubstr("line 2"), HasSubstr("upper='1'"), HasSubstr("upper='2'"),
                         HasSubstr("--robot FOLDER")));
  EXPECT_THAT(description_difference("<robot>\n", ""), HasSubstr("here it is nothing"));
  EXPECT_THAT(description_difference("", "<robot>"), HasSubstr("is nothing"));
}

}  // namespace
}  // namespace gaitway::tools
