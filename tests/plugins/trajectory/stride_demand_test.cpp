// What a gait asks of the legs and of the ground follows from the body and its limits, whatever the body.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "gaitway/trajectory/joint_pace.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::trajectory {
namespace {

using urdf::LegJoint;

urdf::RobotModel larger_with_other_hips() {
  test::RobotVariant variant;
  variant.scale(1.4);
  variant.reorder(test::kHip, test::kHipOrders.back());
  return urdf::load_robot(variant.folder());
}

// The value says whether it is humanoid22 or the other body.
class StrideDemandOf : public ::testing::TestWithParam<bool> {
 protected:
  [[nodiscard]] StrideDemand demand(double speed_share) const {
    return stride_demand(gait_, robot_, speed_share * fastest_m_per_s_);
  }
  // The joint of both legs.
  [[nodiscard]] std::array<urdf::Joint*, 2> both(LegJoint which) {
    const urdf::ForwardKinematics home(robot_);
    std::array<urdf::Joint*, 2> joints{};
    for (const urdf::Side side : urdf::kSides) {
      const int index = urdf::LegJoints(robot_, home, side)[which];
      joints[urdf::index_of(side)] = &robot_.joints[static_cast<std::size_t>(index)];
    }
    return joints;
  }
  void narrow(LegJoint which, double by_rad) {
    for (urdf::Joint* const joint : both(which)) {
      joint->lower_rad += by_rad;
      joint->upper_rad -= by_rad;
    }
  }

  urdf::RobotModel robot_ =
      GetParam() ? urdf::load_robot(GAITWAY_URDF_DIR "/humanoid22") : larger_with_other_hips();
  const GaitParameters gait_ = gait_of(robot_);
  const double fastest_m_per_s_ = gait_.max_step_forward_m / gait_.step_time_s;
};

TEST_P(StrideDemandOf, RoomIsThatOfTheJointWhoseLimitsAreNarrowed) {
  constexpr double kNarrower_rad = 0.03;
  const JointRoom usual = demand(0.7).room;
  narrow(usual.joint, kNarrower_rad);
  const JointRoom narrowed = demand(0.7).room;
  EXPECT_EQ(narrowed.joint, usual.joint);
  EXPECT_NEAR(narrowed.room_rad, usual.room_rad - kNarrower_rad, 1e-12);
}

TEST_P(StrideDemandOf, RoomNeverLessensByMoreThanALimit) {
  constexpr double kNarrower_rad = 0.2;
  const JointRoom usual = demand(0.7).room;
  bool another_is_nearest = false;
  for (const LegJoint which : {LegJoint::hip_pitch, LegJoint::knee, LegJoint::ankle_pitch}) {
    narrow(which, kNarrower_rad);
    const JointRoom narrowed = demand(0.7).room;
    narrow(which, -kNarrower_rad);
    EXPECT_LE(narrowed.room_rad, usual.room_rad);
    EXPECT_GE(narrowed.room_rad, usual.room_rad - kNarrower_rad - 1e-12);
    if (narrowed.room_rad < usual.room_rad) {
      EXPECT_EQ(narrowed.joint, which);
    }
    another_is_nearest = another_is_nearest || narrowed.joint != usual.joint;
  }
  EXPECT_TRUE(another_is_nearest) << "or the test says nothing of the others";
}

TEST_P(StrideDemandOf, HalfTheVelocityLimitIsTwiceThePace) {
  const JointPace usual = demand(0.7).pace;
  for (urdf::Joint* const joint : both(usual.joint)) joint->velocity_limit_rad_per_s *= 0.5;
  const JointPace halved = demand(0.7).pace;
  EXPECT_EQ(halved.joint, usual.joint);
  EXPECT_NEAR(halved.share, 2.0 * usual.share, 1e-12);
}

TEST_P(StrideDemandOf, TwistGrowsWithTheLegsMassAndFallsWithFriction) {
  const double usual = demand(0.7).twist_share;
  ASSERT_GT(usual, 0.0);
  robot_.contact.friction *= 2.0;
  EXPECT_NEAR(demand(0.7).twist_share, 0.5 * usual, 1e-12);
  robot_.contact.friction *= 0.5;
  // The body as a whole is as heavy as before, so that the ground bears the same.
  constexpr double kHeavier = 1.3;
  const double weighs_kg = robot_.total_mass_kg();
  for (const urdf::Leg& leg : robot_.legs) {
    for (const int joint : leg.joints) {
      const int child = robot_.joints[static_cast<std::size_t>(joint)].child_link;
      robot_.links[static_cast<std::size_t>(child)].mass_kg *= kHeavier;
    }
  }
  robot_.links[0].mass_kg -= robot_.total_mass_kg() - weighs_kg;
  EXPECT_NEAR(demand(0.7).twist_share, kHeavier * usual, 0.01 * usual) << "but for the CoM, which is lower";
}

TEST_P(StrideDemandOf, FasterWalksAskMore) {
  const StrideDemand on_the_spot = demand(0.0), slow = demand(0.4), fast = demand(1.0);
  EXPECT_GT(slow.pace.share, on_the_spot.pace.share);
  EXPECT_GT(fast.pace.share, slow.pace.share);
  EXPECT_LE(slow.room.room_rad, on_the_spot.room.room_rad);
  EXPECT_LT(fast.room.room_rad, slow.room.room_rad);
  EXPECT_GT(slow.twist_share, on_the_spot.twist_share);
  EXPECT_GT(fast.twist_share, slow.twist_share);
}

INSTANTIATE_TEST_SUITE_P(Bodies, StrideDemandOf, ::testing::Bool());

}  // namespace
}  // namespace gaitway::trajectory
