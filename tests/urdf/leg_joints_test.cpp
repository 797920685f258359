// What a leg's joints do is told by their axes, whatever they are called and in whichever order they come.
#include "gaitway/urdf/leg_joints.hpp"

#include <gmock/gmock.h>

#include "broken_robot.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::urdf {
namespace {

using gaitway::test::kAnkle;
using gaitway::test::kHip;
using gaitway::test::kHipOrders;
using gaitway::test::RobotVariant;
using testing::HasSubstr;

std::string name_of(const RobotModel& model, Side side, LegJoint which) {
  const LegJoints joints(model, ForwardKinematics(model), side);
  return model.joints[static_cast<std::size_t>(joints[which])].name;
}

TEST(LegJoints, AreFoundInEveryOrderOfTheHip) {
  constexpr std::array kRoles{LegJoint::hip_yaw, LegJoint::hip_roll, LegJoint::hip_pitch};
  for (const auto& order : kHipOrders) {
    RobotVariant variant;
    variant.reorder(kHip, order);
    const RobotModel model = load_robot(variant.folder());
    for (std::size_t place = 0; place < order.size(); ++place) {
      EXPECT_EQ(name_of(model, Side::left, kRoles[order[place]]), "left_" + kHip[place]);
      EXPECT_EQ(name_of(model, Side::right, kRoles[order[place]]), "right_" + kHip[place]);
    }
    EXPECT_EQ(name_of(model, Side::left, LegJoint::knee), "left_knee");
    EXPECT_EQ(name_of(model, Side::right, LegJoint::ankle_roll), "right_ankle_roll");
  }
}

TEST(LegJoints, AreFoundInBothOrdersOfTheAnkle) {
  RobotVariant variant;
  variant.reorder(kAnkle, {1, 0});
  const RobotModel model = load_robot(variant.folder());
  EXPECT_EQ(name_of(model, Side::left, LegJoint::ankle_pitch), "left_ankle_roll");
  EXPECT_EQ(name_of(model, Side::right, LegJoint::ankle_roll), "right_ankle_pitch");
}

TEST(LegJoints, ALegThatCannotTurnInAllDirectionsIsRefused) {
  test::BrokenRobot robot;
  robot.replace("robot.urdf", "<joint name=\"left_ankle_roll\"", "<axis xyz=\"1 0 0\"",
                "<axis xyz=\"0 0 1\"");
  EXPECT_THAT(robot.complaint(),
              testing::AllOf(
                  HasSubstr(robot.line_of("robot.yaml", "left: [left_hip_yaw")), HasSubstr("legs.left"),
                  HasSubstr("the left leg has no ankle roll joint: none of its joints 5 to 6 turns about the "
                            "base's x axis in the home posture")));
}

}  // namespace
}  // namespace gaitway::urdf
