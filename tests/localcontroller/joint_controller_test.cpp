// One joint as the bus sees it: frames in, torque and frames out.
#include "joint_controller_fixture.hpp"

namespace gaitway::localcontroller {
namespace {

JointConfig with_current_sensor(JointConfig config) {
  config.senses_current = true;
  return config;
}

TEST_F(JointControllerTest, AnswersEachSyncWithOneFeedbackFrameOfWhatItMeasured) {
  sensors = {.encoder_count = -1234, .channel = {12.344F, -3.0F}, .motor_current_Nm = -2.51F};
  run(20);
  EXPECT_TRUE(frames().empty()) << "nothing to say before the first SYNC";
  sync(0);
  run(1);
  const auto all = frames();
  ASSERT_EQ(all.size(), 1U);
  const auto message = can::decode_feedback(can::kFullProfile, all.front());
  ASSERT_TRUE(message);
  EXPECT_EQ(message->node, kNode);
  EXPECT_EQ(message->position, -1234);
  EXPECT_EQ(message->current, 64) << "8 N*m, the limit: what the servo asks for, without a current sensor";
  EXPECT_EQ(message->channel[0], 1234);
  EXPECT_EQ(message->channel[1], -3000);
  EXPECT_EQ(message->state, can::JointState::holding);
}

TEST_F(JointControllerTest, TellsTheMeanOfItsCurrentsOfTheSlot) {
  joint = JointController(with_current_sensor(config()));
  const auto told = [this](int from_ms) {
    float sum = 0.0F;
    for (int ms = from_ms; ms < from_ms + 10; ++ms) {
      sensors.motor_current_Nm = static_cast<float>(ms % 3) - 0.5F;
      sum += sensors.motor_current_Nm;
      step();
    }
    sync(next_slot);
    next_slot = (next_slot + 1) % 8;
    const auto message = feedback();
    EXPECT_TRUE(message);
    EXPECT_EQ(message->current, std::lround(sum / 10.0F / 0.125F)) << from_ms;
  };
  for (int slot = 0; slot < 6; ++slot) told(11 * slot);
  sensors.motor_current_Nm = -100.0F;
  run(9);
  sync(next_slot);
  const auto message = feedback();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->current, -127) << "what a byte holds";
}

TEST_F(JointControllerTest, ReportsWhatItHoldsWhatItPlaysAndTheLowBitsOfItsCount) {
  send(can::Trajectory{kNode, true, {-3, 5, 0, 0, 0, 0, 0, 0}});
  send(can::Trajectory{kNode + 1, false, {50, 50}});
  sync(0, true, true);
  run(1);
  auto message = feedback();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->state, can::JointState::running);
  EXPECT_TRUE(message->pending_toggle);
  EXPECT_TRUE(message->executing_toggle);
  EXPECT_EQ(message->reference_low, 0xD);  // -3
  run(9);
  send(can::Trajectory{kNode, false, {}});
  sync(1, true, true);
  run(1);
  message = feedback();
  ASSERT_TRUE(message);
  EXPECT_FALSE(message->pending_toggle);
  EXPECT_TRUE(message->executing_toggle);
  EXPECT_EQ(message->reference_low, 2);
}

TEST_F(JointControllerTest, GoesOnSendingFeedbackEverySlotWhenSyncIsLost) {
  sync(0);
  run(1);
  frames();
  int count = 0;
  for (int ms = 0; ms < 1000; ++ms) {
    step();
    count += static_cast<int>(frames().size());
  }
  EXPECT_NEAR(count, 100, 1);
}

TEST_F(JointControllerTest, ARepeatedSyncIsNotAnsweredTwice) {
  sync(0);
  run(1);
  EXPECT_EQ(frames().size(), 1U);
  sync(0);
  run(1);
  EXPECT_TRUE(frames().empty());
}

TEST_F(JointControllerTest, ATrimIsLimitedSlewedAndFadesOutWithoutNewOnes) {
  double last = 0.0;
  for (int ms = 0; ms < 100; ++ms) {
    if (ms % 10 == 0) {
      send(can::Trim{{0, 0, 127, 0, 0, 0, 0, 0}});
    }
    step();
    ASSERT_LE(std::abs(joint.trim_rad() - last), 2.0 * 0.001 + 1e-12) << "slew limit, at " << ms << " ms";
    last = joint.trim_rad();
  }
  EXPECT_NEAR(last, 0.05, 1e-12) << "limited: 0.127 rad were commanded";
  run(20);
  EXPECT_NEAR(joint.trim_rad(), 0.05, 1e-12) << "two frames may get lost";
  run(60);
  EXPECT_NEAR(joint.trim_rad(), 0.0, 1e-12);
}

TEST_F(JointControllerTest, TheServoTracksReferenceAndTrimAndTheTrimsRate) {
  run(10);
  send(can::Trim{{0, 0, 5}});  // 5 mrad over 10 ms: 0.5 rad/s
  EXPECT_NEAR(step(), 300.0 * 0.0005 + 4.0 * 0.5, 1e-9);
  run(20);
  EXPECT_NEAR(step(), 300.0 * 0.005, 1e-9);
}

TEST_F(JointControllerTest, ARepairReachesThisJointOnly) {
  sync(0, true, true);  // its trajectory frame was lost
  send(can::Resynchronisation{kNode, true, 2, 60, {7}});
  send(can::Resynchronisation{kNode + 1, true, 2, 90, {7}});
  for (int slot = 1; slot < 4; ++slot) {
    run(10);
    sync(slot, true, true);
  }
  EXPECT_EQ(joint.reference_count(), 67);
  EXPECT_EQ(joint.state(), can::JointState::running);
}

TEST_F(JointControllerTest, LimitsThatLieBetweenCountsAreRoundedInwards) {
  const auto reached = [](double lower_counts, double upper_counts, std::int16_t wanted) {
    JointConfig limited = config();
    limited.lower_rad = lower_counts * limited.count_rad;
    limited.upper_rad = upper_counts * limited.count_rad;
    limited.initial_reference_count = static_cast<std::int32_t>((lower_counts + upper_counts) / 2.0);
    JointController other(limited);
    other.on_frame(can::encode(can::kFullProfile, can::UserCommand{kNode, wanted, 1}), 0);
    return other.reference_count();
  };
  EXPECT_EQ(reached(-10.7, 10.7, 500), 10);
  EXPECT_EQ(reached(-10.7, 10.7, -500), -10);
  EXPECT_EQ(reached(3.2, 40.5, -500), 4) << "a knee";
  EXPECT_EQ(reached(-40.5, -3.2, 500), -4);
}

TEST_F(JointControllerTest, AnEmergencyStopHoldKeepsThePositionAndIgnoresBatches) {
  send(can::Trajectory{kNode, true, {100, 100, 100, 100, 100, 100, 100, 100}});
  sync(0, true, true);
  run(14);
  send(can::EmergencyStop{can::StopMode::hold});
  const double stopped_rad = joint.reference_rad();
  for (int slot = 2; slot < 8; ++slot) {
    sync(slot, true, true);
    run(10);
  }
  EXPECT_NEAR(joint.reference_rad(), stopped_rad, 1.1 * 100 * config().count_rad / 10);
  EXPECT_EQ(joint.state(), can::JointState::stopped);
}

TEST_F(JointControllerTest, AnEmergencyStopHoldHoldsTheTrimToo) {
  const can::Trim lean{{0, 0, 20}};
  send(lean);
  run(5);
  const double held_rad = joint.trim_rad();
  send(can::EmergencyStop{can::StopMode::hold});
  run(1);
  EXPECT_NEAR(held_rad, 0.010, 1e-9);
  send(can::Trim{{0, 0, -40}});  // was already waiting for the bus
  for (int ms = 0; ms < 100; ++ms) {
    step();
    ASSERT_EQ(joint.trim_rad(), held_rad) << "after " << ms << " ms";
  }
  joint.reset();
  send(lean);
  run(10);
  EXPECT_NEAR(joint.trim_rad(), 0.020, 1e-9);
}

TEST_F(JointControllerTest, AUserCommandMovesThisJointOnlyOverItsTimeAndWithinItsLimits) {
  for (int slot = 0; slot < 2; ++slot) {
    sync(slot);
    run(10);
  }
  send(can::UserCommand{kNode + 1, 500, 10});
  run(1);
  EXPECT_EQ(joint.reference_count(), 0);
  send(can::UserCommand{kNode, 500, 10});
  double last_rad = joint.reference_rad();
  for (int ms = 0; ms < 110; ++ms) {
    if (ms % 10 == 8) {
      sync((ms / 10 + 2) % 8);
    }
    step();
    ASSERT_LE(joint.reference_rad() - last_rad, 5.001 * config().count_rad);
    last_rad = joint.reference_rad();
  }
  EXPECT_NEAR(last_rad, 500 * config().count_rad, 1e-12);
  send(can::UserCommand{kNode, -32768, 200});
  run(2000);
  EXPECT_GE(joint.reference_rad(), -1.0);
  EXPECT_NEAR(joint.reference_rad(), -1.0, config().count_rad);
}

TEST_F(JointControllerTest, EverySlotHasOneFeedbackFrameInWhateverOrderItsSyncsAndStepsCome) {
  int count = 0;
  for (int slot = 0; slot < 800; ++slot) {
    cycle = static_cast<std::uint16_t>(slot / 8);
    const int late = slot * 7 % 2;  // within the grace
    run(late);
    sync(slot % 8);
    if (slot % 5 == 0) {
      sync(slot % 8);  // repeated by the bus
    }
    run(10 - late);
    const auto all = frames();
    ASSERT_EQ(all.size(), 1U) << "slot " << slot;
    count += can::decode_feedback(can::kFullProfile, all.front()) ? 1 : 0;
  }
  EXPECT_EQ(count, 800);
}

TEST_F(JointControllerTest, FeedbackSaturatesWhatItsBytesCannotHold) {
  joint = JointController(with_current_sensor(config()));
  sensors = {.encoder_count = -40'000, .channel = {1e6F, -1e6F}, .motor_current_Nm = 40.0F};
  run(10);
  sync(0);
  run(1);
  const auto message = feedback();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->position, -32767);
  EXPECT_EQ(message->current, 127);
  EXPECT_EQ(message->channel[0], 32767);
  EXPECT_EQ(message->channel[1], -32767);
}

TEST_F(JointControllerTest, AnEmergencyStopSoftTakesTheTorqueAwayAndNoOtherStopGivesItBack) {
  sensors.encoder_count = 2000;
  run(5);
  ASSERT_LT(step(), -1.0);
  send(can::EmergencyStop{can::StopMode::soft});
  EXPECT_EQ(step(), 0.0);
  EXPECT_EQ(joint.state(), can::JointState::soft);
  send(can::EmergencyStop{can::StopMode::hold});
  EXPECT_EQ(step(), 0.0) << "the joint may lie anywhere by now: it must not spring back to its old reference";
}

TEST_F(JointControllerTest, AResetStartsAgainFromWhereTheJointIs) {
  send(can::EmergencyStop{can::StopMode::soft});
  sensors.encoder_count = 5000;
  run(10);
  joint.reset();
  EXPECT_EQ(joint.state(), can::JointState::holding);
  EXPECT_NEAR(step(), 0.0, 300.0 * config().count_rad) << "within a count: no jerk";
  send(can::Trajectory{kNode, true, {10}});
  const std::int32_t before = joint.reference_count();
  sync(0, true, true);
  EXPECT_EQ(joint.reference_count(), before + 10);
}

TEST_F(JointControllerTest, AReleaseEndsAnEmergencyStopWhereTheJointIsAndNothingElse) {
  send(can::EmergencyStop{can::StopMode::soft});
  sensors.encoder_count = 5000;
  run(10);
  send(can::EmergencyStop{can::StopMode::release});
  EXPECT_EQ(joint.state(), can::JointState::holding);
  EXPECT_NEAR(step(), 0.0, 300.0 * config().count_rad) << "within a count: no jerk";
  const std::int32_t here = joint.reference_count();
  EXPECT_NE(here, 0);
  sensors.encoder_count = 5400;
  run(10);
  send(can::EmergencyStop{can::StopMode::release});
  EXPECT_EQ(joint.reference_count(), here) << "it was not stopped";
}

TEST_F(JointControllerTest, FollowsItsBatchesOnASimulatedJoint) {
  constexpr double kInertia_kgm2 = 0.03;
  double position = 0.0, speed = 0.0, largest_error = 0.0;
  bool toggle = true;
  for (int ms = 0; ms < 1600; ++ms) {
    const int slot = ms / 10 % 8;
    if (ms % 80 == 0) {
      can::Trajectory batch{kNode, toggle, {}};
      for (int k = 0; k < 8; ++k) {  // 0.2 rad at 1.25 Hz
        const auto count = [](int point) {
          return std::lround(0.2 / config().count_rad * std::sin(7.854 * 0.01 * point));
        };
        const int point = ms / 10 + k;
        batch.delta[static_cast<std::size_t>(k)] = static_cast<std::int8_t>(count(point + 1) - count(point));
      }
      send(batch);
    }
    if (ms % 10 == 0) {
      sync(slot, true, toggle);
      if (slot == 7) {
        toggle = !toggle;
        ++cycle;
      }
    }
    sensors.encoder_count = static_cast<std::int32_t>(std::lround(position / config().encoder_count_rad));
    const double torque = step();
    for (int i = 0; i < 10; ++i) {
      speed += (torque - 0.15 * speed) / kInertia_kgm2 * 1e-4;
      position += speed * 1e-4;
    }
    largest_error = ms > 300 ? std::max(largest_error, std::abs(position - joint.reference_rad())) : 0.0;
  }
  EXPECT_LT(largest_error, 0.01);
  EXPECT_NEAR(joint.reference_rad(), 0.2 * std::sin(7.854 * 1.6), 2 * config().count_rad);
}

// Held 0.02 rad away from its reference.
TEST_F(JointControllerTest, GoesSoftAtOnceAndStiffInHalfASecond) {
  sensors.encoder_count = static_cast<std::int32_t>(std::lround(0.02 / config().encoder_count_rad));
  const auto slots = [&](int count, std::uint8_t softness) {
    double torque_Nm = 0.0;
    for (int i = 0; i < count; ++i) {
      send(can::Sync{cycle, static_cast<std::uint8_t>(i % 8), false, false, softness});
      for (int ms = 0; ms < 10; ++ms) torque_Nm = step();
    }
    return torque_Nm;
  };
  const double stiff_Nm = slots(10, 0);
  EXPECT_NEAR(stiff_Nm, -300.0 * 0.02, 0.1);
  EXPECT_NEAR(slots(1, 4), stiff_Nm * 3.0 / 7.0, 1e-9);
  EXPECT_EQ(slots(1, can::kMostSoftness), 0.0);
  run(50);
  EXPECT_EQ(step(), 0.0) << "without SYNC it stays soft";
  EXPECT_NEAR(slots(25, 0), stiff_Nm / 2.0, 0.03 * std::abs(stiff_Nm));
  EXPECT_NEAR(slots(30, 0), stiff_Nm, 1e-9);
}

TEST_F(JointControllerTest, NoSoftnessEndsAnEmergencyStop) {
  sensors.encoder_count = 100;
  run_slots(5);
  send(can::EmergencyStop{can::StopMode::soft});
  run_slots(100);
  EXPECT_EQ(step(), 0.0);
}

}  // namespace
}  // namespace gaitway::localcontroller
