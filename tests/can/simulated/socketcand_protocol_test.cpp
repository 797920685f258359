// What clients of the socketcand protocol may say, and how frames are told to them.
#include "gaitway/can/simulated/socketcand_protocol.hpp"

#include <gmock/gmock.h>

#include <random>
#include <string>
#include <vector>

namespace gaitway::can::socketcand {
namespace {

using testing::HasSubstr;

Command parsed(std::string_view element) {
  const auto result = parse_element(element);
  if (const auto* const rejection = std::get_if<Rejection>(&result)) {
    ADD_FAILURE() << element << ": " << rejection->reason;
    return {};
  }
  return std::get<Command>(result);
}

std::string reason(std::string_view element) {
  const auto result = parse_element(element);
  const auto* const rejection = std::get_if<Rejection>(&result);
  return rejection == nullptr ? "accepted" : rejection->reason;
}

std::vector<std::string> elements(ElementReader& reader, std::string_view input) {
  std::vector<std::string> all;
  ElementReader::Element element;
  while (reader.next(input, element)) {
    all.push_back(element.too_long ? "too long" : element.text);
  }
  return all;
}

std::string told(const Frame& frame, std::int64_t time_ns) {
  std::string text;
  append_frame(text, frame, time_ns);
  return text;
}

TEST(SocketcandProtocol, AFrameToSendIsReadWithItsBytes) {
  const Command command = parsed("< send 123 3 1 fF 0a >");
  EXPECT_EQ(command.verb, Verb::send);
  EXPECT_EQ(command.frame, (Frame{.id = 0x123, .size = 3, .data = {1, 0xFF, 0x0A}}));
}

TEST(SocketcandProtocol, EightDigitsMakeAnExtendedIdentifier) {
  EXPECT_EQ(parsed("< send 1AAAAAAA 2 1 f1 >").frame,
            (Frame{.id = 0x1AAAAAAA, .size = 2, .data = {1, 0xF1}, .extended = true}));
  EXPECT_EQ(parsed("< send 00000123 0 >").frame, (Frame{.id = 0x123, .extended = true}));
  EXPECT_EQ(parsed("<send 7ff 0>").frame, (Frame{.id = 0x7FF}));
}

TEST(SocketcandProtocol, WhatSavvyCanMakesOfLargeBytesAndExtendedIdentifiersIsUnderstood) {
  EXPECT_EQ(parsed("< send 123 3 ffffffffffffff80 7f ffffffff >").frame,
            (Frame{.id = 0x123, .size = 3, .data = {0x80, 0x7F, 0xFF}}));
  EXPECT_EQ(parsed("< send 9abcdef0 1 5 >").frame,
            (Frame{.id = 0x1ABCDEF0, .size = 1, .data = {5}, .extended = true}));
  EXPECT_THAT(reason("< send 123 1 ffffff7f >"), HasSubstr("data byte 1 of 1"));
  EXPECT_THAT(reason("< send 123 1 ffffffffffffff7f >"), HasSubstr("data byte 1 of 1"));
  EXPECT_THAT(reason("< send 123 1 ff80 >"), HasSubstr("data byte 1 of 1"));
}

TEST(SocketcandProtocol, ASizeWithoutBytesIsARemoteFrame) {
  EXPECT_EQ(parsed("< send 123 8  >").frame, (Frame{.id = 0x123, .size = 8, .remote = true}));
  EXPECT_EQ(parsed("< send 123 0  >").frame, (Frame{.id = 0x123, .size = 0, .remote = false}));
}

TEST(SocketcandProtocol, EveryCommandIsRead) {
  EXPECT_EQ(parsed("< open can0 >").bus, "can0");
  EXPECT_EQ(parsed("< can0 B 500000 875 125 6 7 2 1 2 >").verb, Verb::configure);
  EXPECT_EQ(parsed("< can0 C 1 0 0 >").bus, "can0");
  EXPECT_EQ(parsed("< echo >").verb, Verb::echo);
  EXPECT_EQ(parsed("< rawmode >").verb, Verb::rawmode);
  EXPECT_EQ(parsed("< bcmmode >").verb, Verb::bcmmode);
  EXPECT_EQ(parsed("< controlmode >").verb, Verb::controlmode);
  EXPECT_EQ(parsed("< isotpmode >").verb, Verb::isotpmode);
  EXPECT_EQ(parsed("< muxfilter 0 0 123 2 FF 00 00 00 00 00 00 00 >").verb, Verb::muxfilter);
  EXPECT_EQ(parsed("< statistics 1000 >").interval_ns, 1'000'000'000);
  const Command add = parsed("< add 1 20000 123 2 11 22 >");
  EXPECT_EQ(add.verb, Verb::add);
  EXPECT_EQ(add.interval_ns, 1'020'000'000);
  EXPECT_EQ(add.frame, (Frame{.id = 0x123, .size = 2, .data = {0x11, 0x22}}));
  EXPECT_EQ(parsed("< update 123 1 33 >").verb, Verb::update);
  EXPECT_EQ(parsed("< delete 123 >").verb, Verb::erase);
  const Command filter = parsed("< filter 0 5 123 2 FF 0F >");
  EXPECT_EQ(filter.verb, Verb::filter);
  EXPECT_EQ(filter.interval_ns, 5'000);
  EXPECT_EQ(filter.frame.data[1], 0x0F);
  EXPECT_EQ(parsed("< subscribe 0 0 00000456 >").frame, (Frame{.id = 0x456, .extended = true}));
  EXPECT_EQ(parsed("< unsubscribe 123 >").verb, Verb::unsubscribe);
}

TEST(SocketcandProtocol, AnIntervalOfTwoLargestPartsDoesNotOverflow) {
  EXPECT_EQ(parsed("< subscribe 86400 86400000000 1 >").interval_ns, kLongestInterval_ns);
}

TEST(SocketcandProtocol, EachRuleThatACommandBreaksIsNamed) {
  EXPECT_THAT(reason("echo"), HasSubstr("angle brackets"));
  EXPECT_THAT(reason("< >"), HasSubstr("unknown command ''"));
  EXPECT_THAT(reason("< fly 1 >"), HasSubstr("unknown command 'fly'"));
  EXPECT_THAT(reason("< open >"), HasSubstr("1 to 16 characters"));
  EXPECT_THAT(reason("< open a_bus_with_a_long_name >"), HasSubstr("1 to 16 characters"));
  EXPECT_THAT(reason("< open can0 can1 >"), HasSubstr("'can1': there is more than 'open' takes"));
  EXPECT_THAT(reason("< send >"), HasSubstr("an identifier has 1 to 3"));
  EXPECT_THAT(reason("< send 800 0 >"), HasSubstr("at most 7FF"));
  EXPECT_THAT(reason("< send 1234 0 >"), HasSubstr("'1234'"));
  EXPECT_THAT(reason("< send 20000000 0 >"), HasSubstr("at most 1FFFFFFF"));
  EXPECT_THAT(reason("< send -12 0 >"), HasSubstr("'-12'"));
  EXPECT_THAT(reason("< send 123 >"), HasSubstr("the number of data bytes"));
  EXPECT_THAT(reason("< send 123 9 1 2 3 4 5 6 7 8 9 >"), HasSubstr("from 0 to 8"));
  EXPECT_THAT(reason("< send 123 F >"), HasSubstr("from 0 to 8"));
  EXPECT_THAT(reason("< send 123 2 1 >"), HasSubstr("data byte 2 of 2"));
  EXPECT_THAT(reason("< send 123 2 1 100 >"), HasSubstr("'100': data byte 2"));
  EXPECT_THAT(reason("< send 123 2 1 2 3 >"), HasSubstr("'3': there is more"));
  EXPECT_THAT(reason("< add 1 x 123 0 >"), HasSubstr("the microseconds"));
  EXPECT_THAT(reason("< add 86401 0 123 0 >"), HasSubstr("the seconds of the interval"));
  EXPECT_THAT(reason("< filter 0 0 123 2 >"), HasSubstr("mask"));
  EXPECT_THAT(reason("< statistics fast >"), HasSubstr("milliseconds"));
}

TEST(SocketcandProtocol, ElementsAreFoundWhereverThePiecesAreCut) {
  const std::string input = "x< open can0 >\n garbage < echo >< send 1 1 2";
  for (std::size_t cut = 0; cut <= input.size(); ++cut) {
    ElementReader reader;
    std::vector<std::string> all = elements(reader, std::string_view(input).substr(0, cut));
    for (const std::string& element : elements(reader, std::string_view(input).substr(cut))) {
      all.push_back(element);
    }
    EXPECT_THAT(all, testing::ElementsAre("< open can0 >", "< echo >")) << cut;
    EXPECT_THAT(elements(reader, " >"), testing::ElementsAre("< send 1 1 2 >"));
  }
}

TEST(SocketcandProtocol, AnElementThatBeginsAgainCutsOffTheOneBefore) {
  ElementReader reader;
  EXPECT_THAT(elements(reader, "< send 1 < echo >"), testing::ElementsAre("< echo >"));
}

TEST(SocketcandProtocol, AnElementThatIsTooLongIsToldOnceAndSkipped) {
  ElementReader reader;
  const std::string longest = "<" + std::string(kLongestElement - 2, 'a') + ">";
  EXPECT_THAT(elements(reader, longest), testing::ElementsAre(longest));
  EXPECT_THAT(elements(reader, "<" + std::string(5 * kLongestElement, 'a') + ">< echo >"),
              testing::ElementsAre("too long", "< echo >"));
}

TEST(SocketcandProtocol, AFrameIsToldWithItsTimeInMicroseconds) {
  EXPECT_EQ(told({.id = 0x123, .size = 4, .data = {0x1A, 0x22, 3, 0x44}}, 23'424'242'999),
            "< frame 123 23.424242 1A220344 >");
  EXPECT_EQ(told({.id = 0x12345, .size = 1, .data = {7}, .extended = true}, 1'000'042'000),
            "< frame 00012345 1.000042 07 >");
  EXPECT_EQ(told({.id = 7}, 0), "< frame 007 0.000000  >");
  EXPECT_EQ(told({.id = 7, .size = 2, .remote = true}, 0), "");
}

TEST(SocketcandProtocol, AnErrorHoldsNoBracketWhateverWasSent) {
  std::string text;
  append_error(text, "a<b>\n\xC3");
  EXPECT_EQ(text, "< error a b ?? >");
}

TEST(SocketcandProtocol, StatisticsAreInTheProtocolsOrder) {
  std::string text;
  append_statistics(
      text, {.received_bytes = 8, .received_frames = 1, .transmitted_bytes = 20, .transmitted_frames = 3});
  EXPECT_EQ(text, "< stat 8 1 20 3 >");
}

TEST(SocketcandProtocol, WhateverIsReadIsAFrameThatABusCanCarry) {
  std::mt19937 random(7);
  const std::string alphabet = "<>  0123456789abcdefAF\n\xFFgsendupatlxr";
  const char* const words[] = {"send", "add", "update", "delete", "filter", "subscribe", "open"};
  int commands = 0;
  for (int round = 0; round < 100'000; ++round) {
    std::string element = "< " + std::string(words[random() % 7]) + " ";
    for (auto length = random() % 30; length > 0; --length) {
      element += alphabet[random() % alphabet.size()];
    }
    element += " >";
    const auto result = parse_element(element);
    if (const auto* const command = std::get_if<Command>(&result)) {
      ASSERT_TRUE(is_valid(command->frame)) << element;
      ASSERT_GE(command->interval_ns, 0) << element;
      ASSERT_LE(command->interval_ns, kLongestInterval_ns) << element;
      ++commands;
    }
  }
  EXPECT_GT(commands, 1000) << "the search finds commands at all";
}

}  // namespace
}  // namespace gaitway::can::socketcand
