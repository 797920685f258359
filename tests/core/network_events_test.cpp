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

}  // namespace
}  // namespace gaitway::core
