// Which of the waiting frames goes first.
#include "gaitway/can/frame_heap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace gaitway::can {
namespace {

std::vector<Frame> drained(FrameHeap& heap) {
  std::vector<Frame> frames;
  for (; !heap.empty(); heap.pop()) {
    frames.push_back(heap.top());
  }
  return frames;
}

TEST(FrameHeap, FramesComeInTheOrderOfArbitrationAndThoseOfOneIdentifierInTheirOwn) {
  std::mt19937 random(3);
  for (int round = 0; round < 50; ++round) {
    FrameHeap heap;
    std::vector<Frame> pushed;
    for (std::uint8_t i = 0; i < 200; ++i) {
      Frame frame{.id = static_cast<std::uint32_t>(random() % 20), .size = 1, .data = {i}};
      frame.extended = random() % 3 == 0;
      frame.remote = random() % 3 == 0;
      pushed.push_back(frame);
      ASSERT_TRUE(heap.push(frame));
    }
    std::stable_sort(pushed.begin(), pushed.end(),
                     [](const Frame& a, const Frame& b) { return arbitration_key(a) < arbitration_key(b); });
    EXPECT_EQ(drained(heap), pushed);
  }
}

TEST(FrameHeap, AFullHeapRefusesAndKeepsWhatItHas) {
  FrameHeap heap;
  for (std::size_t i = 0; i < FrameHeap::kCapacity; ++i) {
    ASSERT_TRUE(heap.push({.id = 5}));
  }
  EXPECT_FALSE(heap.push({.id = 1}));
  EXPECT_EQ(heap.size(), FrameHeap::kCapacity);
  EXPECT_EQ(heap.top().id, 5U);
  EXPECT_EQ(heap.clear(), FrameHeap::kCapacity);
  EXPECT_TRUE(heap.empty());
  EXPECT_TRUE(heap.push({.id = 1}));
}

}  // namespace
}  // namespace gaitway::can
