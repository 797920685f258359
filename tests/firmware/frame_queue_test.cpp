// The queue between the CAN interrupt and the servo loses nothing that it took.
#include "gaitway/firmware/frame_queue.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <thread>

namespace gaitway::firmware {
namespace {

ReceivedFrame numbered(std::uint32_t number) {
  ReceivedFrame received;
  received.frame.id = number & 0x7FFU;
  received.frame.size = 8;
  for (std::size_t byte = 0; byte < 8; ++byte) {
    received.frame.data[byte] = static_cast<std::uint8_t>(number >> (8 * (byte % 4)));
  }
  received.ticks = number;
  return received;
}

TEST(FrameQueue, GivesFramesBackInTheirOrderThroughManyRounds) {
  FrameQueue<8> queue;
  ReceivedFrame received;
  EXPECT_FALSE(queue.pop(received));
  std::uint32_t pushed = 0, popped = 0;
  for (int round = 0; round < 100; ++round) {
    for (int i = 0; i < 1 + round % 8; ++i) {
      ASSERT_TRUE(queue.push(numbered(pushed++)));
    }
    while (queue.pop(received)) {
      ASSERT_EQ(received.ticks, popped);
      ASSERT_EQ(received.frame, numbered(popped).frame);
      ++popped;
    }
    ASSERT_EQ(popped, pushed);
  }
  EXPECT_EQ(queue.dropped(), 0U);
}

TEST(FrameQueue, DropsAndCountsTheNewestWhenItIsFull) {
  FrameQueue<4> queue;
  for (std::uint32_t number = 0; number < 4; ++number) {
    EXPECT_TRUE(queue.push(numbered(number)));
  }
  EXPECT_FALSE(queue.push(numbered(4)));
  EXPECT_FALSE(queue.push(numbered(5)));
  EXPECT_EQ(queue.dropped(), 2U);
  ReceivedFrame received;
  ASSERT_TRUE(queue.pop(received));
  EXPECT_EQ(received.ticks, 0U);
  EXPECT_TRUE(queue.push(numbered(6)));
  for (const std::uint32_t number : {1U, 2U, 3U, 6U}) {
    ASSERT_TRUE(queue.pop(received));
    EXPECT_EQ(received.ticks, number);
  }
}

TEST(FrameQueue, AReaderBesideItsWriterSeesEachFrameWholeAndOnce) {
  constexpr std::uint32_t kFrames = 200'000;
  const auto queue = std::make_unique<FrameQueue<16>>();
  std::thread writer([&queue] {
    for (std::uint32_t number = 0; number < kFrames; ++number) {
      while (!queue->push(numbered(number))) {
        std::this_thread::yield();
      }
    }
  });
  ReceivedFrame received;
  std::uint32_t expected = 0, torn = 0;
  while (expected < kFrames) {
    if (!queue->pop(received)) {
      std::this_thread::yield();
      continue;
    }
    torn += received.ticks == expected && received.frame == numbered(expected).frame ? 0U : 1U;
    ++expected;
  }
  writer.join();
  EXPECT_EQ(torn, 0U);
}

}  // namespace
}  // namespace gaitway::firmware
