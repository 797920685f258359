// What a picture of the time line shows of its events.
#include "gaitway/timeline/timed_event.hpp"

#include <gtest/gtest.h>

namespace gaitway::timeline {
namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;

std::vector<std::int64_t> instants_ms(const std::vector<const TimedEvent*>& events) {
  std::vector<std::int64_t> instants;
  for (const TimedEvent* event : events) instants.push_back(event->at_ns / kMillisecond_ns);
  return instants;
}

TEST(WithoutRenewals, AVelocityThatIsHeldIsOneCommand) {
  std::vector<TimedEvent> events;
  for (std::int64_t at_ms = 0; at_ms < 3000; at_ms += 100) {
    events.push_back({at_ms * kMillisecond_ns, false, "walk: [0.1, 0, 0]"});
  }
  events.push_back({3000 * kMillisecond_ns, false, "walk: [0.2, 0, 0]"});
  events.push_back({3100 * kMillisecond_ns, false, "walk: [0.1, 0, 0]"});
  EXPECT_EQ(instants_ms(without_renewals(events)), (std::vector<std::int64_t>{0, 3000, 3100}));
}

TEST(WithoutRenewals, WhatIsSaidAnewAfterAWhileIsShown) {
  const std::vector<TimedEvent> events{{0, true, "motion: kick"},
                                       {1001 * kMillisecond_ns, true, "motion: kick"}};
  EXPECT_EQ(without_renewals(events).size(), 2U);
}

TEST(WithoutRenewals, PushesAndFaultsAreEachShown) {
  const std::vector<TimedEvent> events{{0, false, "push: {body: trunk}"}, {1, false, "push: {body: trunk}"},
                                       {2, false, "walk: [0.1, 0, 0]"},   {3, false, "fault: {kind: jam}"},
                                       {4, false, "walk: [0.1, 0, 0]"},   {5, false, "fault: {kind: jam}"}};
  EXPECT_EQ(without_renewals(events).size(), 5U) << "the walk is held on";
}

}  // namespace
}  // namespace gaitway::timeline
