// How stiffly a joint holds: as configured while it is told what to do or has points to play, compliantly
// when it is left alone after them.
#include "joint_controller_fixture.hpp"

namespace gaitway::localcontroller {
namespace {

constexpr double kStiff_Nm = 0.01 * 300.0;  // 0.01 rad from the reference

class ComplianceTest : public JointControllerTest {
 protected:
  void SetUp() override {
    JointControllerTest::SetUp();
    hang_below_reference();
    run_slots(9);
    ++cycle;
    send(can::Trajectory{kNode, true, {}});
    for (int slot = 0; slot < can::kBatchPoints; ++slot) {
      sync(slot, true, true);
      run(10);
    }
    ++cycle;
    next_slot = 0;
    run_slots(9);
  }
  // The encoder stands 0.01 rad below the reference, wherever that goes.
  double hang_below_reference() {
    sensors.encoder_count =
        static_cast<std::int32_t>(std::lround((joint.reference_rad() - 0.01) / config().encoder_count_rad));
    return step();
  }
  // Torque once the servo has forgotten that the encoder moved.
  double torque_at_rest() {
    hang_below_reference();
    for (int i = 0; i < 8; ++i) {
      step();
    }
    return step();
  }
};

TEST_F(ComplianceTest, HoldsCompliantlyWhenSyncIsLostAndStifflyAgainATenthOfASecondAfterItsReturn) {
  EXPECT_NEAR(torque_at_rest(), kStiff_Nm, 0.05);
  run(100);
  EXPECT_NEAR(torque_at_rest(), 0.2 * kStiff_Nm, 0.05);
  EXPECT_EQ(joint.state(), can::JointState::running) << "its torque does not tell where its reference is";
  run_slots(5);
  const double between_Nm = step();
  EXPECT_GT(between_Nm, 0.4 * kStiff_Nm);
  EXPECT_LT(between_Nm, 0.8 * kStiff_Nm) << "no jump of the torque";
  EXPECT_EQ(joint.state(), can::JointState::running);
  run_slots(6);
  EXPECT_NEAR(step(), kStiff_Nm, 0.05);
  EXPECT_EQ(joint.state(), can::JointState::holding);
}

// The others may go on, and load it.
TEST_F(ComplianceTest, AFewLostSyncsChangeNothing) {
  run(50);
  EXPECT_NEAR(step(), kStiff_Nm, 0.05);
  run_slots(1);
  EXPECT_NEAR(step(), kStiff_Nm, 0.05);
}

TEST_F(ComplianceTest, WhoWasStoppedKeepsItsPlace) {
  const double hanging_Nm = torque_at_rest();
  send(can::EmergencyStop{can::StopMode::hold});
  run(1);
  const double stopped_Nm = step();
  run(500);
  EXPECT_NEAR(step(), stopped_Nm, 0.05);
  EXPECT_NEAR(stopped_Nm, hanging_Nm, 0.05);
}

// It stands where it started, and may be on a bench with nothing in motion.
TEST(Compliance, WhoHasPlayedNothingYetIsStiff) {
  JointConfig config;
  config.node = kNode;
  config.stiffness_Nm_per_rad = 300.0;
  config.damping_Nms_per_rad = 4.0;
  config.torque_limit_Nm = 8.0;
  config.count_rad = config.encoder_count_rad = 0.001;
  config.lower_rad = -1.0;
  config.upper_rad = 1.0;
  JointController joint(config);
  joint.on_frame(can::encode(can::kFullProfile, can::Sync{.cycle = 1}), kMillisecond_ns);
  double torque_Nm = 0.0;
  for (int ms = 2; ms < 300; ++ms) {
    torque_Nm = joint.step(ms * kMillisecond_ns, {.encoder_count = -10});
  }
  EXPECT_NEAR(torque_Nm, 3.0, 0.01);
  EXPECT_EQ(joint.state(), can::JointState::holding);
}

TEST_F(ComplianceTest, PlaysBatchAndTailStifflyAndHoldsCompliantlyAfterThem) {
  constexpr std::array<std::int8_t, can::kBatchPoints> kMoves{1};
  ++cycle;
  send(can::Trajectory{kNode, true, kMoves});
  send(can::Tail{.node = kNode, .toggle = true, .part = 0, .delta = kMoves});
  send(can::Sync{
      .cycle = cycle, .batch_committed = true, .toggle = true, .tail_points = 8, .tail_toggle = true});
  run(140);  // of 160 ms, and no SYNC comes
  EXPECT_NEAR(torque_at_rest(), kStiff_Nm, 0.1);
  run(60);
  EXPECT_EQ(joint.reference_count(), 2);
  EXPECT_NEAR(torque_at_rest(), 0.2 * kStiff_Nm, 0.05);
}

}  // namespace
}  // namespace gaitway::localcontroller
