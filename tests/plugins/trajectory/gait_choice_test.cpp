// What a robot's gait is not the scaled default for, with the reason; and the torques that its legs need.
#include "gaitway/trajectory/gait_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/joint_pace.hpp"
#include "gaitway/trajectory/joint_torque.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/leg_joints.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::trajectory {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

urdf::RobotModel chosen_robot() {
  return urdf::load_robot(GAITWAY_ROBOTS "/humanoid22");
}
void limit_motors(urdf::RobotModel& robot, double torque_Nm) {
  for (urdf::Joint& joint : robot.joints) joint.motor.torque_limit_Nm = torque_Nm;
}

TEST(ChooseGait, OfHumanoid22OnlyTheStandIsTakenFromTheDescription) {
  const ChosenGait gait = choose_gait(chosen_robot());
  for (const char* const number : {"step_time", "lift", "max_step_forward", "max_foot_spacing", "settle"}) {
    EXPECT_EQ(gait.choice(number), nullptr) << number;
  }
  for (const GaitChoice& choice : gait.choices) {
    EXPECT_EQ(choice.reasons.size(), 1U) << choice.parameter;
    EXPECT_THAT(choice.reasons.front(), HasSubstr("stance")) << choice.parameter;
  }
}

TEST(ChooseGait, NamesTheSlowKnee) {
  urdf::RobotModel robot = chosen_robot();
  for (urdf::Joint& joint : robot.joints) joint.velocity_limit_rad_per_s = 4.5;
  const ChosenGait gait = choose_gait(robot);
  const GaitChoice* const lift = gait.choice("lift");
  ASSERT_NE(lift, nullptr);
  EXPECT_LT(lift->chosen, lift->scaled);
  EXPECT_EQ(lift->chosen, gait.parameters.lift_m);
  EXPECT_THAT(lift->reasons.front(), AllOf(HasSubstr("speed: the knee"), HasSubstr("4.5 rad/s")));
}

void make_legs_heavier(urdf::RobotModel& robot, double times) {
  for (const urdf::Leg& leg : robot.legs) {
    for (const int index : leg.joints) {
      const int link = robot.joints[static_cast<std::size_t>(index)].child_link;
      robot.links[static_cast<std::size_t>(link)].mass_kg *= times;
    }
  }
}

// Heavy legs twist the foot on the ground. The arms swing against them first, which costs least.
TEST(ChooseGait, ArmsSwingAgainstHeavyLegs) {
  urdf::RobotModel robot = chosen_robot();
  EXPECT_EQ(choose_gait(robot).parameters.arm_swing_rad_per_m, 0.0);
  make_legs_heavier(robot, 2.0);
  const ChosenGait gait = choose_gait(robot);
  const GaitChoice* const arms = gait.choice("arm_swing");
  ASSERT_NE(arms, nullptr);
  EXPECT_THAT(arms->reasons.front(), HasSubstr("twist the foot"));
  const GaitParameters& p = gait.parameters;
  const double fastest_m_per_s = p.max_step_forward_m / p.step_time_s;
  GaitParameters still = p;
  still.arm_swing_rad_per_m = 0.0;
  const StrideDemand swinging = stride_demand(p, robot, fastest_m_per_s);
  EXPECT_LT(swinging.twist_share, 0.9 * stride_demand(still, robot, fastest_m_per_s).twist_share);
  EXPECT_LE(swinging.arm_pace_share, 0.51);
}

// The swing gets flatter where arms do not help.
TEST(ChooseGait, HeavyLegsSwingFlatterWithoutArms) {
  test::RobotVariant variant;
  variant.remove_arms();
  urdf::RobotModel robot = urdf::load_robot(variant.folder());
  make_legs_heavier(robot, 2.0);
  const ChosenGait gait = choose_gait(robot);
  EXPECT_EQ(gait.parameters.arm_swing_rad_per_m, 0.0);
  const GaitChoice* const flatness = gait.choice("swing_flatness");
  ASSERT_NE(flatness, nullptr);
  EXPECT_GT(flatness->chosen, 0.0);
  EXPECT_THAT(flatness->reasons.front(), HasSubstr("twist the foot"));
}

// Shoulders that turn slowly do not swing faster than they may.
TEST(ChooseGait, SlowShouldersSwingLess) {
  urdf::RobotModel robot = chosen_robot();
  make_legs_heavier(robot, 2.0);
  const double quick = choose_gait(robot).parameters.arm_swing_rad_per_m;
  for (urdf::Joint& joint : robot.joints) {
    if (joint.name.ends_with("shoulder_pitch")) joint.velocity_limit_rad_per_s = 0.5;
  }
  const GaitParameters slow = choose_gait(robot).parameters;
  EXPECT_LT(slow.arm_swing_rad_per_m, quick);
  EXPECT_LE(stride_demand(slow, robot, slow.max_step_forward_m / slow.step_time_s).arm_pace_share, 0.51);
}

// Legs that are not alike are both looked at, and the one that is short of it is named.
TEST(ChooseGait, NamesTheLimitsOfTheSideThatKeepsThem) {
  urdf::RobotModel robot = chosen_robot();
  for (urdf::Joint& joint : robot.joints) {
    if (joint.name == "right_knee") joint.velocity_limit_rad_per_s = 4.5;
  }
  const ChosenGait gait = choose_gait(robot);
  const GaitChoice* const lift = gait.choice("lift");
  ASSERT_NE(lift, nullptr);
  EXPECT_THAT(lift->reasons.front(), AllOf(HasSubstr("speed: the knee"), HasSubstr("4.5 rad/s")));
}

TEST(ChooseGait, GoesByTheSmallerSole) {
  urdf::RobotModel robot = chosen_robot();
  robot.feet[1].size_m.y() *= 0.8;
  EXPECT_EQ(choose_gait(robot).parameters.sole.width_m, robot.feet[1].size_m.y());
}

// What is chosen asks no more than it may: the reason's limit is kept at the speed that is allowed.
TEST(ChooseGait, KeepsWhatItWasChosenFor) {
  urdf::RobotModel robot = chosen_robot();
  for (urdf::Joint& joint : robot.joints) {
    if (joint.name.ends_with("ankle_pitch")) {
      joint.lower_rad = joint.home_rad - 0.42;
      joint.upper_rad = joint.home_rad + 0.42;
    }
  }
  const GaitParameters gait = choose_gait(robot).parameters;
  const double fastest_m_per_s = gait.max_step_forward_m / gait.step_time_s;
  EXPECT_GT(fastest_m_per_s, 0.2);
  const StrideDemand demand = stride_demand(gait, robot, fastest_m_per_s);
  EXPECT_GE(demand.room.room_rad, 0.029);
  EXPECT_LE(demand.twist_share, 0.501);
  EXPECT_LE(demand.pace.share, 0.921);
}

// A hip that yaws slowly turns the body slowly; without that its batches would be refused.
TEST(ChooseGait, ASlowHipYawLimitsTheTurnAlone) {
  urdf::RobotModel robot = chosen_robot();
  const GaitParameters usual = choose_gait(robot).parameters;
  for (urdf::Joint& joint : robot.joints) {
    if (joint.name.ends_with("hip_yaw")) joint.velocity_limit_rad_per_s = 1.0;
  }
  const ChosenGait gait = choose_gait(robot);
  const GaitChoice* const turn = gait.choice("max_step_turn");
  ASSERT_NE(turn, nullptr);
  EXPECT_LT(turn->chosen, 0.5 * turn->scaled);
  EXPECT_GT(turn->chosen, 0.02);
  EXPECT_THAT(turn->reasons.front(), AllOf(HasSubstr("speed: the hip yaw"), HasSubstr("1 rad/s")));
  EXPECT_EQ(gait.parameters.max_step_forward_m, usual.max_step_forward_m);
}

TEST(ChooseGait, NarrowHipRollsLimitTheSideStep) {
  urdf::RobotModel robot = chosen_robot();
  const urdf::ForwardKinematics home(robot);
  for (const urdf::Side side : urdf::kSides) {
    const int index = urdf::LegJoints(robot, home, side)[urdf::LegJoint::hip_roll];
    urdf::Joint& roll = robot.joints[static_cast<std::size_t>(index)];
    roll.lower_rad = roll.home_rad - 0.17;
    roll.upper_rad = roll.home_rad + 0.17;
  }
  const ChosenGait gait = choose_gait(robot);
  const GaitChoice* const spacing = gait.choice("max_foot_spacing");
  ASSERT_NE(spacing, nullptr);
  EXPECT_LT(spacing->chosen, spacing->scaled);
  EXPECT_THAT(spacing->reasons.front(), HasSubstr("limit: the hip roll"));
}

// No search goes on for ever, or leaves what the parameters may be.
TEST(ChooseGait, EndsAlsoWhereNothingHelps) {
  urdf::RobotModel robot = chosen_robot();
  for (urdf::Joint& joint : robot.joints) {
    if (joint.name.ends_with("knee")) joint.velocity_limit_rad_per_s = 1e-320;
  }
  EXPECT_NO_THROW(choose_gait(robot).parameters.validate());
}

TEST(ChooseGait, KeepsToWhatTheParametersMayBeOnASmallBody) {
  test::RobotVariant variant;
  variant.scale(0.63);
  urdf::RobotModel robot = urdf::load_robot(variant.folder());
  robot.contact.friction = 3.0;
  for (urdf::Joint& joint : robot.joints) {
    if (!joint.name.ends_with("hip_pitch") && !joint.name.ends_with("ankle_pitch")) continue;
    joint.lower_rad = std::max(joint.lower_rad, -0.5);
    joint.upper_rad = std::min(joint.upper_rad, 0.5);
  }
  ChosenGait gait;
  ASSERT_NO_THROW(gait = choose_gait(robot));
  EXPECT_NO_THROW(gait.parameters.validate());
}

TEST(ChooseGait, NamesTheByteOnTheWire) {
  urdf::RobotModel robot = chosen_robot();
  for (urdf::Joint& joint : robot.joints) {
    joint.velocity_limit_rad_per_s = 4.5;
    joint.count_rad = 4.5 * facts::kSlot_s / facts::kLargestByte_counts;
  }
  EXPECT_THAT(choose_gait(robot).choice("lift")->reasons.front(), HasSubstr("the byte on the wire"));
}

TEST(ChooseGait, ShortLegsAreAReason) {
  urdf::RobotModel robot = chosen_robot();
  for (urdf::Joint& joint : robot.joints) {
    if (joint.name.ends_with("knee")) joint.lower_rad = 0.6;  // it does not stretch
  }
  const ChosenGait gait = choose_gait(robot);
  const GaitChoice* const step = gait.choice("max_step_forward");
  ASSERT_NE(step, nullptr);
  EXPECT_THAT(step->reasons.front(), HasSubstr("reach"));
}

// The knee carries all but shin and foot at the lever that its place has behind the CoM.
TEST(LegTorques, OfTheKneeIsTheWeightAboveAtItsLever) {
  const urdf::RobotModel robot = chosen_robot();
  const urdf::ForwardKinematics home(robot);
  for (const JointTorque& torque : leg_torques(gait_of(robot), robot)) {
    if (torque.joint != urdf::LegJoint::knee) continue;
    const urdf::Joint& knee = robot.joints[static_cast<std::size_t>(torque.index)];
    const double lever_m = std::abs(home.com_m().x() - home.link_position_m(knee.child_link).x());
    const double all_Nm = robot.total_mass_kg() * facts::kGravity_m_per_s2 * lever_m;
    EXPECT_LT(torque.holds_Nm, all_Nm);
    EXPECT_GT(torque.holds_Nm, 0.8 * all_Nm);
    EXPECT_EQ(torque.limit_Nm, knee.motor.torque_limit_Nm);
  }
}

TEST(LegTorques, ARobotThatCannotHoldItselfIsRefusedByJointAndTorques) {
  urdf::RobotModel robot = chosen_robot();
  const GaitParameters gait = gait_of(robot);
  EXPECT_NO_THROW(require_strong_enough(gait, robot));
  EXPECT_EQ(weakest_joint(leg_torques(gait, robot), robot), "");
  limit_motors(robot, 0.05 * 6.84 * 9.81 * 0.36);
  EXPECT_THAT([&] { require_strong_enough(gait, robot); },
              ThrowsMessage<std::invalid_argument>(
                  AllOf(HasSubstr("joint 'left_"), HasSubstr("N*m to stand on one leg"),
                        HasSubstr("its motor has 1.21"), HasSubstr("stronger motor"))));
}

// As measured with the whole chain: 0.20 of weight times hip height walks, 0.12 falls.
TEST(LegTorques, SayWhatWalksAndWhatFalls) {
  urdf::RobotModel robot = chosen_robot();
  limit_motors(robot, 0.20 * 6.84 * 9.81 * 0.36);
  EXPECT_EQ(weakest_joint(leg_torques(gait_of(robot), robot), robot), "");
  limit_motors(robot, 0.12 * 6.84 * 9.81 * 0.36);
  EXPECT_THAT(weakest_joint(leg_torques(gait_of(robot), robot), robot), HasSubstr("its motor has 2.9"));
}

TEST(LegTorques, AWeakHipSwingsShorterSteps) {
  urdf::RobotModel robot = chosen_robot();
  for (urdf::Joint& joint : robot.joints) {
    if (joint.name.ends_with("hip_pitch")) joint.motor.torque_limit_Nm = 1.2;
  }
  const ChosenGait gait = choose_gait(robot);
  const GaitChoice* const step = gait.choice("max_step_forward");
  ASSERT_NE(step, nullptr);
  EXPECT_LT(step->chosen, 0.9 * step->scaled);
  EXPECT_THAT(step->reasons.back(), HasSubstr("torque: the hip pitch has 1.2 N*m"));
}

}  // namespace
}  // namespace gaitway::trajectory
