// What one side notes, the other side of the shared memory sees.
#include "gaitway/manager/step_watch.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

namespace gaitway::core {
namespace {

TEST(StepWatch, TheOtherSideSeesWhoIsBeingStepped) {
  StepWatch watcher = StepWatch::make();
  StepWatch worker = StepWatch::open(dup(watcher.descriptor()));
  const std::uint32_t first = worker.add("first"), second = worker.add("second");
  EXPECT_EQ(watcher.current(), "");
  worker.enter(second);
  EXPECT_EQ(watcher.current(), "second");
  worker.enter(first);
  EXPECT_EQ(watcher.current(), "first");
  worker.leave();
  EXPECT_EQ(watcher.current(), "");
  worker.count_tick();
  EXPECT_EQ(watcher.ticks(), 1U);
}

TEST(StepWatch, MoreThanItHasRoomForAreNotNamed) {
  StepWatch watch = StepWatch::make();
  for (std::uint32_t i = 0; i < StepWatch::kCapacity; ++i) {
    EXPECT_NE(watch.add("plug-in " + std::to_string(i)), 0U);
  }
  EXPECT_EQ(watch.add("late"), 0U);
  EXPECT_EQ(watch.add("plug-in 7"), 8U) << "a plug-in that is replaced keeps its number";
}

}  // namespace
}  // namespace gaitway::core
