// When what is wrong on the network becomes an event.
#include "gaitway/core/events.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gaitway::core {
namespace {

std::vector<std::string> told(NetworkEvents& events, const NetworkHealth& health) {
  std::vector<std::string> texts;
  events.compare(health, [&](std::string_view text) { texts.emplace_back(text); });
  return texts;
}

TEST(NetworkEvents, AHealthyNetworkIsNotWorthAWord) {
  NetworkEvents events;
  EXPECT_TRUE(told(events, NetworkHealth{}).empty());
}

TEST(NetworkEvents, ACauseIsToldWhenItIsNewAndWhenItHasDoubled) {
  NetworkEvents events;
  NetworkHealth health{};
  int texts = 0;
  for (int count = 1; count <= 1000; ++count) {
    ++health.unknown_identifiers;
    texts += static_cast<int>(told(events, health).size());
  }
  EXPECT_EQ(texts, 10) << "1, 2, 4 ... 512";
}

TEST(NetworkEvents, TheNodeIsNamedWhereItIsKnown) {
  NetworkEvents events;
  NetworkHealth health{};
  health.feedback_missing = 1;
  health.last_incident = 1;
  health.last_incident_node = 19;
  EXPECT_EQ(told(events, health),
            std::vector<std::string>{"message network: 1 nodes fell silent for two time slots (node 19)"});
  health.forged = 1;
  EXPECT_EQ(told(events, health).size(), 1U) << "the other one has been told";
}

std::string told(SilenceEvents& events, std::int64_t stamp_ns, std::int64_t now_ns, std::uint32_t tail) {
  NetworkState state{};
  state.stamp_ns = stamp_ns;
  state.tail_points = tail;
  std::string all;
  events.follow(state, now_ns, [&](EventKind kind, std::string_view text) {
    all += std::string(event_kind_name(kind)) + ": " + std::string(text);
  });
  return all;
}

TEST(SilenceEvents, AMessageControllerThatFallsSilentIsToldOnceAndSoIsItsReturn) {
  constexpr std::int64_t kTick = 10'000'000;
  SilenceEvents events;
  for (int tick = 1; tick <= 20; ++tick) EXPECT_EQ(told(events, tick * kTick, tick * kTick, 3), "");
  std::string all;
  for (int tick = 21; tick <= 60; ++tick) all += told(events, 20 * kTick, tick * kTick, 3);
  EXPECT_EQ(
      all,
      "warning: message controller silent for 50 ms: the joints play out their batch and 3 points of the "
      "joints' tail, and hold");
  EXPECT_EQ(told(events, 61 * kTick, 61 * kTick, 0), "info: message controller is back after 0.41 s");
  EXPECT_EQ(told(events, 62 * kTick, 62 * kTick, 0), "");
}

// Its own ticks count: in 5 s without one it has heard nobody, and that is no silence of the other.
TEST(SilenceEvents, WhoWasAwayItselfHasNotHeardASilence) {
  SilenceEvents events;
  EXPECT_EQ(told(events, 10'000'000, 10'000'000, 0), "");
  EXPECT_EQ(told(events, 10'000'000, 5'010'000'000, 0), "");
  EXPECT_EQ(told(events, 5'020'000'000, 5'020'000'000, 0), "");
}

}  // namespace
}  // namespace gaitway::core
