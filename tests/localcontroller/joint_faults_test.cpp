// The faults that a joint reports: when they begin, when they end, and what it does meanwhile.
#include "joint_controller_fixture.hpp"

namespace gaitway::localcontroller {
namespace {

TEST_F(JointControllerTest, ReportsAPositionLimitWhenItBeginsAndWhenItEnds) {
  constexpr int kLimit = static_cast<int>(can::Fault::position_limit);
  const auto limit = static_cast<std::int32_t>(1.0 / config().count_rad);
  run_slots(9);
  send(can::UserCommand{kNode, static_cast<std::int16_t>(limit + 200), 1});
  run(1);
  sensors.encoder_count = static_cast<std::int32_t>(limit * config().count_rad / config().encoder_count_rad);
  EXPECT_EQ(fault_reports(), std::vector<int>{kLimit | kRestarted});
  EXPECT_EQ(joint.reference_count(), limit);
  run(9);
  EXPECT_LE(joint.reference_rad(), 1.0);
  EXPECT_TRUE(fault_reports().empty()) << "once is enough, and reports keep their period";
  send(can::UserCommand{kNode, static_cast<std::int16_t>(limit - 1), 50});
  run_slots(9);
  EXPECT_EQ(fault_reports().back() & kLimit, 0);
}

TEST_F(JointControllerTest, SaysThatItHasRestartedUntilItPlaysWhatItWasToldAgain) {
  send(can::Trajectory{kNode, true, {1, 1, 1, 1, 1, 1, 1, 1}});
  for (int slot = 0; slot < 8; ++slot) {
    sync(slot, true, true);
    run(10);
  }
  run(1);
  EXPECT_EQ(fault_reports(), std::vector<int>{0});
}

TEST_F(JointControllerTest, ReportsALostSyncAfterTwoSlotsAndItsReturn) {
  run_slots(1);
  run(kReportPeriod_ms);
  EXPECT_EQ(fault_reports(), std::vector<int>{kRestarted | static_cast<int>(can::Fault::sync_lost)});
  run_slots(9);
  EXPECT_EQ(fault_reports(), std::vector<int>{kRestarted});
}

TEST_F(JointControllerTest, SaysOfEachTailAnewThatItIsMissing) {
  constexpr int kMissing = static_cast<int>(can::Fault::tail_missing);
  const auto play_slots_naming = [this](bool toggle, int tail_points) {
    send(can::Trajectory{kNode, toggle, {}});
    for (int slot = 0; slot < 8; ++slot) {
      send(can::Sync{.cycle = cycle,
                     .slot = static_cast<std::uint8_t>(slot),
                     .batch_committed = true,
                     .toggle = toggle,
                     .tail_points = static_cast<std::uint8_t>(tail_points),
                     .tail_toggle = toggle});
      run(10);
    }
    ++cycle;
  };
  run(kReportPeriod_ms);
  for (const bool toggle : {true, false, true}) {
    play_slots_naming(toggle, 3);
    EXPECT_EQ(fault_reports(), std::vector<int>{kMissing});
  }
  play_slots_naming(false, 0);
  EXPECT_EQ(fault_reports(), std::vector<int>{0});
}

TEST_F(JointControllerTest, ReportsTorqueThatIsNotEnoughForAWhileOnly) {
  sensors.encoder_count = -600;  // 0.058 rad: more than the torque can hold
  run(20);
  sensors.encoder_count = 0;
  run(kReportPeriod_ms);
  EXPECT_TRUE(fault_reports().empty()) << "too short to matter";
  sensors.encoder_count = -600;
  run(kReportPeriod_ms);
  EXPECT_EQ(fault_reports().back(), kRestarted | static_cast<int>(can::Fault::torque_saturated));
}

TEST_F(JointControllerTest, OneWildReadingOfTheEncoderMovesNothingAndIsReported) {
  run(kReportPeriod_ms);
  const double before_Nm = step();
  sensors.encoder_count = 30'000;
  EXPECT_DOUBLE_EQ(step(), before_Nm);
  EXPECT_EQ(fault_reports(), std::vector<int>{kRestarted | static_cast<int>(can::Fault::encoder)});
  sensors.encoder_count = 0;
  EXPECT_DOUBLE_EQ(step(), before_Nm);
}

TEST_F(JointControllerTest, AFaultThatEndedBeforeItCouldBeReportedIsReportedAllTheSame) {
  sync(0);
  run(10);
  send(can::UserCommand{kNode, 32767, 1});
  run(kReportPeriod_ms);
  EXPECT_NE(fault_reports().front() & static_cast<int>(can::Fault::position_limit), 0);
}

}  // namespace
}  // namespace gaitway::localcontroller
