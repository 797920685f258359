// Profiles, message layouts, and the codecs that follow them.
#include "gaitway/can/messages.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "gaitway/can/profile.hpp"

namespace gaitway::can {
namespace {

std::mt19937 random_source(42);

int draw(int lowest, int highest) {
  return std::uniform_int_distribution<int>(lowest, highest)(random_source);
}
template <class T>
T draw_any() {
  return static_cast<T>(draw(std::numeric_limits<T>::min(), std::numeric_limits<T>::max()));
}
template <class Array>
void draw_into(Array& values) {
  for (auto& value : values) {
    value = draw_any<typename Array::value_type>();
  }
}
NodeId draw_node() {
  return static_cast<NodeId>(draw(1, kLargestNode));
}

template <class Message, class Decode>
void expect_round_trip(const Message& message, Decode decode, MessageKind kind) {
  const Frame frame = encode(kFullProfile, message);
  EXPECT_EQ(frame.size, layout(kind).size);
  const auto identified = kFullProfile.identify(frame.id);
  ASSERT_TRUE(identified);
  EXPECT_EQ(identified->kind, kind);
  const auto decoded = decode(kFullProfile, frame);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(*decoded, message);
}

class EachProfile : public ::testing::TestWithParam<const Profile*> {};

TEST_P(EachProfile, GivesEveryIdentifierToOneMessageAndIdentifiesItAsThat) {
  const Profile& profile = *GetParam();
  std::map<std::uint32_t, Identified> owner;
  for (const MessageLayout& message : kMessageLayouts) {
    const IdRule rule = profile.row(message.kind).rule;
    if (rule == IdRule::unused) {
      continue;
    }
    const int nodes = rule == IdRule::one ? 0 : profile.largest_node;
    for (int node = nodes == 0 ? 0 : 1; node <= nodes; ++node) {
      for (int part = 0; part < profile.parts(message.kind); ++part) {
        for (const bool toggle : {false, true}) {
          if (toggle && !has_toggle(rule)) {
            continue;
          }
          const Identified identified{message.kind, static_cast<NodeId>(node), toggle,
                                      static_cast<std::uint8_t>(part)};
          const auto inserted =
              owner.emplace(profile.id_of(message.kind, identified.node, toggle, part), identified);
          EXPECT_TRUE(inserted.second) << message.name << " of node " << node;
        }
      }
    }
  }
  for (std::uint32_t id = 0; id <= kLargestId; ++id) {
    const auto expected = owner.find(id);
    const auto identified = profile.identify(id);
    ASSERT_EQ(identified.has_value(), expected != owner.end()) << id;
    if (identified) {
      EXPECT_EQ(*identified, expected->second);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Profiles, EachProfile, ::testing::Values(&kFullProfile, &kPaperProfile),
                         [](const auto& tested) { return std::string(tested.param->name); });

TEST(FullProfile, HasTheKindsInTheirOrderOfPriority) {
  using enum MessageKind;
  constexpr std::array kOrder{emergency_stop, user_command,      sync,      trim, feedback, fault_report,
                              trajectory,     resynchronisation, heartbeat, tail};
  const Profile& profile = kFullProfile;
  for (std::size_t i = 1; i < kOrder.size(); ++i) {
    const NodeId first = profile.row(kOrder[i]).rule == IdRule::one ? NodeId{0} : NodeId{1};
    EXPECT_LT(profile.last_id(kOrder[i - 1]), profile.id_of(kOrder[i], first));
  }
}

TEST(PaperProfile, HasThePublishedTwentyFiveMessages) {
  using enum MessageKind;
  std::set<std::uint32_t> ids;
  for (NodeId node = 1; node <= 12; ++node) {
    EXPECT_EQ(kPaperProfile.id_of(trajectory, node), node);
    EXPECT_EQ(kPaperProfile.id_of(feedback, node), 12U + node);
  }
  EXPECT_EQ(kPaperProfile.id_of(user_command), 25U);
  int identified = 0;
  for (std::uint32_t id = 0; id <= kLargestId; ++id) {
    identified += kPaperProfile.identify(id) ? 1 : 0;
  }
  EXPECT_EQ(identified, 25);
}

TEST(Codecs, EveryMessageComesBackAsItWas) {
  for (int i = 0; i < 2000; ++i) {
    expect_round_trip(EmergencyStop{static_cast<StopMode>(draw(0, 2))}, decode_emergency_stop,
                      MessageKind::emergency_stop);
    expect_round_trip(UserCommand{draw_node(), draw_any<std::int16_t>(), draw_any<std::uint8_t>()},
                      decode_user_command, MessageKind::user_command);
    expect_round_trip(Sync{draw_any<std::uint16_t>(), static_cast<std::uint8_t>(draw(0, 7)), draw(0, 1) == 1,
                           draw(0, 1) == 1, static_cast<std::uint8_t>(draw(0, kMostSoftness)),
                           static_cast<std::uint8_t>(draw(0, kTailPoints)), draw(0, 1) == 1},
                      decode_sync, MessageKind::sync);
    Trim trim;
    draw_into(trim.count);
    expect_round_trip(trim, decode_trim, MessageKind::trim);
    Feedback feedback{draw_node(),
                      draw_any<std::int16_t>(),
                      draw_any<std::int8_t>(),
                      static_cast<JointState>(draw(0, 3)),
                      draw(0, 1) == 1,
                      draw(0, 1) == 1,
                      static_cast<std::uint8_t>(draw(0, 15)),
                      {}};
    draw_into(feedback.channel);
    expect_round_trip(feedback, decode_feedback, MessageKind::feedback);
    expect_round_trip(FaultReport{draw_node(), draw_any<std::uint8_t>()}, decode_fault_report,
                      MessageKind::fault_report);
    Trajectory trajectory{draw_node(), draw(0, 1) == 1, {}};
    draw_into(trajectory.delta);
    expect_round_trip(trajectory, decode_trajectory, MessageKind::trajectory);
    Resynchronisation repair{
        draw_node(), draw(0, 1) == 1, static_cast<std::uint8_t>(draw(0, 7)), draw_any<std::int16_t>(), {}};
    draw_into(repair.delta);
    expect_round_trip(repair, decode_resynchronisation, MessageKind::resynchronisation);
    expect_round_trip(Heartbeat{draw_any<std::uint8_t>(), static_cast<std::uint32_t>(random_source())},
                      decode_heartbeat, MessageKind::heartbeat);
    Tail tail{draw_node(), draw(0, 1) == 1, static_cast<std::uint8_t>(draw(0, 2)), {}};
    draw_into(tail.delta);
    expect_round_trip(tail, decode_tail, MessageKind::tail);
  }
}

// The layout on the wire, written out by hand: what a .dbc file or another implementation relies on.
TEST(Codecs, BytesLieWhereTheTableSays) {
  EXPECT_EQ(encode(kFullProfile, Trajectory{5, true, {1, -1, 2, -2, 3, -3, 127, -128}}),
            (Frame{0x10B, 8, {0x01, 0xFF, 0x02, 0xFE, 0x03, 0xFD, 0x7F, 0x80}}));
  EXPECT_EQ(encode(kFullProfile, Sync{0x1234, 5, true, true}), (Frame{0x008, 4, {0x34, 0x12, 0x1D, 0x00}}));
  EXPECT_EQ(encode(kFullProfile, Sync{0x1234, 5, true, true, 6, 24, true}),
            (Frame{0x008, 4, {0x34, 0x12, 0xDD, 0x58}}));
  EXPECT_EQ(encode(kFullProfile, Tail{5, true, 2, {1, -1, 2, -2, 3, -3, 127, -128}}),
            (Frame{0x310 + 260 + 11, 8, {0x01, 0xFF, 0x02, 0xFE, 0x03, 0xFD, 0x7F, 0x80}}));
  EXPECT_EQ(encode(kFullProfile, Feedback{2, -2, -1, JointState::soft, true, false, 0x9, {0x1234, -1}}),
            (Frame{0x042, 8, {0xFE, 0xFF, 0xFF, 0xA9, 0x34, 0x12, 0xFF, 0xFF}}));
  EXPECT_EQ(encode(kFullProfile, Resynchronisation{1, true, 6, -2, {1, 2, 3, 4, -5}}),
            (Frame{0x201, 8, {0xFE, 0xFF, 0x0E, 0x01, 0x02, 0x03, 0x04, 0xFB}}));
  EXPECT_EQ(encode(kFullProfile, UserCommand{22, 0x0102, 9}), (Frame{0x002, 4, {22, 0x02, 0x01, 9}}));
}

TEST(Codecs, WhatIsNotTheMessageIsRefused) {
  const Frame sync = encode(kFullProfile, Sync{1, 2, true, false});
  EXPECT_FALSE(decode_trim(kFullProfile, sync));
  for (std::uint8_t size = 0; size <= 8; ++size) {
    EXPECT_EQ(decode_sync(kFullProfile, Frame{sync.id, size, sync.data}).has_value(), size == 4);
  }
  EXPECT_FALSE(decode_sync(kFullProfile, {sync.id, sync.size, sync.data, true, false})) << "extended";
  EXPECT_FALSE(decode_sync(kFullProfile, {sync.id, sync.size, sync.data, false, true})) << "remote";
  EXPECT_FALSE(decode_sync(kPaperProfile, sync)) << "not in that profile";
  for (std::uint8_t points = 0; points < 64; ++points) {
    EXPECT_EQ(decode_sync(kFullProfile, Frame{sync.id, 4, {1, 0, 0, points}}).has_value(),
              points <= kTailPoints);
  }
  EXPECT_FALSE(decode_emergency_stop(kFullProfile, Frame{0x001, 1, {3}})) << "no such mode";
  EXPECT_FALSE(decode_user_command(kFullProfile, Frame{0x002, 4, {0, 0, 0, 1}})) << "no such node";
  EXPECT_FALSE(decode_user_command(kFullProfile, Frame{0x002, 4, {65, 0, 0, 1}})) << "no such node";
  EXPECT_FALSE(decode_feedback(kFullProfile, Frame{kFullProfile.id_of(MessageKind::feedback, 65), 8, {}}));
  for (unsigned mode = 0; mode < 256; ++mode) {
    EXPECT_EQ(
        decode_emergency_stop(kFullProfile, Frame{0x001, 1, {static_cast<std::uint8_t>(mode)}}).has_value(),
        mode <= 2);
    EXPECT_EQ(
        decode_user_command(kFullProfile, Frame{0x002, 4, {static_cast<std::uint8_t>(mode)}}).has_value(),
        mode >= 1 && mode <= kLargestNode);
  }
}

// The payload {1, 0, ...} is defined for every message.
TEST(Codecs, EachDecoderTakesTheIdentifiersAndTheSizeOfItsMessageOnly) {
  const auto expect_only = [](MessageKind kind, auto decode) {
    for (unsigned id = 0; id <= 0x7FF; ++id) {
      const auto identified = kFullProfile.identify(id);
      for (std::uint8_t size = 0; size <= 8; ++size) {
        const bool own = identified && identified->kind == kind && size == layout(kind).size;
        ASSERT_EQ(decode(kFullProfile, Frame{id, size, {1}}).has_value(), own)
            << layout(kind).name << " at identifier " << id << " with " << int{size} << " bytes";
      }
    }
  };
  expect_only(MessageKind::emergency_stop, decode_emergency_stop);
  expect_only(MessageKind::user_command, decode_user_command);
  expect_only(MessageKind::sync, decode_sync);
  expect_only(MessageKind::trim, decode_trim);
  expect_only(MessageKind::feedback, decode_feedback);
  expect_only(MessageKind::fault_report, decode_fault_report);
  expect_only(MessageKind::trajectory, decode_trajectory);
  expect_only(MessageKind::resynchronisation, decode_resynchronisation);
  expect_only(MessageKind::heartbeat, decode_heartbeat);
  expect_only(MessageKind::tail, decode_tail);
}

}  // namespace
}  // namespace gaitway::can
