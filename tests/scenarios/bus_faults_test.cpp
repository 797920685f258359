// The robot walks on a bus on which everything goes wrong: it does not fall, every loss is found and
// repaired, and the counters agree with what was really injected.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

using facts::kMillisecond_ns;
using facts::kSlot_ns;

constexpr std::size_t kJoints = 22;

// Looks at each delivery and each joint from outside, with other eyes than the message controller.
class BusWitness final : public simulator::CosimulationObserver {
 public:
  BusWitness(simulator::Cosimulation& run, tools::RunRecorder& next) : run_(run), next_(next) {
    heard_.fill(-1);
  }
  void on_frame(const can::SimulatedBus::Delivery& delivery) override {
    next_.on_frame(delivery);
    const auto heard = can::kFullProfile.identify(delivery.frame.id);
    const int station = 1 + joint_of(heard->node);  // the message controller is station 0
    if (heard->kind == can::MessageKind::trajectory && !delivery.received_by(station)) {
      ++trajectories_lost;
    }
    const auto sync = can::decode_sync(can::kFullProfile, delivery.frame);
    for (int joint = 0; sync && sync->batch_committed && sync->slot == 0 && joint < static_cast<int>(kJoints);
         ++joint) {
      trajectories_lost += delivery.received_by(1 + joint) ? 0U : 1U;  // it cannot start its batch
    }
    if (heard->kind == can::MessageKind::feedback && delivery.received_by(0)) {
      heard_[static_cast<std::size_t>(station - 1)] = (delivery.end_ns - 1) / kSlot_ns;
    }
  }
  void on_millisecond(std::int64_t now_ns) override {
    next_.on_millisecond(now_ns);
    if (now_ns % kSlot_ns == 0) {
      end_slot(now_ns / kSlot_ns - 1);
    }
    if (now_ns % kSlot_ns == 9 * kMillisecond_ns) {
      compare_counts();
    }
  }
  std::uint64_t trajectories_lost = 0;  // joints without a batch's frame, or without the SYNC that starts it
  std::uint64_t feedback_lost = 0;
  std::uint64_t nodes_silent = 0;                           // for two slots
  std::array<int, kJoints> wrong_slots{}, longest_wrong{};  // joint's reference is not the expected one

 private:
  [[nodiscard]] int joint_of(can::NodeId node) const {
    return node == 0 ? 0 : run_.robot().joint_of_node(node).value();
  }
  void end_slot(std::int64_t slot) {
    for (const std::int64_t last : heard_) {
      feedback_lost += last >= 0 && last != slot ? 1U : 0U;
      nodes_silent += last >= 0 && slot - last == 2 ? 1U : 0U;
    }
  }
  void compare_counts() {
    for (std::size_t j = 0; j < kJoints; ++j) {
      const int joint = static_cast<int>(j);
      const bool wrong =
          run_.joints().joint(joint).reference_count() != run_.message_controller().expected_count(joint);
      wrong_slots[j] = wrong ? wrong_slots[j] + 1 : 0;
      longest_wrong[j] = std::max(longest_wrong[j], wrong_slots[j]);
    }
  }
  simulator::Cosimulation& run_;
  tools::RunRecorder& next_;
  std::array<std::int64_t, kJoints> heard_{};  // slot of each joint's last feedback
};

simulator::Scenario walk_with(double seconds, std::vector<simulator::ScenarioEvent> faults) {
  simulator::Scenario scenario{.seconds = seconds, .events = {walk_at(1.0, 0.15)}};
  scenario.events.insert(scenario.events.end(), faults.begin(), faults.end());
  return scenario;
}

// 1 % of the frames corrupted, 0.1 % omitted somewhere.
simulator::ScenarioEvent disturbance(double seconds) {
  return {2.0,
          simulator::DisturbBusFault{.corruption = 0.01, .omission = 0.001, .duration_s = seconds - 4.0}};
}

void expect_walks(SimulatedRun& run, BusWitness& witness, const simulator::Scenario& scenario) {
  run.cosimulation.observe(&witness);
  run.play(scenario);
  ASSERT_FALSE(run.metrics().fell) << "at " << run.metrics().fell_at_s << " s";
  EXPECT_GT(run.metrics().distance_m(), 0.12 * (scenario.seconds - 2.0));
  const NetworkHealth& found = run.cosimulation.message_controller().health();
  const can::BusStatistics& bus = run.cosimulation.bus().statistics();
  EXPECT_GT(bus.injected.corruptions, scenario.seconds * 10.0);
  EXPECT_GT(bus.injected.omissions, scenario.seconds);
  EXPECT_EQ(bus.error_frames, bus.injected.corruptions + bus.injected.forced_failures)
      << "nothing else went wrong";
  EXPECT_EQ(found.feedback_lost, witness.feedback_lost);
  EXPECT_EQ(found.feedback_missing, witness.nodes_silent);
  EXPECT_EQ(found.nodes_returned, witness.nodes_silent);
  EXPECT_EQ(found.forged + found.unknown_identifiers + found.wrong_lengths + found.second_senders, 0U);
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    EXPECT_EQ(witness.wrong_slots[joint], 0) << "repaired in the end: joint " << joint;
  }
}

// What is lost is found, one for one, and no joint is wrong for long.
void expect_finds_every_loss(std::uint64_t seed, double seconds) {
  SCOPED_TRACE(seed);
  SimulatedRun run(seed);
  BusWitness witness(run.cosimulation, run.recorder);
  expect_walks(run, witness, walk_with(seconds, {disturbance(seconds)}));
  EXPECT_EQ(run.cosimulation.message_controller().health().trajectories_lost, witness.trajectories_lost);
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    EXPECT_LE(witness.longest_wrong[joint], 2) << "joint " << joint;
  }
}

// And a bus-off of the message controller and of a leg's joint, the restart of an arm's joint and a quick one
// of a leg's.
void expect_survives(std::uint64_t seed, double seconds) {
  SCOPED_TRACE(seed);
  SimulatedRun run(seed);
  BusWitness witness(run.cosimulation, run.recorder);
  using namespace simulator;
  expect_walks(
      run, witness,
      walk_with(seconds, {disturbance(seconds), ScenarioEvent{6.0, BusOffFault{"message_controller"}},
                          ScenarioEvent{10.0, BusOffFault{"left_knee"}},
                          ScenarioEvent{14.0, JointRestartsFault{"right_elbow", 0.3}},
                          ScenarioEvent{18.0, JointRestartsFault{"left_hip_pitch", 0.02}}}));
  const NetworkHealth& found = run.cosimulation.message_controller().health();
  const can::BusStatistics& bus = run.cosimulation.bus().statistics();
  EXPECT_EQ(bus.injected.forced_bus_offs, 2U);
  EXPECT_EQ(bus.bus_offs, 2U);
  EXPECT_EQ(bus.recoveries, 2U);
  EXPECT_EQ(found.bus_offs, 1U) << "its own; it cannot see another station's";
  EXPECT_EQ(bus.injected.power_offs, 2U);
  EXPECT_EQ(found.nodes_restarted, 2U);
  EXPECT_GE(found.trajectories_lost, witness.trajectories_lost) << "some were flushed at the bus-off";
}

// The robot walks, a station that does not belong there speaks once, and within a time slot its cause is
// known.
class ForeignFrames : public ::testing::Test {
 protected:
  const NetworkHealth& after(const can::Frame& frame) {
    run_.play({.seconds = 4.0, .events = {walk_at(1.0, 0.15), {3.5, simulator::ForeignFrameFault{frame}}}});
    return run_.cosimulation.message_controller().health();
  }
  void expect_reported() {
    const core::EventLog& log = run_.cosimulation.main_controller().events();
    int reports = 0;
    for (std::uint64_t number = log.first(); number < log.total(); ++number) {
      const bool about_it = log[number].text().find("message network: 1 ") != std::string_view::npos;
      reports += about_it ? 1 : 0;
      EXPECT_TRUE(!about_it || log[number].stamp_ns <= 3'500'000'000 + 2 * kSlot_ns) << log[number].text();
    }
    EXPECT_EQ(reports, 1);
  }
  void expect_goes_on() {
    expect_reported();
    EXPECT_FALSE(run_.metrics().fell);
    EXPECT_EQ(run_.cosimulation.message_controller().mode(), msgcontroller::Mode::batches);
  }
  void expect_safe_stop() {
    expect_reported();
    bool stood = false;
    for (int ms = 0; ms < 3000 && !run_.metrics().fell; ++ms) {
      run_.cosimulation.advance_millisecond();
      stood = stood || run_.cosimulation.message_controller().mode() == msgcontroller::Mode::holding;
    }
    EXPECT_TRUE(stood);
    EXPECT_FALSE(run_.metrics().fell);
  }
  SimulatedRun run_{5};
};

TEST_F(ForeignFrames, AnUnknownIdentifierDisturbsNothing) {
  EXPECT_EQ(after({.id = 0x7AB, .size = 2, .data = {1, 2}}).unknown_identifiers, 1U);
  expect_goes_on();
}

TEST_F(ForeignFrames, AWrongLengthDisturbsNothing) {
  can::Frame frame = can::encode(can::kFullProfile, can::Feedback{.node = 5});
  frame.size = 3;
  EXPECT_EQ(after(frame).wrong_lengths, 1U);
  expect_goes_on();
}

TEST_F(ForeignFrames, ARemoteFrameDisturbsNothing) {
  EXPECT_EQ(after({.id = 0x7AB, .size = 2, .remote = true}).remote_frames, 1U);
  expect_goes_on();
}

TEST_F(ForeignFrames, AnExtendedFrameDisturbsNothing) {
  EXPECT_EQ(after({.id = 0x1234567, .size = 2, .extended = true}).extended_frames, 1U);
  expect_goes_on();
}

TEST_F(ForeignFrames, AForgedTrajectoryEndsInASafeStop) {
  EXPECT_EQ(after(can::encode(can::kFullProfile, can::Trajectory{4, true, {90, 90, 90, 90, 90, 90, 90, 90}}))
                .forged,
            1U);
  expect_safe_stop();
}

TEST_F(ForeignFrames, AForgedUserCommandEndsInASafeStop) {
  EXPECT_EQ(after(can::encode(can::kFullProfile, can::UserCommand{4, 800, 1})).forged, 1U);
  expect_safe_stop();
}

TEST_F(ForeignFrames, AForgedRepairEndsInASafeStop) {
  EXPECT_EQ(after(can::encode(can::kFullProfile, can::Resynchronisation{19, true, 7, 300, {}})).forged, 1U);
  expect_safe_stop();
}

TEST(BusFaults, EveryLossOnADisturbedBusIsFoundAndRepaired) {
  for (int seed = 1; seed <= seeds(3); ++seed) {
    expect_finds_every_loss(static_cast<std::uint64_t>(seed), 30.0);
  }
}

TEST(BusFaults, TheRobotWalksOnThroughBusOffsAndRestarts) {
  for (int seed = 1; seed <= seeds(3); ++seed) {
    expect_survives(static_cast<std::uint64_t>(seed), 30.0);
  }
}

#if GAITWAY_SEED_PERCENT > 100
TEST(BusFaults, TenMinutesOnATroubledBus) {
  expect_finds_every_loss(1, 600.0);
  expect_survives(2, 600.0);
}
#endif

}  // namespace
}  // namespace gaitway::scenarios
