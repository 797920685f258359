// What all joints of the simulated robot saw while it walked, played on the microcontroller: with trims, lost
// frames and their repairs, a push and an emergency stop.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "emulator.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/joint_network.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "trace_output.hpp"
#include "trace_writer.hpp"

namespace gaitway::firmware {
namespace {

// Writes down what reaches each joint, and which torque it answered in the simulation.
class TraceRecorder final : public simulator::CosimulationObserver {
 public:
  explicit TraceRecorder(simulator::Cosimulation& run) : run_(run) {
    for (int joint = 0; joint < run_.joints().size(); ++joint) {
      trace_.joint(joint, run_.joints().config(joint));
    }
    run_.observe(this);
    record_steps(run_.now_ns());
  }
  void on_frame(const can::SimulatedBus::Delivery& delivery) override {
    const auto identified = can::kFullProfile.identify(delivery.frame.id);
    if (delivery.lost || !identified) {
      return;
    }
    ++received[identified->kind];
    trace_.frame(delivery.frame);
    const can::NodeId sender = can::layout(identified->kind).sender == can::Sender::local_controller
                                   ? identified->node
                                   : can::NodeId{0};
    for (int joint = 0; joint < run_.joints().size(); ++joint) {
      if (run_.robot().joints[static_cast<std::size_t>(joint)].node != sender) {
        trace_.received(joint, run_.joints().local_time_ns(joint, delivery.end_ns));
        trace_.take(joint);
      }
    }
  }
  void on_millisecond(std::int64_t now_ns) override {
    torque_Nm.insert(torque_Nm.end(), run_.joints().torque_Nm().begin(), run_.joints().torque_Nm().end());
    record_steps(now_ns);
  }
  [[nodiscard]] std::vector<std::uint8_t> finish() {
    run_.observe(nullptr);
    return trace_.finish();
  }

  std::vector<double> torque_Nm;  // of every joint in every millisecond
  std::map<can::MessageKind, int> received;

 private:
  // The joints step first in the millisecond that begins now.
  void record_steps(std::int64_t now_ns) {
    for (int joint = 0; joint < run_.joints().size(); ++joint) {
      trace_.step(joint, run_.joints().local_time_ns(joint, now_ns),
                  run_.joints().sensors(joint, run_.plant().sensors()));
      trace_.take(joint);
    }
  }

  simulator::Cosimulation& run_;
  TraceWriter trace_;
};

struct Recording {
  std::vector<std::uint8_t> trace;
  std::vector<double> torque_Nm;
  std::map<can::MessageKind, int> received;
};

const Recording& walk() {
  static const Recording recording = [] {
    const std::filesystem::path source(GAITWAY_SOURCE_DIR);
    simulator::CosimulationOptions options;
    options.plant.seed = 11;
    options.main_controller.configuration = source / "core/config/walk.yaml";
    options.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
    simulator::Cosimulation run(urdf::load_robot(source / "urdf/humanoid22"), options);
    const std::vector<simulator::ScenarioEvent> events{
        {0.5, simulator::WalkEvent{.velocity_m_per_s = {0.15, 0.0}}},
        {1.0, simulator::LoseFramesFault{.probability = 0.06, .duration_s = 4.0}},
        {4.0, simulator::PushEvent{.body = "trunk", .direction = {0.0, 1.0, 0.0}, .impulse_Ns = 0.5}},
        {5.7, simulator::EmergencyStopEvent{.soft = true}}};
    TraceRecorder recorder(run);
    auto event = events.begin();
    while (run.now_ns() < 6'000'000'000) {
      for (; event != events.end() && event->at_s * 1e9 <= static_cast<double>(run.now_ns()); ++event) {
        run.apply(*event);
      }
      run.advance_millisecond();
    }
    std::vector<std::uint8_t> trace = recorder.finish();
    return Recording{std::move(trace), recorder.torque_Nm, recorder.received};
  }();
  return recording;
}

TEST(WalkingTrace, IsWhatHappenedInTheSimulation) {
  const Recording& recording = walk();
  const auto received = [&recording](can::MessageKind kind) {
    const auto found = recording.received.find(kind);
    return found == recording.received.end() ? 0 : found->second;
  };
  EXPECT_GT(received(can::MessageKind::trim), 400);
  EXPECT_GT(received(can::MessageKind::trajectory), 1'000);
  EXPECT_GT(received(can::MessageKind::resynchronisation), 5);
  EXPECT_EQ(received(can::MessageKind::emergency_stop), 1);
  const Played played = play_here(recording.trace);
  ASSERT_EQ(played.result, ReplayResult::complete);
  AnswerReader answers(recording.trace, played.output);
  std::size_t step = 0, different = 0;
  while (const auto answer = answers.next()) {
    if (answer->kind == TraceRecord::step && step < recording.torque_Nm.size()) {
      different += std::bit_cast<std::uint64_t>(answer->torque_Nm) ==
                           std::bit_cast<std::uint64_t>(recording.torque_Nm[step])
                       ? 0U
                       : 1U;
      ++step;
    }
  }
  EXPECT_EQ(step, 6000U * 22U);
  EXPECT_EQ(different, 0U) << "torques of the recording that are not those of the simulation";
}

TEST_F(EmulatedFirmware, PlaysAWalkToTheBit) {
  report_cost(expect_same_bits(walk().trace));
}

}  // namespace
}  // namespace gaitway::firmware
