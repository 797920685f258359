// What a motion's file may say, and what is said about one that is wrong.
#include "gaitway/motion/motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/motion/motion_adaptation.hpp"
#include "gaitway/motion/motion_planner.hpp"
#include "motion_fixture.hpp"

namespace gaitway::motion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string complaint_about(const std::string& keys) {
  try {
    of_keys(keys);
  } catch (const urdf::RobotError& error) {
    return error.what();
  }
  return "nothing";
}

double angle_of(const Key& key, const std::string& joint) {
  for (const JointAngle& angle : key.joints) {
    if (angle.joint == humanoid22().joint_index(joint)) return angle.angle_rad;
  }
  return 99.0;
}

const urdf::Motor& motor_of(const std::string& joint) {
  return humanoid22().joints.at(static_cast<std::size_t>(humanoid22().joint_index(joint))).motor;
}

TEST(MotionFile, SymmetricAnglesAreMirrorImages) {
  const Motion motion = of_keys("  - {name: arms, symmetric: {shoulder_pitch: -30, shoulder_roll: 40}}\n");
  const Key& key = motion.keys.at(0);
  EXPECT_EQ(key.joints.size(), 4U);
  EXPECT_DOUBLE_EQ(angle_of(key, "right_shoulder_pitch"), angle_of(key, "left_shoulder_pitch"));
  EXPECT_DOUBLE_EQ(angle_of(key, "right_shoulder_roll"), -angle_of(key, "left_shoulder_roll"));
  EXPECT_NEAR(angle_of(key, "left_shoulder_roll"), 0.6981, 1e-4);
}

TEST(MotionFile, TorqueShareLimitsWhatIsPlannedAndNeverLoosensIt) {
  Motion squat = shipped("squat");
  EXPECT_FALSE(squat.torque_share);
  const auto limit_of = [&](double share) {
    squat.torque_share = share;
    const Motion read = parse_motion(motion_text(squat, humanoid22(), {}), "squat.yaml", humanoid22());
    for (const LimitUse& use : plan_motion(humanoid22(), read, {}).report.uses) {
      if (use.kind == LimitKind::torque)
        return std::pair(use.limit / motor_of(use.what).torque_limit_Nm, use.excess);
    }
    return std::pair(0.0, 1.0);
  };
  EXPECT_LE(limit_of(0.6).first, 0.6);
  EXPECT_LE(limit_of(0.6).second, 0.0) << "and that is kept";
  EXPECT_LE(limit_of(1.0).first, MotionLimits{}.torque_share);
  EXPECT_THROW(limit_of(0.05), MotionError) << "too little to hold still";
}

TEST(MotionFile, NamesFileLineFieldAndRemedyOfAWrongOne) {
  struct Wrong {
    std::string keys;
    std::vector<std::string> said;
  };
  const std::vector<Wrong> all{
      {"  - {name: a, hold: 1}\n", {"test.yaml:4", "hold", "hold_s"}},
      {"  - {name: a, joints: {left_kne: 20}}\n", {"test.yaml:4", "left_kne", "Did you mean 'left_knee'?"}},
      {"  - {name: a, joints: {left_knee: -20}}\n", {"test.yaml:4", "left_knee", "0.0 to 131.8 deg"}},
      {"  - {name: a, joints: {left_elbow: -20}, symmetric: {elbow: -20}}\n", {"elbow", "already"}},
      {"  - {name: a, symmetric: {waist_yaw: 20}}\n", {"waist_yaw is of no left limb"}},
      {"  - {name: a, contact: hands}\n", {"contact", "both, left, right, none"}},
      {"  - {name: a, left_foot: {up_m: 0.1}}\n", {"left_foot", "stands on this foot"}},
      {"  - {name: a, contact: left, right_foot: {up_m: -0.1}}\n", {"up_m", "in the ground"}},
      {"  - {name: a, joints: {left_knee: 20}, pelvis: {pitch_deg: 5}}\n", {"pelvis", "leg joints"}},
      {"  - {name: a, contact: none, pelvis: {pitch_deg: 5}}\n", {"pelvis", "contact none"}},
      {"  - {name: a, pelvis: {hip_height_m: 3}}\n", {"hip_height_m"}},
      {"  - {name: a, min_time_s: -1}\n", {"min_time_s"}},
      {"  []\n", {"keys", "at least one key"}},
  };
  for (const Wrong& wrong : all) {
    const std::string complaint = complaint_about(wrong.keys);
    for (const std::string& part : wrong.said) EXPECT_THAT(complaint, HasSubstr(part)) << wrong.keys;
  }
}

// Files are called after it: what is planned of it would be written elsewhere.
TEST(MotionFile, ANameIsNoPath) {
  const auto complaint = [](const std::string& name) -> std::string {
    try {
      static_cast<void>(
          parse_motion("name: \"" + name + "\"\ndescription: for a test\nkeys:\n  - {name: a}\n", "test.yaml",
                       humanoid22()));
    } catch (const urdf::RobotError& error) {
      return error.what();
    }
    return "nothing";
  };
  for (const char* const name : {"../evil", "/evil", "a b", "", "a.b"})
    EXPECT_THAT(complaint(name), AllOf(HasSubstr("test.yaml:1"), HasSubstr("letters, digits"))) << name;
  EXPECT_EQ(complaint("kick_2-left"), "nothing");
}

TEST(MotionFile, OneOnTheGroundMaySayTheSide) {
  const std::string head = "name: test\ndescription: for a test\n";
  const std::string keys = "keys:\n  - {name: lie, contact: none}\n  - {name: up, contact: none}\n";
  const auto of = [&](const std::string& start) {
    return parse_motion(head + start + keys, "test.yaml", humanoid22());
  };
  EXPECT_FALSE(of("start: first_key\n").lies_on.has_value());
  EXPECT_EQ(of("start: first_key\nlies_on: back\n").lies_on, trajectory::LyingSide::back);
  const auto complaint = [&](const std::string& start) -> std::string {
    try {
      static_cast<void>(of(start));
    } catch (const urdf::RobotError& error) {
      return error.what();
    }
    return "nothing";
  };
  EXPECT_THAT(complaint("lies_on: back\n"), AllOf(HasSubstr("test.yaml:3"), HasSubstr("start: first_key")));
  EXPECT_THAT(complaint("start: first_key\nlies_on: head\n"), HasSubstr("front, back, left, right"));
}

TEST(MotionFile, AFolderListsItsMotionsByName) {
  std::vector<std::string> names;
  for (const auto& file : motion_files(GAITWAY_MOTIONS)) names.push_back(file.stem());
  EXPECT_THAT(names, ::testing::IsSupersetOf({"bow", "kick", "squat", "wave"}));
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_THROW(static_cast<void>(motion_files("/nowhere")), urdf::RobotError);
}

}  // namespace
}  // namespace gaitway::motion
