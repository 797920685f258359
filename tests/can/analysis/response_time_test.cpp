// The response-time analysis against published examples and values worked out by hand.
#include "gaitway/can/analysis/response_time.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/can/frame.hpp"

namespace gaitway::can {
namespace {

constexpr std::int64_t kUs = 1000, kMs = 1'000'000;

// Eight data bytes, deadline = period.
AnalysedMessage message(std::uint32_t id, std::int64_t period_ns, std::int64_t jitter_ns = 0) {
  AnalysedMessage made;
  made.name = std::string("m").append(std::to_string(id));
  made.id = id;
  made.period_ns = made.deadline_ns = period_ns;
  made.jitter_ns = jitter_ns;
  return made;
}

AnalysedMessage of_bits(int bits, AnalysedMessage made) {
  made.length_bits = bits;
  return made;
}

std::vector<std::optional<std::int64_t>> worst_us(const std::vector<AnalysedMessage>& messages,
                                                  const AnalysisOptions& options = {}) {
  std::vector<std::optional<std::int64_t>> all;
  for (const MessageResponse& response : response_times(messages, options)) {
    all.push_back(response.worst_response_ns);
    if (all.back()) {
      EXPECT_EQ(*all.back() % kUs, 0);
      *all.back() /= kUs;
    }
  }
  return all;
}

using Times = std::vector<std::optional<std::int64_t>>;

// The three messages of Davis, Burns, Bril and Lukkien (2007) at 125 kbit/s: 7 bytes are 125 bits = 1 ms. The
// third message's busy period: 1 + 1 + 1 ms, at 2.5 ms A again, at 3.5 ms B again, at 5 ms A again: it ends
// at 7 ms. Its first instance waits 2 ms (R = 3 ms), its second, released at 3.5 ms, waits until 6 ms: R
// = 3.5 ms. The older analysis looked at the first alone and passed a deadline of 3.25 ms.
std::vector<AnalysedMessage> counter_example() {
  std::vector<AnalysedMessage> messages{message(1, 2500 * kUs), message(2, 3500 * kUs),
                                        message(3, 3500 * kUs)};
  for (AnalysedMessage& one : messages) {
    one.bytes = 7;
    one.deadline_ns = 3250 * kUs;
  }
  messages[0].deadline_ns = 2500 * kUs;
  return messages;
}

TEST(ResponseTime, TheSecondInstanceOfThePublishedCounterExampleMissesItsDeadline) {
  const auto responses = response_times(counter_example(), {.bit_time_ns = 8000, .errors = {}});
  ASSERT_EQ(responses.size(), 3U);
  for (const MessageResponse& response : responses) {
    EXPECT_EQ(response.length_bits, 125);
  }
  EXPECT_EQ(responses[0].worst_response_ns, 2000 * kUs);
  EXPECT_EQ(responses[1].worst_response_ns, 3000 * kUs);
  EXPECT_EQ(responses[2].worst_response_ns, 3500 * kUs);
  EXPECT_EQ(responses[0].blocking_ns, 1000 * kUs);
  EXPECT_EQ(responses[1].blocking_ns, 1000 * kUs);
  EXPECT_EQ(responses[2].blocking_ns, 0);
  EXPECT_EQ(responses[2].instances, 2);
  EXPECT_TRUE(responses[0].schedulable());
  EXPECT_TRUE(responses[1].schedulable());
  EXPECT_FALSE(responses[2].schedulable());
  EXPECT_EQ(responses[2].slack_ns(), -250 * kUs);
}

TEST(ResponseTime, TheCounterExampleMeetsADeadlineOfExactlyItsBound) {
  auto messages = counter_example();
  messages[2].deadline_ns = 3500 * kUs;
  EXPECT_TRUE(all_schedulable(messages, {.bit_time_ns = 8000, .errors = {}}));
  messages[2].deadline_ns = 3500 * kUs - 1;
  EXPECT_FALSE(all_schedulable(messages, {.bit_time_ns = 8000, .errors = {}}));
}

// `joints` trajectories (80 ms) and feedbacks (10 ms) and one user command, all with eight bytes, in the
// given order. Returns the worst of each: user command, trajectory, feedback.
Times robot_us(int joints, const std::string& order) {
  std::vector<AnalysedMessage> messages;
  std::vector<std::size_t> kinds;
  for (const char kind : order) {
    for (int i = 0; i < (kind == 'u' ? 1 : joints); ++i) {
      messages.push_back(
          message(static_cast<std::uint32_t>(messages.size() + 1), kind == 't' ? 80 * kMs : 10 * kMs));
      kinds.push_back(std::string("utf").find(kind));
    }
  }
  Times worst(3, 0);
  const Times all = worst_us(messages);
  for (std::size_t i = 0; i < all.size(); ++i) {
    worst[kinds[i]] = std::max(worst[kinds[i]], all[i]);
  }
  return worst;
}

TEST(ResponseTime, RobotsInThePapersOrderAndByDeadline) {
  EXPECT_EQ(robot_us(12, "tfu"), (Times{3375, 1755, 3375}));
  EXPECT_EQ(robot_us(22, "tfu"), (Times{6075, 3105, 6075}));
  EXPECT_EQ(robot_us(22, "uft"), (Times{270, 6075, 3240}));
}

// With sensor and position in frames of their own, 22 joints send 67 messages.
TEST(ResponseTime, ARobotWithSeparateSensorAndPositionFrames) {
  std::vector<AnalysedMessage> messages;
  for (std::uint32_t i = 0; i < 67; ++i) {
    messages.push_back(message(i, i < 22 ? 80 * kMs : 10 * kMs));
  }
  const Times all = worst_us(messages);
  EXPECT_EQ(all[21], 3105);
  EXPECT_EQ(all[43], 6075);
  EXPECT_EQ(all[66], 9045);
}

// The third message could start at 150 us.
TEST(ResponseTime, AMoreUrgentFrameThatComesAtAStartOfFrameGoesFirst) {
  const auto with_first_every = [](std::int64_t period_us) {
    return worst_us({of_bits(100, message(1, period_us * kUs)), of_bits(50, message(2, 10 * kMs)),
                     of_bits(40, message(3, 10 * kMs))});
  };
  EXPECT_EQ(with_first_every(151), (Times{150, 190, 190}));
  EXPECT_EQ(with_first_every(150), (Times{150, 190, 290}));
}

TEST(ResponseTime, TheResponseCountsFromTheNominalReleaseAndJitterBringsOthersTwice) {
  const auto with_jitters = [](std::int64_t first_us, std::int64_t third_us) {
    return worst_us({of_bits(100, message(1, 400 * kUs, first_us * kUs)), of_bits(100, message(2, 4 * kMs)),
                     of_bits(101, message(3, 4 * kMs, third_us * kUs))});
  };
  EXPECT_EQ(with_jitters(100, 0), (Times{301, 301, 301}));
  EXPECT_EQ(with_jitters(200, 7), (Times{401, 401, 408})) << "the first comes at 0 and again at 200 us";
}

// Deadline beyond the period: with 60 us of blocking, its instances wait for 112, 200, 314, 402, 516, 604 us
// and so on; the fifth responds latest: 516 - 400 + 62.
TEST(ResponseTime, AnInstanceFarIntoTheBusyPeriodMayBeTheWorst) {
  std::vector messages{of_bits(26, message(1, 70 * kUs)), of_bits(62, message(2, 100 * kUs)),
                       of_bits(60, message(3, 1000 * kMs))};
  messages[1].deadline_ns = 178 * kUs;
  const MessageResponse response = response_times(messages)[1];
  EXPECT_EQ(response.worst_response_ns, 178 * kUs);
  EXPECT_GT(response.instances, 4);
  EXPECT_TRUE(response.schedulable());
  EXPECT_EQ(response.slack_ns(), 0);
}

TEST(ResponseTime, ABurstOfErrorsCostsEachARepetitionOfTheLongestFrame) {
  const auto lone = std::vector{message(1, 10 * kMs)};
  EXPECT_EQ(worst_us(lone, {.bit_time_ns = 1000, .errors = burst_errors(2, 0)}), (Times{2 * 166 + 135}));
  // 135 + 2 * 166 = 467: at 300 us a third error has come, 633: at 600 us a fourth, 799; that is all.
  EXPECT_EQ(worst_us(lone, {.bit_time_ns = 1000, .errors = burst_errors(2, 300 * kUs)}), (Times{799}));
  // Exactly at the end of the frame, nothing can be destroyed any more.
  EXPECT_EQ(worst_us(lone, {.bit_time_ns = 1000, .errors = burst_errors(2, 467 * kUs)}), (Times{467}));
  EXPECT_EQ(worst_us(lone, {.bit_time_ns = 1000, .errors = burst_errors(2, 466 * kUs)}), (Times{633}));
}

TEST(ResponseTime, AnErrorRepeatsTheLongestFrameOfThatPriorityOrAbove) {
  const std::vector messages{of_bits(60, message(1, 10 * kMs)), of_bits(100, message(2, 10 * kMs)),
                             of_bits(130, message(3, 10 * kMs))};
  EXPECT_EQ(worst_us(messages, {.bit_time_ns = 1000, .errors = burst_errors(1, 0)}),
            (Times{130 + 60 + 31 + 60, 130 + 160 + 31 + 100, 290 + 31 + 130}));
}

TEST(ResponseTime, AJamAddsItsDurationAndSourcesAddUp) {
  const auto lone = std::vector{message(1, 10 * kMs)};
  EXPECT_EQ(worst_us(lone, {.bit_time_ns = 1000, .errors = jam(2 * kMs)}), (Times{2000 + 166 + 135}));
  ErrorModel both = jam(2 * kMs);
  both.push_back({.burst = 1, .interval_ns = 0, .duration_ns = 0});
  EXPECT_EQ(worst_us(lone, {.bit_time_ns = 1000, .errors = both}), (Times{2000 + 2 * 166 + 135}));
  EXPECT_EQ(worst_us(lone, {.bit_time_ns = 1000, .errors = jam(2 * kMs, 3 * kMs)}), (Times{2301}));
  // 1166 us each: 1301, 2467 and 3633 us lie past the next one, 4799 us does not.
  EXPECT_EQ(worst_us(lone, {.bit_time_ns = 1000, .errors = jam(1 * kMs, 1200 * kUs)}), (Times{4799}));
}

TEST(ResponseTime, ThereIsNoBoundWhereTheBusIsFull) {
  const std::vector messages{of_bits(100, message(1, 200 * kUs)), of_bits(100, message(2, 190 * kUs)),
                             of_bits(150, message(3, 100 * kMs)), of_bits(170, message(4, 100 * kMs))};
  const auto responses = response_times(messages);
  EXPECT_EQ(responses[0].worst_response_ns, 270 * kUs);
  EXPECT_FALSE(responses[1].worst_response_ns);
  EXPECT_FALSE(responses[2].worst_response_ns);
  EXPECT_FALSE(responses[3].worst_response_ns);
  EXPECT_EQ(responses[1].blocking_ns, 170 * kUs);
  EXPECT_FALSE(responses[1].schedulable());
  EXPECT_FALSE(responses[1].slack_ns());
  EXPECT_FALSE(response_times(std::vector{message(1, 1 * kMs)},
                              {.bit_time_ns = 1000, .errors = burst_errors(1, 191 * kUs)})[0]
                   .worst_response_ns)
      << "135/1000 + 166/191 > 1";
}

TEST(ResponseTime, AFullBusIsBoundedOnlyWhereNothingComesOnTop) {
  EXPECT_EQ(worst_us({of_bits(100, message(1, 100 * kUs))}), (Times{100}));
  EXPECT_EQ(worst_us({of_bits(100, message(1, 100 * kUs)), of_bits(1, message(2, 100 * kMs))}),
            (Times{std::nullopt, std::nullopt}));
}

TEST(ResponseTime, ExtendedFramesAreLongerAndLoseAgainstBaseFramesOfTheSameLeadingBits) {
  std::vector messages{message(0x100, 10 * kMs), message(0x100U << 18U, 10 * kMs),
                       message(0x0FFU << 18U, 10 * kMs)};
  messages[1].extended = messages[2].extended = true;
  const auto responses = response_times(messages);
  EXPECT_EQ(responses[1].length_bits, 160);
  EXPECT_EQ(responses[2].worst_response_ns, 320 * kUs);
  EXPECT_EQ(responses[0].worst_response_ns, (160 + 160 + 135) * kUs);
  EXPECT_EQ(responses[1].worst_response_ns, (160 + 160 + 135) * kUs);
  EXPECT_EQ(responses[1].blocking_ns, 0);
}

TEST(ResponseTime, AFifoQueueGivesAllItsMessagesTheResponseOfItsLeastUrgent) {
  std::vector messages{message(1, 10 * kMs), message(2, 10 * kMs), message(3, 10 * kMs),
                       message(4, 10 * kMs)};
  messages[0].fifo = messages[2].fifo = 7;
  // The second is more urgent than the queue's last, so it comes between; and it meets the queue's first one
  // up to 540 - 135 us late, but not twice within 10 ms.
  EXPECT_EQ(worst_us(messages), (Times{540, 405, 540, 540}));
  messages[0].period_ns = 600 * kUs;
  // Now it does not pass 600 us: w = 135 + 135 * ceil((w + 405 + 1) / 600) from 270 on is 405: twice.
  EXPECT_EQ(worst_us(messages)[1], 540);
}

TEST(ResponseTime, NeighboursInAFifoQueueDoNotDelayThoseBelowMore) {
  std::vector messages{message(1, 300 * kUs), message(2, 10 * kMs), message(3, 10 * kMs)};
  const Times plain = worst_us(messages);
  messages[0].fifo = messages[1].fifo = 0;
  EXPECT_EQ(worst_us(messages)[2], plain[2]);
}

TEST(ResponseTime, AMessageInAFifoQueueWaitsForEarlierInstancesOfTheOthers) {
  std::vector messages{of_bits(100, message(1, 150 * kUs, 300 * kUs)), of_bits(100, message(2, 10 * kMs))};
  messages[0].fifo = messages[1].fifo = 0;
  // Three of the first arrive at once; the next at 150 us, behind the second.
  EXPECT_EQ(worst_us(messages)[1], 400);
  messages[1].jitter_ns = 20 * kUs;
  EXPECT_EQ(worst_us(messages)[1], 420);
  // Now one arrives at 0 and one at 10 us; worst is to come just behind that: 200 - 10 + 100 us, and jitter.
  messages[0].jitter_ns = 140 * kUs;
  EXPECT_EQ(worst_us(messages)[1], 310);
}

TEST(ResponseTime, LoadCountsTheLongestFrames) {
  EXPECT_DOUBLE_EQ(bus_load(std::vector{message(1, 1 * kMs), message(2, 2 * kMs)}), 0.135 + 0.0675);
  EXPECT_DOUBLE_EQ(bus_load(std::vector{message(1, 1 * kMs)}, 2000), 0.27);
}

template <class Change>
void expect_refused(Change change, const std::string& part) {
  std::vector messages{message(1, 10 * kMs), message(2, 10 * kMs)};
  AnalysisOptions options;
  change(messages[1], options);
  try {
    (void)response_times(messages, options);
    ADD_FAILURE() << "not refused: " << part;
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(part));
  }
}

TEST(ResponseTime, WhatCannotBeIsRefusedByName) {
  using M = AnalysedMessage;
  using O = AnalysisOptions;
  expect_refused([](M& m, O&) { m.bytes = 9; }, "message 'm2': bytes = 9: must be 0..8");
  expect_refused([](M& m, O&) { m.period_ns = 0; }, "message 'm2': period_ns = 0");
  expect_refused([](M& m, O&) { m.jitter_ns = -1; }, "message 'm2': jitter_ns = -1");
  expect_refused([](M& m, O&) { m.deadline_ns = 0; }, "message 'm2': deadline_ns = 0");
  expect_refused([](M& m, O&) { m.id = 0x800; }, "message 'm2': id = 2048: must be 0..2047");
  expect_refused([](M& m, O&) { m.id = 1; }, "message 'm2': id = 1: message 'm1' has it already");
  expect_refused([](M&, O& o) { o.bit_time_ns = 0; }, "bit_time_ns = 0");
  expect_refused([](M&, O& o) { o.errors = burst_errors(-1, 0); }, "errors: burst = -1");
  expect_refused([](M&, O& o) { o.errors = jam(-1); }, "errors: duration_ns = -1");
}

}  // namespace
}  // namespace gaitway::can
