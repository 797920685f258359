// The shipped profiles as the analysis sees them, and what is proven about the robot's bus.
#include "gaitway/can/analysis/network_messages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "bus_traffic.hpp"
#include "gaitway/can/analysis/response_time.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::can {
namespace {

using facts::kMillisecond_ns;

std::vector<NodeId> nodes(int count) {
  std::vector<NodeId> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), NodeId{1});
  return all;
}

// All nodes report a fault at once in every analysis: nothing keeps them from it.
const ProofAssumptions kWorstCase{
    .jitter_ns = 1 * kMillisecond_ns, .errors = jam(2 * kMillisecond_ns), .bit_time_ns = 1000};

TEST(NetworkMessages, ThePapersProfileIsThePublished25Messages) {
  const auto messages = message_set(kPaperProfile, nodes(22));
  ASSERT_EQ(messages.size(), 25U);
  for (std::size_t i = 0; i < messages.size(); ++i) {
    EXPECT_EQ(messages[i].id, i + 1);
    EXPECT_EQ(messages[i].period_ns, i < 12 ? 80 * kMillisecond_ns : 10 * kMillisecond_ns);
  }
  EXPECT_EQ(messages[0].name, "trajectory 1");
  EXPECT_EQ(messages[12].name, "feedback 1");
  EXPECT_EQ(messages[24].name, "user command");
}

TEST(NetworkMessages, EveryMessageIsThereOnceWithItsProfilesNumbers) {
  const auto messages = message_set(kFullProfile, nodes(22), 5000);
  ASSERT_EQ(messages.size(), 5U + 4U * 22U + 3U * 22U)
      << "the two identifiers of a trajectory, or of a part of a tail, are one message";
  std::set<std::tuple<MessageKind, NodeId, std::uint8_t>> seen;
  std::uint32_t last_id = 0;
  for (const AnalysedMessage& message : messages) {
    const auto identified = kFullProfile.identify(message.id);
    ASSERT_TRUE(identified) << message.name;
    EXPECT_TRUE(seen.insert({identified->kind, identified->node, identified->part}).second) << message.name;
    EXPECT_EQ(message.bytes, layout(identified->kind).size);
    EXPECT_EQ(message.period_ns, kFullProfile.row(identified->kind).period_ns);
    EXPECT_EQ(message.deadline_ns, kFullProfile.row(identified->kind).deadline_ns);
    EXPECT_EQ(message.jitter_ns, 5000);
    EXPECT_GT(message.id, last_id);
    last_id = message.id;
  }
}

TEST(NetworkProof, ThePapersProfileMeetsEveryDeadline) {
  const Proof proof = prove(kPaperProfile, nodes(12));
  EXPECT_TRUE(proof.holds());
  EXPECT_EQ(proof.complaint(), "");
  // As published with eight bytes: 1.755 and 3.375 ms; the user command has four, 40 bits less.
  EXPECT_EQ(proof.worst_response_ns(MessageKind::trajectory), 1'755'000);
  EXPECT_EQ(proof.worst_response_ns(MessageKind::feedback), 3'335'000);
  EXPECT_EQ(proof.worst_response_ns(MessageKind::user_command), 3'335'000);
  EXPECT_FALSE(proof.worst_response_ns(MessageKind::sync)) << "there is none";
}

TEST(NetworkProof, TheFullProfileHoldsWithJitterFaultReportsAndAJamTogether) {
  const Proof proof = prove(kFullProfile, nodes(22), kWorstCase);
  EXPECT_TRUE(proof.holds()) << proof.complaint();
  for (const auto& [kind, limit_ms] : {std::pair{MessageKind::emergency_stop, 4},
                                       {MessageKind::user_command, 4},
                                       {MessageKind::feedback, 7},
                                       {MessageKind::trajectory, 18}}) {
    const auto worst_ns = proof.worst_response_ns(kind);
    ASSERT_TRUE(worst_ns) << layout(kind).name;
    EXPECT_LE(*worst_ns, limit_ms * kMillisecond_ns) << layout(kind).name;
  }
  EXPECT_LT(proof.load, 0.81);
  const auto limit = breakdown(proof.messages, {.bit_time_ns = 1000, .errors = kWorstCase.errors});
  ASSERT_TRUE(limit);
  EXPECT_GT(limit->load, proof.load);
}

TEST(NetworkProof, AnEmergencyStopIsThereWithinAMillisecondOnABusWithoutErrors) {
  EXPECT_LE(prove(kFullProfile, nodes(22)).worst_response_ns(MessageKind::emergency_stop),
            1 * kMillisecond_ns);
}

TEST(NetworkProof, NamesTheMessageThatMissesAndByHowMuch) {
  Profile profile = kFullProfile;
  const Proof before = prove(profile, nodes(22), kWorstCase);
  const std::int64_t feedback_ns = *before.worst_response_ns(MessageKind::feedback);
  auto& row = profile.rows[static_cast<std::size_t>(MessageKind::feedback)];
  row.deadline_ns = feedback_ns;
  EXPECT_TRUE(prove(profile, nodes(22), kWorstCase).holds()) << "a deadline equal to the bound is met";
  row.deadline_ns = feedback_ns - 30'000;
  const Proof after = prove(profile, nodes(22), kWorstCase);
  ASSERT_TRUE(after.first_miss());
  EXPECT_EQ(after.messages[*after.first_miss()].name, "feedback 22");
  EXPECT_THAT(after.complaint(), testing::HasSubstr("'feedback 22' (id 86) may arrive 0.030 ms after"));
  row.period_ns = 2 * kMillisecond_ns;
  EXPECT_THAT(prove(profile, nodes(22)).complaint(), testing::HasSubstr("may wait without end"));
}

TEST(NetworkProof, TheMostJointsFitAndOneMoreDoesNot) {
  for (const ProofAssumptions& assumptions : {ProofAssumptions{}, kWorstCase}) {
    const int most = most_joints(kFullProfile, assumptions);
    EXPECT_GE(most, 22);
    EXPECT_TRUE(prove(kFullProfile, nodes(most), assumptions).holds());
    EXPECT_FALSE(prove(kFullProfile, nodes(most + 1), assumptions).holds());
  }
  EXPECT_EQ(most_joints(kPaperProfile), 12) << "as many as it has identifiers for";
}

// The published messages alone, all within 10 ms: 36 joints in the paper's order.
TEST(NetworkProof, AProfileOfOnesOwnIsProvenLikeTheShippedOnes) {
  Profile profile = kPaperProfile;
  profile.largest_node = kLargestNode;
  profile.rows[static_cast<std::size_t>(MessageKind::feedback)].base_id = 100;
  auto& command = profile.rows[static_cast<std::size_t>(MessageKind::user_command)];
  command.base_id = 200;
  EXPECT_EQ(most_joints(profile), 36);
  command.base_id = 0;  // the most urgent now; trajectories come last
  profile.rows[static_cast<std::size_t>(MessageKind::feedback)].base_id = 0;
  auto& trajectory = profile.rows[static_cast<std::size_t>(MessageKind::trajectory)];
  trajectory.base_id = 100;
  trajectory.deadline_ns = 2 * facts::kSlot_ns;
  EXPECT_EQ(most_joints(profile), 48) << "2 * (95 + 135 n) + 135 n <= 20,000 us";
  trajectory.deadline_ns = facts::kCycle_ns;
  EXPECT_EQ(most_joints(profile), 64);
}

// Everything at once and as late as it may at first, and as early as it may from then on: a station for each
// sender, as in the robot.
struct Robot {
  std::vector<int> station;
  std::vector<test::Release> releases;
};
Robot robot_with_everything_at_once(const std::vector<AnalysedMessage>& messages) {
  Robot robot;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const AnalysedMessage& message = messages[i];
    const Identified what = *kFullProfile.identify(message.id);
    robot.station.push_back(layout(what.kind).sender == Sender::local_controller ? what.node : 0);
    // Zeros are the longest payload for most identifiers.
    const Frame frame{.id = message.id, .size = static_cast<std::uint8_t>(message.bytes), .data = {}};
    for (std::int64_t k = 0; k < 20; ++k) {
      const std::int64_t nominal_ns = k * message.period_ns;
      robot.releases.push_back({nominal_ns + (k == 0 ? message.jitter_ns : 0), nominal_ns, i, frame});
    }
  }
  std::stable_sort(robot.releases.begin(), robot.releases.end(),
                   [](const auto& a, const auto& b) { return a.at_ns < b.at_ns; });
  return robot;
}

void expect_within(const Proof& proof, const test::BusTraffic& traffic) {
  for (std::size_t i = 0; i < proof.messages.size(); ++i) {
    ASSERT_TRUE(traffic.worst_ns()[i]);
    EXPECT_LE(*traffic.worst_ns()[i] + kInterframeBits * 1000, proof.responses[i].worst_response_ns)
        << proof.messages[i].name;
  }
}

TEST(NetworkProof, TheSimulatedRobotStaysWithinIt) {
  const Proof proof =
      prove(kFullProfile, nodes(22), {.jitter_ns = 1 * kMillisecond_ns, .errors = {}, .bit_time_ns = 1000});
  const Robot robot = robot_with_everything_at_once(proof.messages);
  test::BusTraffic traffic(proof.messages, robot.station, 1000);
  traffic.play(robot.releases);
  expect_within(proof, traffic);
}

// The jam comes at any instant of the busiest time.
TEST(NetworkProof, TheSimulatedRobotStaysWithinItWhileTheBusIsJammed) {
  const Proof proof = prove(kFullProfile, nodes(22), kWorstCase);
  const Robot robot = robot_with_everything_at_once(proof.messages);
  std::uint64_t jammed = 0;
  for (std::int64_t from_ns = 900'000; from_ns < 6 * kMillisecond_ns; from_ns += 87'000) {
    SCOPED_TRACE(testing::Message() << "jam from " << from_ns << " ns");
    test::BusTraffic traffic(proof.messages, robot.station, 1000);
    test::ErrorInjector jam(kWorstCase.errors, from_ns, 1);
    traffic.play(robot.releases, &jam);
    expect_within(proof, traffic);
    EXPECT_TRUE(jam.all_active());
    jammed += traffic.bus().statistics().injected.jammed_frames;
  }
  EXPECT_GT(jammed, 50U) << "frames were on the wire";
}

}  // namespace
}  // namespace gaitway::can
