// Traces keep what was recorded, and refuse to be played half.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "synthetic_trace.hpp"
#include "trace_output.hpp"
#include "trace_writer.hpp"

namespace gaitway::firmware {
namespace {

localcontroller::JointConfig any_config() {
  localcontroller::JointConfig config;
  config.profile = can::kPaperProfile;
  config.node = 11;
  config.count_rad = 0.1;
  config.encoder_count_rad = -0.0;
  config.encoder_zero_rad = 0.007;
  config.stiffness_Nm_per_rad = std::numeric_limits<double>::denorm_min();
  config.lower_rad = -1.25;
  config.initial_reference_count = -7;
  config.trim_channel = -1;
  config.senses_current = true;
  config.channel_scale[1] = 0.3F;
  return config;
}

TEST(Trace, KeepsAConfigurationToTheBit) {
  ByteSink sink;
  FieldPut<ByteSink> put(sink);
  localcontroller::JointConfig written = any_config();
  trace_fields(put, written);
  ByteSource source(sink.bytes);
  FieldGet<ByteSource> get(source);
  localcontroller::JointConfig read;
  trace_fields(get, read);
  ASSERT_TRUE(get.complete());
  EXPECT_EQ(read.profile.largest_node, can::kPaperProfile.largest_node);
  EXPECT_EQ(read.profile.tail_parts, written.profile.tail_parts);
  for (std::size_t row = 0; row < can::kMessageKinds; ++row) {
    EXPECT_EQ(read.profile.rows[row].rule, can::kPaperProfile.rows[row].rule);
    EXPECT_EQ(read.profile.rows[row].base_id, can::kPaperProfile.rows[row].base_id);
    EXPECT_EQ(read.profile.rows[row].period_ns, can::kPaperProfile.rows[row].period_ns);
    EXPECT_EQ(read.profile.rows[row].on_event, can::kPaperProfile.rows[row].on_event);
    EXPECT_EQ(read.profile.rows[row].deadline_ns, can::kPaperProfile.rows[row].deadline_ns);
  }
  EXPECT_EQ(read.node, written.node);
  EXPECT_EQ(read.count_rad, written.count_rad);
  EXPECT_TRUE(std::signbit(read.encoder_count_rad));
  EXPECT_EQ(read.encoder_zero_rad, written.encoder_zero_rad);
  EXPECT_EQ(read.stiffness_Nm_per_rad, written.stiffness_Nm_per_rad);
  EXPECT_EQ(read.lower_rad, written.lower_rad);
  EXPECT_EQ(read.initial_reference_count, written.initial_reference_count);
  EXPECT_EQ(read.trim_channel, written.trim_channel);
  EXPECT_TRUE(read.senses_current);
  EXPECT_EQ(read.channel_scale[1], written.channel_scale[1]);
}

TEST(Trace, APlayedTraceAnswersAsTheControllerDoes) {
  localcontroller::JointConfig config = any_config();
  config.profile = can::kFullProfile;
  config.stiffness_Nm_per_rad = 300.0;
  config.encoder_count_rad = 0.001;
  config.torque_limit_Nm = 5.0;
  config.upper_rad = 1.0;
  const can::Frame sync = can::encode(can::kFullProfile, can::Sync{3, 1, false, false});
  TraceWriter trace;
  trace.joint(4, config);
  trace.frame(sync);
  trace.received(4, 5'000);
  trace.step(4, 1'000'000, {.encoder_count = 3});
  for (int times = 0; times < 3; ++times) {  // feedback, the report of its start, nothing
    trace.take(4);
  }
  const Played played = play_here(trace.finish());

  localcontroller::JointController joint(config);
  ByteSink expected;
  FieldPut<ByteSink> put(expected);
  put(std::uint8_t{4});
  joint.on_frame(sync, 5'000);
  put(joint.reference_count());
  put(static_cast<std::uint8_t>(joint.state()));
  put(joint.step(1'000'000, {.encoder_count = 3}));
  put(joint.reference_rad());
  put(joint.trim_rad());
  put(joint.reference_count());
  put(static_cast<std::uint8_t>(joint.state()));
  for (const bool sends : {true, true, false}) {
    can::Frame frame;
    ASSERT_EQ(joint.take_frame(frame), sends);
    put(sends);
    if (sends) {
      trace_fields(put, frame);
    }
  }
  EXPECT_EQ(played.result, ReplayResult::complete);
  EXPECT_EQ(played.output, expected.bytes);
}

TEST(Trace, WhatIsCutOffOrUnknownIsRefused) {
  TraceWriter trace;
  trace.joint(0, any_config());
  trace.step(0, 1'000'000, {});
  std::vector<std::uint8_t> whole = trace.finish();
  EXPECT_EQ(play_here(whole).result, ReplayResult::complete);
  whole.pop_back();
  EXPECT_EQ(play_here(whole).result, ReplayResult::truncated);
  const std::uint8_t nobody[] = {'S', 0};
  EXPECT_EQ(play_here(nobody).result, ReplayResult::unknown_joint);
  const std::uint8_t too_large[] = {'J', kLargestTraceJoints};
  EXPECT_EQ(play_here(too_large).result, ReplayResult::unknown_joint);
  whole.back() = 'Z';
  whole.push_back(0);
  EXPECT_NE(play_here(whole).result, ReplayResult::complete);
}

// The comparison between machines rests on it.
TEST(SyntheticTrace, VisitsEveryStateAndSendsFeedbackAndFaults) {
  const std::vector<std::uint8_t> trace = SyntheticTrace(1).write(6000);
  const Played played = play_here(trace);
  ASSERT_EQ(played.result, ReplayResult::complete);
  AnswerReader answers(trace, played.output);
  std::map<can::JointState, int> states;
  std::map<can::MessageKind, int> sent;
  int trimmed = 0, driven = 0;
  std::size_t end = 0;
  while (const auto answer = answers.next()) {
    end = answer->end;
    ++states[answer->state];
    trimmed += answer->trim_rad != 0.0 ? 1 : 0;
    driven += answer->torque_Nm != 0.0 ? 1 : 0;
    if (answer->frame) {
      const can::Profile& profile = answer->joint < 6 ? can::kFullProfile : can::kPaperProfile;
      ++sent[profile.identify(answer->frame->id)->kind];
    }
  }
  EXPECT_EQ(end, played.output.size()) << "every byte is explained";
  EXPECT_GT(states[can::JointState::running], 10'000);
  EXPECT_GT(states[can::JointState::holding], 1'000);
  EXPECT_GT(states[can::JointState::soft], 1);
  EXPECT_GT(sent[can::MessageKind::feedback], 3'000);
  EXPECT_GT(sent[can::MessageKind::fault_report], 10);
  EXPECT_GT(trimmed, 1'000);
  EXPECT_GT(driven, 40'000);
}

}  // namespace
}  // namespace gaitway::firmware
