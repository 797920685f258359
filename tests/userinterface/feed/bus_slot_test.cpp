// The picture of the bus that clients get, from a simulated robot: what was sent is in it, within what is
// proven; what was lost, broken or killed is not, or shows as what it is. And looking changes nothing.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "collector.hpp"
#include "gaitway/api/feed.hpp"
#include "gaitway/api/plan_digest.hpp"
#include "gaitway/can/messages.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/msgcontroller/slot_record.hpp"
#include "humanoid.hpp"
#include "simulation.hpp"

namespace gaitway::api {
namespace {

using can::kFullProfile;
using can::MessageKind;
using test::humanoid;

using facts::kMillisecond_ns;
using facts::kSlot_ns;

class BusSlotOfARobot : public ::testing::Test, private simulator::CosimulationObserver {
 protected:
  BusSlotOfARobot() { run_.observe(this); }
  // The slots that are told of `seconds`.
  std::vector<ros::BusSlot> slots_of(double seconds) {
    collector_.clear();
    const auto end_ns = run_.now_ns() + static_cast<std::int64_t>(seconds * 1e9);
    while (run_.now_ns() < end_ns) {
      run_.advance_millisecond();
      digest_.step(run_.now_ns());
      feed_.poll(run_.now_ns(), sink_);
    }
    return collector_.of<ros::BusSlot>(Topic::bus_slot);
  }
  static std::size_t count(const ros::BusSlot& slot, std::uint32_t id) {
    return static_cast<std::size_t>(std::ranges::count(slot.id, id));
  }
  static std::uint32_t feedback_of(const std::string& joint) {
    return kFullProfile.id_of(
        MessageKind::feedback,
        humanoid().joints[static_cast<std::size_t>(humanoid().joint_index(joint))].node);
  }
  // What the bus itself knows of the frames that ended in a slot.
  [[nodiscard]] std::vector<can::SimulatedBus::Delivery> on_the_bus(const ros::BusSlot& slot) const {
    const std::int64_t edge_ns =
        std::int64_t{slot.header.stamp.sec} * facts::kSecond_ns + slot.header.stamp.nanosec;
    std::vector<can::SimulatedBus::Delivery> found;
    std::ranges::copy_if(deliveries_, std::back_inserter(found), [edge_ns](const auto& delivery) {
      return delivery.end_ns >= edge_ns && delivery.end_ns <= edge_ns + kSlot_ns;
    });
    return found;
  }

  simulator::Cosimulation run_{humanoid(), served_walk()};
  PlanDigest digest_{run_.client()};
  Feed feed_{run_.client(), humanoid()};
  test::Collector collector_{Topic::bus_slot};
  decltype(test::sink_of(collector_)) sink_ = test::sink_of(collector_);

 private:
  void on_frame(const can::SimulatedBus::Delivery& delivery) override { deliveries_.push_back(delivery); }
  void on_millisecond(std::int64_t /*now_ns*/) override {}
  std::vector<can::SimulatedBus::Delivery> deliveries_;
};

TEST_F(BusSlotOfARobot, HasEveryFrameOfItsSlotWithItsTimeAndLengthFourTimesASecond) {
  const std::vector<ros::BusSlot> slots = slots_of(2.5);
  ASSERT_THAT(slots, ::testing::SizeIs(10)) << "those at 0 s to 2.25 s; that at 2.5 s is to come";
  for (const ros::BusSlot& slot : slots) {
    const auto deliveries = on_the_bus(slot);
    ASSERT_EQ(slot.id.size(), deliveries.size());
    for (std::size_t i = 0; i < deliveries.size(); ++i) {
      EXPECT_EQ(slot.id[i], deliveries[i].frame.id);
      EXPECT_EQ(slot.length_us[i], deliveries[i].bits);
      EXPECT_EQ(slot.end_us[i], deliveries[i].end_ns % kSlot_ns / 1'000);
    }
    EXPECT_EQ(slot.left_out, 0U);
  }
  EXPECT_GE(std::ranges::max(slots, {}, [](const auto& slot) { return slot.id.size(); }).id.size(),
            22U + 2U + 22U)
      << "a slot with a batch is among them";
}

TEST_F(BusSlotOfARobot, EveryAnswerIsWithinItsProvenWorstCase) {
  const can::Proof proof = msgcontroller::prove_network(humanoid());
  for (const ros::BusSlot& slot : slots_of(2.5)) {
    const auto sync = std::ranges::find(slot.id, kFullProfile.id_of(MessageKind::sync));
    ASSERT_NE(sync, slot.id.end());
    const int answered_from_us = slot.end_us[static_cast<std::size_t>(sync - slot.id.begin())];
    for (const urdf::Joint& joint : humanoid().joints) {
      const auto answer = std::ranges::find(slot.id, feedback_of(joint.name));
      ASSERT_NE(answer, slot.id.end()) << joint.name;
      const int end_us = slot.end_us[static_cast<std::size_t>(answer - slot.id.begin())];
      EXPECT_GT(end_us, answered_from_us);
      EXPECT_LE((end_us - answered_from_us) * 1'000, *proof.worst_response_ns(MessageKind::feedback));
    }
  }
}

TEST_F(BusSlotOfARobot, AJointThatHasNoPowerIsNotInIt) {
  static_cast<void>(slots_of(0.5));
  run_.apply({0.0, simulator::JointRestartsFault{.joint = "left_elbow", .duration_s = 1.0}});
  const std::vector<ros::BusSlot> dead = slots_of(1.0);
  ASSERT_GE(dead.size(), 3U);
  for (const ros::BusSlot& slot : dead) {
    EXPECT_EQ(count(slot, feedback_of("left_elbow")), 0U);
    EXPECT_EQ(count(slot, feedback_of("right_elbow")), 1U);
  }
  const std::vector<ros::BusSlot> back = slots_of(0.5);
  ASSERT_FALSE(back.empty());
  EXPECT_EQ(count(back.back(), feedback_of("left_elbow")), 1U);
}

TEST_F(BusSlotOfARobot, ErrorsAreInItAndTheFramesThatCameAgainAreLater) {
  static_cast<void>(slots_of(0.5));
  run_.apply({0.0, simulator::DisturbBusFault{.corruption = 0.2, .duration_s = 1.0}});
  std::size_t errors = 0;
  for (const ros::BusSlot& slot : slots_of(1.0)) {
    errors += count(slot, msgcontroller::kErrorOnTheBus);
    EXPECT_EQ(count(slot, feedback_of("left_elbow")), 1U) << "sent again";
  }
  EXPECT_GE(errors, 10U) << "a fifth of some 100 frames";
  EXPECT_GT(run_.bus().statistics().error_frames, errors);
}

TEST_F(BusSlotOfARobot, AForeignFrameIsInItUnderItsIdentifier) {
  static_cast<void>(slots_of(0.501));  // the slot that begins at 0.5 s is recorded
  run_.apply({0.0, simulator::ForeignFrameFault{.frame = {.id = 0x1ABC'DEF, .size = 1, .extended = true}}});
  const std::vector<ros::BusSlot> slots = slots_of(0.1);
  ASSERT_THAT(slots, ::testing::SizeIs(1));
  EXPECT_EQ(count(slots[0], 0x1ABC'DEFU | msgcontroller::kExtendedFrame), 1U);
}

TEST_F(BusSlotOfARobot, WhatNobodyWantsIsNotPublished) {
  collector_.want({Topic::clock});
  EXPECT_THAT(slots_of(0.6), ::testing::IsEmpty());
}

}  // namespace
}  // namespace gaitway::api
