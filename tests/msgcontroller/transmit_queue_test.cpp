// The transmit queue offers by priority and keeps the order within an identifier.
#include "gaitway/msgcontroller/transmit_queue.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gaitway::msgcontroller {
namespace {

can::Frame frame(std::uint16_t id, std::uint8_t mark = 0) {
  return {.id = id, .size = 1, .data = {mark}};
}

TEST(TransmitQueue, OffersTheLowestIdentifierFirst) {
  std::mt19937 random(7);
  TransmitQueue queue;
  std::vector<std::uint16_t> ids;
  for (int i = 0; i < 200; ++i) {
    ids.push_back(static_cast<std::uint16_t>(random() % 0x7FF));
    ASSERT_TRUE(queue.push(frame(ids.back())));
  }
  std::sort(ids.begin(), ids.end());
  can::Frame taken;
  for (const std::uint16_t id : ids) {
    EXPECT_EQ(queue.next_id(), id);
    ASSERT_TRUE(queue.pop(taken));
    EXPECT_EQ(taken.id, id);
  }
  EXPECT_FALSE(queue.pop(taken));
}

TEST(TransmitQueue, KeepsTheOrderOfOneIdentifier) {
  TransmitQueue queue;
  for (std::uint8_t mark = 0; mark < 20; ++mark) {
    queue.push(frame(5, mark));
  }
  can::Frame taken;
  for (std::uint8_t mark = 0; mark < 20; ++mark) {
    queue.pop(taken);
    EXPECT_EQ(taken.data[0], mark);
  }
}

TEST(TransmitQueue, AFrameThatIsPutBackGoesFirstAgain) {
  TransmitQueue queue;
  queue.push(frame(5, 1));
  queue.push(frame(5, 2));
  can::Frame taken;
  queue.pop(taken);
  queue.push_front(taken);
  queue.pop(taken);
  EXPECT_EQ(taken.data[0], 1);
}

TEST(TransmitQueue, RefusesAndCountsWhatDoesNotFit) {
  TransmitQueue queue;
  for (std::size_t i = 0; i < TransmitQueue::kCapacity; ++i) {
    ASSERT_TRUE(queue.push(frame(1)));
  }
  EXPECT_FALSE(queue.push(frame(0)));
  EXPECT_EQ(queue.refused(), 1U);
  EXPECT_EQ(queue.size(), TransmitQueue::kCapacity);
}

TEST(TransmitQueue, WhatSomethingNewerMakesUselessIsDroppedAndTheRestKeepsItsOrder) {
  TransmitQueue queue;
  for (const std::uint32_t id : {0x102U, 0x008U, 0x103U, 0x300U, 0x0FFU, 0x180U}) {
    ASSERT_TRUE(queue.push({.id = id}, id == 0x0FF ? 5 : 7));
  }
  EXPECT_EQ(queue.drop_identifiers(0x100, 0x1FF), 3U);
  can::Frame frame;
  for (const std::uint32_t id : {0x008U, 0x0FFU, 0x300U}) {
    ASSERT_TRUE(queue.pop(frame));
    EXPECT_EQ(frame.id, id);
  }
  EXPECT_TRUE(queue.empty());
}

}  // namespace
}  // namespace gaitway::msgcontroller
