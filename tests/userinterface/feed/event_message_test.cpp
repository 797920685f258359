// Events as log messages.
#include "gaitway/api/state_messages.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "gaitway/instance/event_log.hpp"

namespace gaitway::api {
namespace {

Event event_of(core::EventKind kind) {
  Event event{};
  event.stamp_ns = 1'000'000'001;
  event.kind = static_cast<std::uint32_t>(kind);
  std::memcpy(event.source, "trajectory", 10);
  std::memcpy(event.text, "step limited", 12);
  return event;
}

TEST(EventMessage, CarriesSourceTextAndStamp) {
  const ros::Log log = log_of(event_of(core::EventKind::info));
  EXPECT_EQ(log.name, "trajectory");
  EXPECT_EQ(log.msg, "step limited");
  EXPECT_EQ(log.stamp.sec, 1);
  EXPECT_EQ(log.stamp.nanosec, 1U);
}

TEST(EventMessage, HasALevelForEachKind) {
  EXPECT_EQ(log_of(event_of(core::EventKind::info)).level, 20);
  EXPECT_EQ(log_of(event_of(core::EventKind::warning)).level, 30);
  EXPECT_EQ(log_of(event_of(core::EventKind::error)).level, 40);
  EXPECT_EQ(log_of(event_of(core::EventKind::fault)).level, 40);
  EXPECT_EQ(log_of(event_of(core::EventKind::refusal)).level, 30);
  Event unknown = event_of(core::EventKind::info);
  unknown.kind = 77;
  EXPECT_EQ(log_of(unknown).level, 30);
}

TEST(EventMessage, ATextThatFillsItsArrayEndsWithIt) {
  Event event{};
  std::memset(event.text, 'x', sizeof event.text);
  EXPECT_EQ(log_of(event).msg, std::string(256, 'x'));
}

TEST(EventMessage, TellsHowManyWereMissed) {
  EXPECT_EQ(log_of_missed(12, 0).level, 30);
  EXPECT_NE(log_of_missed(12, 0).msg.find("12 events"), std::string::npos);
}

}  // namespace
}  // namespace gaitway::api
