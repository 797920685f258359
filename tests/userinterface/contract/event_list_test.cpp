// The newest events over the narrow link, with their numbers.
#include "gaitway/contract/event_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace gaitway::contract {
namespace {

constexpr TopicCodec kCodec{.joint_count = 22};

Event event_of(std::uint64_t number) {
  Event event{};
  event.stamp_ns = static_cast<std::int64_t>(number) * 1000;
  const std::string text = "event " + std::to_string(number);
  std::copy(text.begin(), text.end(), event.text);
  return event;
}

TEST(EventList, HoldsTheNewestWithTheirNumbers) {
  EventList list;
  std::vector<std::uint8_t> wire(EventList::most_bytes(kCodec));
  for (std::uint64_t number = 1; number <= 300; ++number) {
    list.add(event_of(number));
    const std::size_t size = list.encode(kCodec, wire);
    ASSERT_GT(size, 0U);
    const auto back = EventList::decode(kCodec, std::span(wire).first(size));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->last(), number);
    EXPECT_EQ(back->first(), number <= EventList::kKept ? 1 : number - EventList::kKept + 1);
    for (std::uint64_t held = back->first(); held <= number; ++held) {
      EXPECT_EQ(back->event(held).stamp_ns, event_of(held).stamp_ns);
      EXPECT_STREQ(reinterpret_cast<const char*>(back->event(held).text),
                   reinterpret_cast<const char*>(event_of(held).text));
    }
  }
}

TEST(EventList, AnEmptyOneIsOne) {
  std::vector<std::uint8_t> wire(EventList::most_bytes(kCodec));
  const std::size_t size = EventList().encode(kCodec, wire);
  const auto back = EventList::decode(kCodec, std::span(wire).first(size));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->last(), 0U);
}

TEST(EventList, WhatIsCutOffOrHasBytesTooManyOrNumbersThatDoNotFitIsNone) {
  EventList list;
  for (std::uint64_t number = 1; number <= 12; ++number) list.add(event_of(number));
  std::vector<std::uint8_t> wire(EventList::most_bytes(kCodec));
  const std::size_t size = list.encode(kCodec, wire);
  for (std::size_t cut = 0; cut < size; ++cut) {
    EXPECT_FALSE(EventList::decode(kCodec, std::span(wire).first(cut))) << cut;
    EXPECT_EQ(list.encode(kCodec, std::span(wire).first(cut)), 0U) << cut;
  }
  list.encode(kCodec, wire);
  EXPECT_FALSE(EventList::decode(kCodec, std::span(wire).first(size + 1)));
  wire[1] = 9;  // more than it can hold
  EXPECT_FALSE(EventList::decode(kCodec, std::span(wire).first(size)));
}

TEST(EventList, RandomBytesAreRefusedOrAList) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 20'000; ++round) {
    std::vector<std::uint8_t> wire(random() % 64);
    for (std::uint8_t& byte : wire)
      byte = random() % 4 == 0 ? static_cast<std::uint8_t>(random()) : std::uint8_t{0};
    const auto list = EventList::decode(kCodec, wire);
    EXPECT_TRUE(!list || list->last() >= list->first() - 1);
  }
}

}  // namespace
}  // namespace gaitway::contract
