// One time slot of 25 is told to those who look on: what was on the bus in it, and nothing that was not.
#include "gaitway/msgcontroller/slot_record.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "message_controller_fixture.hpp"

namespace gaitway::msgcontroller {
namespace {

using can::kFullProfile;
using can::MessageKind;
using ::testing::ElementsAre;
using ::testing::SizeIs;

constexpr std::int64_t kBetween_ns = kSlotsBetweenRecords * kSlot_ns;

struct Entry {
  std::uint32_t id = 0;
  int end_us = 0, length_us = 0;
};

class SlotRecordTest : public MessageControllerTest {
 protected:
  // What is told of the `nth` slot that is recorded (from 1: that at 250 ms). `disturb` acts in each of its
  // milliseconds.
  std::vector<Entry> recorded(int nth, const std::function<void(std::int64_t in_slot_ns)>& disturb = {}) {
    run_until(nth * kBetween_ns);
    every_millisecond = [&] {
      if (disturb && now_ns_ < nth * kBetween_ns + kSlot_ns) {
        disturb(now_ns_ - nth * kBetween_ns);
      }
    };
    run_until(nth * kBetween_ns + kSlot_ns + kMillisecond_ns);
    every_millisecond = {};
    EXPECT_TRUE(reader_.read(slot_));
    EXPECT_EQ(slot_.stamp_ns, nth * kBetween_ns);
    std::vector<Entry> entries;
    for (std::uint32_t i = 0; i < slot_.frame_count; ++i) {
      entries.push_back({slot_.id[i], slot_.end_us[i], slot_.length_us[i]});
    }
    return entries;
  }
  static std::vector<Entry> of(const std::vector<Entry>& entries, std::uint32_t id) {
    std::vector<Entry> found;
    std::ranges::copy_if(entries, std::back_inserter(found),
                         [id](const Entry& entry) { return entry.id == id; });
    return found;
  }
  static std::uint32_t feedback_of(can::NodeId node) {
    return kFullProfile.id_of(MessageKind::feedback, node);
  }

  msgclient::Reader<BusSlot> reader_ = client_.read<BusSlot>("bus_slot");
  BusSlot slot_{};
};

TEST_F(SlotRecordTest, HasTheSyncAndEveryJointsFeedbackWithTheirTimesAndLengths) {
  const std::vector<Entry> entries = recorded(1);
  const std::vector<Entry> sync = of(entries, kFullProfile.id_of(MessageKind::sync));
  ASSERT_THAT(sync, SizeIs(1)) << "a frame of the message controller's own";
  EXPECT_EQ(sync[0].end_us, 10);
  EXPECT_EQ(
      sync[0].length_us,
      can::frame_bits(can::encode(kFullProfile, can::Sync{.cycle = 3, .slot = 1, .batch_committed = false})));
  for (const urdf::Joint& joint : robot_.joints) {
    const std::vector<Entry> feedback = of(entries, feedback_of(joint.node));
    ASSERT_THAT(feedback, SizeIs(1)) << joint.name;
    EXPECT_EQ(feedback[0].end_us, 10) << "with the SYNC, on this small bus";
    EXPECT_GE(feedback[0].length_us, 111);
    EXPECT_LE(feedback[0].length_us, can::worst_case_bits(8));
  }
  EXPECT_EQ(slot_.cycle, 3U);
  EXPECT_EQ(slot_.slot, 1U);
  EXPECT_EQ(slot_.left_out, 0U);
}

TEST_F(SlotRecordTest, HasNotWhatWasLost) {
  bus_.drop_from_joint = [](const can::Frame& frame) { return frame.id == feedback_of(7); };
  const std::vector<Entry> entries = recorded(1);
  EXPECT_THAT(of(entries, feedback_of(7)), SizeIs(0));
  EXPECT_THAT(of(entries, feedback_of(6)), SizeIs(1));
}

TEST_F(SlotRecordTest, HasALateFrameWhenItCame) {
  can::Frame held;
  bus_.drop_from_joint = [&held](const can::Frame& frame) {
    held = frame.id == feedback_of(7) ? frame : held;
    return frame.id == feedback_of(7);
  };
  const std::vector<Entry> entries = recorded(1, [&](std::int64_t in_slot_ns) {
    if (in_slot_ns == 9 * kMillisecond_ns) {
      controller_.on_frame(held, now_ns_ + 500'000);
    }
  });
  const std::vector<Entry> late = of(entries, feedback_of(7));
  ASSERT_THAT(late, SizeIs(1));
  EXPECT_EQ(late[0].end_us, 9'500);
}

TEST_F(SlotRecordTest, HasErrorsForeignFramesAndWhatFormatTheyHave) {
  const std::vector<Entry> entries = recorded(1, [&](std::int64_t in_slot_ns) {
    if (in_slot_ns == 2 * kMillisecond_ns) {
      const std::int64_t at_ns = now_ns_ + 345'000;
      controller_.on_notice({can::BusNotice::Kind::error, {{}, at_ns, at_ns}});
      bus_.intrude(controller_, {.id = 0x1234'567, .size = 0, .extended = true}, now_ns_);
      bus_.intrude(controller_, {.id = 0x7AB, .size = 2, .remote = true}, now_ns_);
    }
  });
  const std::vector<Entry> error = of(entries, kErrorOnTheBus);
  ASSERT_THAT(error, SizeIs(1));
  EXPECT_EQ(error[0].end_us, 2'345);
  EXPECT_EQ(error[0].length_us, 0);
  EXPECT_THAT(of(entries, 0x1234'567U | kExtendedFrame), SizeIs(1));
  EXPECT_THAT(of(entries, 0x7ABU | kRemoteFrame), SizeIs(1));
}

TEST_F(SlotRecordTest, CountsWhatItHasNoRoomFor) {
  const std::vector<Entry> entries = recorded(1, [&](std::int64_t in_slot_ns) {
    for (int i = 0; in_slot_ns == 5 * kMillisecond_ns && i < 100; ++i) {
      controller_.on_frame({.id = 0x7AB, .size = 0}, now_ns_ + i);
    }
  });
  EXPECT_THAT(entries, SizeIs(kSlotFrames));
  EXPECT_EQ(slot_.left_out, 100 + 1 + robot_.joints.size() - kSlotFrames)
      << "a SYNC, and every joint's feedback";
}

TEST_F(SlotRecordTest, EverySlotOfTheCycleHasItsTurnAndIsTheOnlyOneInItsRecord) {
  std::set<std::uint32_t> slots;
  for (int nth = 1; nth <= facts::kSlotsPerCycle; ++nth) {
    const std::vector<Entry> entries = recorded(nth);
    slots.insert(slot_.slot);
    EXPECT_THAT(of(entries, kFullProfile.id_of(MessageKind::sync)), SizeIs(1)) << nth;
  }
  EXPECT_THAT(slots, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
}

TEST_F(SlotRecordTest, NewsOfAnotherSlotIsLeftOut) {
  const std::vector<Entry> entries = recorded(1, [&](std::int64_t in_slot_ns) {
    if (in_slot_ns == 0) {
      controller_.on_notice({can::BusNotice::Kind::error, {{}, now_ns_ - 1, now_ns_ - 1}});
      controller_.on_notice(
          {can::BusNotice::Kind::error, {{}, now_ns_ + kSlot_ns + 1, now_ns_ + kSlot_ns + 1}});
    }
  });
  EXPECT_THAT(of(entries, kErrorOnTheBus), SizeIs(0));
}

}  // namespace
}  // namespace gaitway::msgcontroller
