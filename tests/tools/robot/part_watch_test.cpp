// One part's life in made-up time: when it is started, when it counts as hung, how long it is left alone.
#include "tools/robot/keeper/part_watch.hpp"

#include <gmock/gmock.h>

namespace gaitway::tools {
namespace {

using Wish = PartWatch::Wish;
constexpr std::int64_t kMs = 1'000'000, kSecond = 1'000'000'000;

class PartWatchTest : public testing::Test {
 protected:
  // Starts and makes progress, so that it works.
  void begin(std::int64_t now_ns) {
    ASSERT_EQ(watch.step(now_ns, true), Wish::start);
    watch.on_start(now_ns);
    EXPECT_FALSE(watch.on_progress(++count, now_ns)) << "the first count is where it begins";
    EXPECT_TRUE(watch.on_progress(++count, now_ns + kMs));
    ASSERT_EQ(watch.state(), PartState::works);
  }
  void fail(std::int64_t now_ns) { watch.on_end("ended with code 1", now_ns); }

  PartWatch watch{{.start_ns = 5 * kSecond, .hang_ns = 300 * kMs}};
  std::uint64_t count = 100;
};

TEST_F(PartWatchTest, StartsOnlyWhenWhatItNeedsWorks) {
  EXPECT_EQ(watch.step(kSecond, false), Wish::nothing);
  EXPECT_EQ(watch.step(kSecond, true), Wish::start);
}

TEST_F(PartWatchTest, WhatMakesProgressIsLeftAlone) {
  begin(kSecond);
  for (std::int64_t now_ns = kSecond; now_ns < 3 * kSecond; now_ns += 299 * kMs) {
    watch.on_progress(++count, now_ns);
    EXPECT_EQ(watch.step(now_ns + 299 * kMs, true), Wish::nothing);
  }
  EXPECT_EQ(watch.restarts(), 0u);
}

TEST_F(PartWatchTest, WhatMakesNoneIsEndedAfterItsPatienceThoughItLives) {
  begin(kSecond);
  watch.on_progress(count, kSecond + 200 * kMs);  // the same count again is no progress
  EXPECT_EQ(watch.step(kSecond + 300 * kMs, true), Wish::nothing);
  EXPECT_EQ(watch.step(kSecond + 302 * kMs, true), Wish::kill);
  watch.describe_hang(": it was stopped (SIGSTOP)");
  EXPECT_EQ(watch.step(kSecond + 310 * kMs, true), Wish::nothing) << "it is killed once";
  watch.on_end("was ended by signal 9 (Killed)", kSecond + 320 * kMs);
  EXPECT_EQ(watch.reason(), "made no progress for 301 ms and was ended: it was stopped (SIGSTOP)");
  EXPECT_EQ(watch.step(kSecond + 320 * kMs, true), Wish::start);
}

TEST_F(PartWatchTest, AStartMayTakeLonger) {
  ASSERT_EQ(watch.step(0, true), Wish::start);
  watch.on_start(0);
  EXPECT_EQ(watch.step(5 * kSecond, true), Wish::nothing);
  EXPECT_EQ(watch.step(5 * kSecond + 1, true), Wish::kill);
}

TEST_F(PartWatchTest, TheFirstRestartIsAtOnceThenPausesGrowAndNeverEnd) {
  begin(0);
  std::int64_t now_ns = kSecond;
  std::vector<std::int64_t> pauses_ms;
  for (int failure = 0; failure < 200; ++failure) {
    fail(now_ns);
    const std::int64_t due_ns = watch.due_ns();
    pauses_ms.push_back((due_ns - now_ns) / kMs);
    EXPECT_EQ(watch.step(due_ns - 1, true), Wish::nothing);
    ASSERT_EQ(watch.step(due_ns, true), Wish::start);
    watch.on_start(due_ns);
    now_ns = due_ns + kMs;
  }
  pauses_ms.resize(9);
  EXPECT_THAT(pauses_ms, testing::ElementsAre(0, 100, 200, 400, 800, 1600, 3200, 6400, 10000));
  EXPECT_EQ(watch.restarts(), 200u);
  EXPECT_EQ(watch.failures(), 200u);
}

TEST_F(PartWatchTest, GoodWorkMakesTheNextFailureTheFirst) {
  begin(0);
  fail(kSecond / 2);
  begin(kSecond / 2);
  fail(kSecond);
  EXPECT_EQ(watch.failures(), 2u) << "it had not worked for long";
  // However often it is killed: who has worked is wanted back at once.
  std::int64_t now_ns = 2 * kSecond;
  for (int kill = 0; kill < 100; ++kill) {
    begin(now_ns);
    for (const std::int64_t end_ns = now_ns + kSecond + 210 * kMs; now_ns < end_ns; now_ns += 100 * kMs) {
      watch.on_progress(++count, now_ns);
      ASSERT_EQ(watch.step(now_ns, true), Wish::nothing);
    }
    fail(now_ns);
    EXPECT_EQ(watch.failures(), 1u);
    EXPECT_EQ(watch.due_ns(), now_ns) << "at once";
  }
}

TEST_F(PartWatchTest, WhatCannotBeSeenIsNotHung) {
  begin(0);
  for (std::int64_t now_ns = 0; now_ns < 10 * kSecond; now_ns += 100 * kMs) {
    watch.on_unseen(now_ns);
    ASSERT_EQ(watch.step(now_ns, true), Wish::nothing);
  }
}

// Its memory was made anew: it is to come there by itself, or it is started again.
TEST_F(PartWatchTest, MovesToNewGroundInTimeOrIsEnded) {
  begin(0);
  watch.on_new_ground(200 * kMs, kSecond);
  EXPECT_FALSE(watch.on_progress(7, kSecond + 10 * kMs));
  EXPECT_EQ(watch.step(kSecond + 190 * kMs, true), Wish::nothing);
  watch.on_progress(8, kSecond + 195 * kMs);
  EXPECT_EQ(watch.step(kSecond + 400 * kMs, true), Wish::nothing) << "it has come";
  watch.on_new_ground(200 * kMs, 2 * kSecond);
  EXPECT_EQ(watch.step(2 * kSecond + 201 * kMs, true), Wish::kill) << "it has not";
}

TEST_F(PartWatchTest, TellsHowLongItWasAway) {
  begin(0);
  EXPECT_FALSE(watch.ended_ns());
  fail(kSecond);
  ASSERT_EQ(watch.step(kSecond, true), Wish::start);
  watch.on_start(kSecond);
  fail(kSecond + 500 * kMs);
  EXPECT_EQ(watch.ended_ns(), kSecond) << "since it last worked";
  begin(2 * kSecond);
  EXPECT_FALSE(watch.ended_ns());
}

TEST_F(PartWatchTest, SwitchedOffItIsLeftAlone) {
  begin(0);
  watch.switch_off();
  EXPECT_EQ(watch.step(100 * kSecond, true), Wish::nothing);
  EXPECT_STREQ(name_of(watch.state()), "off");
}

}  // namespace
}  // namespace gaitway::tools
