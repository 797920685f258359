// Floods of events become few lines, and nothing new is held back.
#include "event_digest.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace gaitway::api {
namespace {

using testing::HasSubstr;

ros::Log log_line(const std::string& text, std::uint8_t level = 30) {
  ros::Log log;
  log.level = level;
  log.name = "supervisor";
  log.msg = text;
  return log;
}

TEST(EventDigest, AFloodIsToldTwelveTimesAMinuteAtMost) {
  EventDigest digest;
  int told = 0;
  for (std::int64_t ms = 0; ms < 60'000; ++ms) {
    const std::int64_t now_ns = ms * 1'000'000;
    if (ms % 34 == 0) {
      told += digest.is_news(log_line("batch " + std::to_string(ms) + " is 3 ms late"), now_ns) ? 1 : 0;
    }
    while (digest.repeats(now_ns)) {
      ++told;
    }
  }
  EXPECT_GE(told, 5);
  EXPECT_LE(told, 12);
}

TEST(EventDigest, TheCountAndTheNewestAreTold) {
  EventDigest digest;
  EXPECT_TRUE(digest.is_news(log_line("batch 1 is late"), 0));
  EXPECT_FALSE(digest.is_news(log_line("batch 22 is late"), 1));
  EXPECT_FALSE(digest.is_news(log_line("batch 333 is late"), 2));
  EXPECT_FALSE(digest.repeats(EventDigest::kPeriod_ns - 1));
  const auto log = digest.repeats(EventDigest::kPeriod_ns);
  ASSERT_TRUE(log);
  EXPECT_THAT(log->msg, HasSubstr("batch 333 is late (the newest of 2 like it in 10 s)"));
  EXPECT_FALSE(digest.repeats(EventDigest::kPeriod_ns));
}

TEST(EventDigest, OneRepeatIsToldAsItIs) {
  EventDigest digest;
  EXPECT_TRUE(digest.is_news(log_line("reloaded"), 0));
  EXPECT_FALSE(digest.is_news(log_line("reloaded"), 1));
  EXPECT_EQ(digest.repeats(EventDigest::kPeriod_ns)->msg, "reloaded");
}

TEST(EventDigest, OtherTextsLevelsAndSourcesAreNews) {
  EventDigest digest;
  EXPECT_TRUE(digest.is_news(log_line("batch 1 is late"), 0));
  EXPECT_TRUE(digest.is_news(log_line("batch 1 is early"), 0));
  EXPECT_TRUE(digest.is_news(log_line("batch 1 is late", 40), 0));
  ros::Log other = log_line("batch 1 is late");
  other.name = "trajectory";
  EXPECT_TRUE(digest.is_news(other, 0));
}

TEST(EventDigest, WhatIsToldNoMoreIsNewsAgain) {
  EventDigest digest;
  EXPECT_TRUE(digest.is_news(log_line("reloaded"), 0));
  EXPECT_FALSE(digest.repeats(EventDigest::kPeriod_ns));
  EXPECT_TRUE(digest.is_news(log_line("reloaded"), EventDigest::kPeriod_ns + 1));
}

TEST(EventDigest, BeyondItsMemoryEventsAreToldAsTheyCome) {
  EventDigest digest;
  for (char a = 'a'; a <= 'z'; ++a) {
    for (char b = 'a'; b <= 'z'; ++b) {
      EXPECT_TRUE(digest.is_news(log_line({a, b}), 0));
    }
  }
  EXPECT_TRUE(digest.is_news(log_line("zz"), 0));
  EXPECT_FALSE(digest.is_news(log_line("aa"), 0));
}

}  // namespace
}  // namespace gaitway::api
