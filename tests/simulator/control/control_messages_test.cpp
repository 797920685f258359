// Packets of the control channel: what comes back out of them, and what is refused by field, value and rule.
#include "gaitway/simulation/control_messages.hpp"

#include <gmock/gmock.h>

#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>

namespace gaitway::simulation {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

Push push_of_trunk() {
  return {.link = "trunk", .force_N = {3.0, -4.0, 0.5}, .frame = Frame::heading, .duration_s = 0.1};
}

std::string refusal_of(const std::function<void(Push&)>& spoil) {
  Push push = push_of_trunk();
  spoil(push);
  EXPECT_THROW(static_cast<void>(request_of(push, 1)), std::invalid_argument);
  return objection(push);
}

TEST(ControlMessages, APushComesBackAsItWasAsked) {
  const auto request = decode_request(encode(request_of(push_of_trunk(), 7)));
  ASSERT_TRUE(request);
  EXPECT_EQ(request->number, 7U);
  EXPECT_EQ(request->version, kControlVersion);
  const Push push = push_of(*request);
  EXPECT_EQ(push.link, "trunk");
  EXPECT_EQ(push.force_N, push_of_trunk().force_N);
  EXPECT_EQ(push.frame, Frame::heading);
  EXPECT_EQ(push.duration_s, 0.1);
}

TEST(ControlMessages, AnOrderComesBackAsItWasAsked) {
  const std::string longest = "{\"order\": \"" + std::string(kMostBodyBytes - 13, 'x') + "\"}";
  for (const std::string& json : {std::string("{}"), longest}) {
    const auto request = decode_request(encode(request_of(json, 9)));
    ASSERT_TRUE(request);
    EXPECT_EQ(request->number, 9U);
    EXPECT_EQ(request->kind, static_cast<std::uint16_t>(RequestKind::order));
    EXPECT_EQ(order_of(*request), json);
  }
  EXPECT_THAT(objection_to_order(longest + " "), AllOf(HasSubstr("4001 bytes"), HasSubstr("1 to 4000")));
  EXPECT_THROW(static_cast<void>(request_of(longest + " ", 1)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(request_of("", 1)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(order_of(Request{})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(encode(Request{.body = std::vector<std::byte>(kMostBodyBytes + 1)})),
               std::invalid_argument);
}

TEST(ControlMessages, AnswersComeBackAndTheirReasonsAreCutBetweenCharacters) {
  const auto accepted = decode_answer(encode(Answer{.number = 7, .accepted = true}));
  ASSERT_TRUE(accepted);
  EXPECT_TRUE(accepted->accepted);
  EXPECT_EQ(accepted->number, 7U);
  EXPECT_THAT(accepted->text, IsEmpty());
  const std::string json(kMostTextBytes, 'x');
  const auto longest = decode_answer(encode(Answer{.number = 7, .accepted = true, .text = json}));
  ASSERT_TRUE(longest);
  EXPECT_EQ(longest->text, json);
  EXPECT_THROW(static_cast<void>(encode(Answer{.number = 7, .accepted = true, .text = json + "x"})),
               std::invalid_argument)
      << "half a JSON is none";
  const std::string reason(kMostTextBytes - 1, 'x');
  const auto refused = decode_answer(encode(Answer{.number = 8, .text = reason + "\u00e9\u00e9"}));
  ASSERT_TRUE(refused);
  EXPECT_FALSE(refused->accepted);
  EXPECT_EQ(refused->text, reason);
}

TEST(ControlMessages, WhatNobodyMayBePushedWithIsRefusedByFieldValueAndRule) {
  EXPECT_THAT(objection(push_of_trunk()), IsEmpty());
  EXPECT_THAT(refusal_of([](Push& push) { push.link = ""; }), HasSubstr("link has 0 bytes"));
  EXPECT_THAT(refusal_of([](Push& push) { push.link = std::string(48, 'a'); }),
              AllOf(HasSubstr("link has 48 bytes"), HasSubstr("1 to 47")));
  EXPECT_THAT(refusal_of([](Push& push) { push.link = "tr\nnk"; }), HasSubstr("printable"));
  EXPECT_THAT(refusal_of([](Push& push) {
                push.force_N = {150.0, 150.0, 0.0};
              }),
              AllOf(HasSubstr("[150.0, 150.0, 0.0] N"), HasSubstr("0.1 to 200.0 N")));
  for (const double wrong : {kNotANumber, std::numeric_limits<double>::infinity(), 1e300, 0.0}) {
    EXPECT_THAT(refusal_of([wrong](Push& push) { push.force_N = {0.0, wrong, 0.0}; }), HasSubstr("force is"));
  }
  for (const double wrong : {kNotANumber, -1.0, 0.0, 0.009, 2.01}) {
    EXPECT_THAT(refusal_of([wrong](Push& push) { push.duration_s = wrong; }),
                AllOf(HasSubstr("duration is"), HasSubstr("from 0.01 to 2.0 s")));
  }
  EXPECT_THAT(refusal_of([](Push& push) { push.frame = static_cast<Frame>(2); }), HasSubstr("frame is 2"));
}

TEST(ControlMessages, OtherPacketsAreNone) {
  const Packet good = encode(request_of(push_of_trunk(), 7));
  EXPECT_FALSE(decode_request({}));
  EXPECT_FALSE(decode_request(std::span(good).first(kHeadBytes - 1)));
  EXPECT_TRUE(decode_request(std::span(good).first(kHeadBytes)));
  Packet longer = good;
  longer.resize(kMostRequestBytes + 1);
  EXPECT_FALSE(decode_request(longer));
  for (const std::size_t byte : {std::size_t{0}, std::size_t{3}, std::size_t{12}}) {  // magic, reserved
    Packet bad = good;
    bad[byte] ^= std::byte{1};
    EXPECT_FALSE(decode_request(bad)) << byte;
  }
  EXPECT_FALSE(decode_answer(good));
  const Packet answer = encode(Answer{.number = 1, .text = "no"});
  EXPECT_TRUE(decode_answer(answer));
  for (const std::size_t byte : {std::size_t{0}, std::size_t{4}, std::size_t{7}, std::size_t{12}}) {
    Packet bad = answer;  // magic, version, outcome, reserved
    bad[byte] ^= std::byte{4};
    EXPECT_FALSE(decode_answer(bad)) << byte;
  }
}

TEST(ControlMessages, ABodyThatIsNoPushIsRefused) {
  const Request good = request_of(push_of_trunk(), 7);
  Request unending = good;
  std::memset(unending.body.data(), 'x', kMostLinkNameBytes + 1);
  EXPECT_THROW(static_cast<void>(push_of(unending)), std::invalid_argument);
  Request more = good;
  more.body.back() = std::byte{1};
  EXPECT_THROW(static_cast<void>(push_of(more)), std::invalid_argument);
  for (const std::size_t size : {std::size_t{0}, kPushBytes - 1, kPushBytes + 1}) {
    Request other = good;
    other.body.resize(size);
    EXPECT_THROW(static_cast<void>(push_of(other)), std::invalid_argument) << size;
  }
}

}  // namespace
}  // namespace gaitway::simulation
