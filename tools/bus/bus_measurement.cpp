// Meters frames, and lets the co-simulation make them.
#include "tools/bus/bus_measurement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/simulator/cosimulation.hpp"

namespace gaitway::tools {
namespace {

using can::MessageKind;
using facts::kCycle_ns;
using facts::kMillisecond_ns;

// Manual movements: each joint a little forth and back, at instants that fall on every millisecond of a slot.
constexpr double kMovement_rad = 0.02;
constexpr int kMovement_slots = 5;
constexpr std::int64_t kBetweenCommands_ns = 103 * kMillisecond_ns;
constexpr std::int64_t kStandStill_ns = 500 * kMillisecond_ns;
constexpr int kRounds = 2;  // forth and back

double length_us(const can::Frame& frame) {
  return static_cast<double>((can::frame_bits(frame) + can::kInterframeBits) * facts::kBitTime_ns) * 1e-3;
}

simulator::CosimulationOptions cosimulation_options(const BusExperiment& experiment) {
  simulator::CosimulationOptions options;
  options.plant.seed = experiment.seed;
  options.plant.mismatch = experiment.mismatch;
  options.main_controller.configuration = experiment.config;
  return options;
}

// Hands a stretch of the run's frames on.
class Observer final : public simulator::CosimulationObserver {
 public:
  using Take = std::function<void(const can::TimedFrame&)>;
  explicit Observer(Take take) : take_(std::move(take)) {}
  void on_frame(const can::SimulatedBus::Delivery& delivery) override {
    take_({.frame = delivery.frame, .start_ns = delivery.start_ns, .end_ns = delivery.end_ns});
  }
  void on_millisecond(std::int64_t) override {}

 private:
  Take take_;
};

void advance_until(simulator::Cosimulation& run, std::int64_t until_ns) {
  while (run.now_ns() < until_ns) {
    run.advance_millisecond();
    if (run.plant().fallen()) {
      throw std::runtime_error(fmt::format(
          "the robot fell after {:.2f} s, so nothing was measured. Choose a slower --walk or another --seed",
          static_cast<double>(run.now_ns()) * 1e-9));
    }
  }
}

void walk(const BusRobot& robot, const BusExperiment& experiment, BusMeasurement& measurement) {
  simulator::Cosimulation run(robot.model, cosimulation_options(experiment));
  const auto from_ns = static_cast<std::int64_t>(std::llround(kNotMeasured_s * 1e9)) / kCycle_ns * kCycle_ns;
  Observer observer([&](const can::TimedFrame& frame) {
    if (frame.start_ns >= from_ns) {
      measurement.take(frame);
    }
  });
  run.observe(&observer);
  const simulator::Scenario scenario = simulator::walk_scenario(experiment.walk[0], experiment.walk[1],
                                                                experiment.walk[2], experiment.seconds);
  for (const simulator::ScenarioEvent& event : scenario.events) {
    advance_until(run, std::llround(event.at_s * 1e9));
    run.apply(event);
  }
  advance_until(run, std::llround(scenario.seconds * 1e9));
}

// Without batches, since only a robot that holds still takes manual commands.
void move_by_hand(const BusRobot& robot, const BusExperiment& experiment, BusMeasurement& measurement) {
  simulator::Cosimulation run(robot.model, cosimulation_options(experiment));
  std::int64_t asked_ns = 0;
  Observer observer([&](const can::TimedFrame& frame) {
    const auto message = robot.profile.identify(frame.frame.id);
    if (message && message->kind == MessageKind::user_command) {
      measurement.take_user_command(frame.frame);
      measurement.user_command_on_joints(frame.end_ns - asked_ns);
    }
  });
  run.observe(&observer);
  run.apply({0.0, simulator::MainControllerSilentFault{}});
  advance_until(run, kStandStill_ns);
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t joint = 0; joint < robot.model.joints.size(); ++joint) {
      const urdf::Joint& description = robot.model.joints[joint];
      if (description.node > robot.profile.largest_node) {
        continue;
      }
      const double target_rad = description.home_rad + (round == 0 ? kMovement_rad : 0.0);
      asked_ns = run.now_ns();
      measurement.user_command_asked();
      run.apply({0.0, simulator::ManualJointEvent{static_cast<int>(joint), target_rad, kMovement_slots}});
      advance_until(run, asked_ns + kBetweenCommands_ns);
    }
  }
}

}  // namespace

BusMeasurement::BusMeasurement(const BusRobot& robot, BusClock clock)
    : watch_(robot.profile, robot.nodes, clock),
      trajectories_(robot.nodes.size(), robot.profile.row(MessageKind::trajectory).period_ns),
      feedbacks_(robot.nodes.size(), robot.profile.row(MessageKind::feedback).period_ns) {}

void BusMeasurement::take(const can::TimedFrame& frame) {
  watch_.take(frame);
  if (frame.start_ns >= growing_start_ns_ + kCycle_ns) {
    cycle_.swap(growing_);
    cycle_start_ns_ = growing_start_ns_;
    growing_.clear();
    growing_start_ns_ = frame.start_ns / kCycle_ns * kCycle_ns;
  }
  growing_.push_back(frame);
  const auto message = watch_.profile().identify(frame.frame.id);
  if (!message || frame.frame.extended || frame.frame.remote) {
    return;
  }
  const std::int64_t length_ns = (can::frame_bits(frame.frame) + can::kInterframeBits) * facts::kBitTime_ns;
  if (message->kind == MessageKind::trajectory) {
    trajectories_.take(message->node, frame.start_ns, length_ns);
  } else if (message->kind == MessageKind::feedback) {
    feedbacks_.take(message->node, frame.start_ns, length_ns);
  } else if (message->kind == MessageKind::user_command) {
    take_user_command(frame.frame);
  }
}

void BusMeasurement::take_user_command(const can::Frame& frame) {
  user_commands_.length_us.add(length_us(frame));
  can::Frame filled = frame;
  filled.size = 8;
  std::fill(filled.data.begin() + frame.size, filled.data.end(), std::uint8_t{0});
  user_commands_.eight_byte_length_us.add(length_us(filled));
  std::copy(frame.data.begin(), frame.data.begin() + 4, filled.data.begin() + 4);
  user_commands_.two_commands_length_us.add(length_us(filled));
}

BusMeasurement measure_simulated_bus(const BusRobot& robot, const BusExperiment& experiment) {
  BusMeasurement measurement(robot, BusClock::robot);
  walk(robot, experiment, measurement);
  move_by_hand(robot, experiment, measurement);
  return measurement;
}

void FrameSetMeter::take(can::NodeId node, std::int64_t start_ns, std::int64_t length_ns) {
  const bool late = !seen_.empty() && start_ns > first_ns_ + period_ns_ / 2;
  if (late || seen_.contains(node)) {
    ++incomplete_;
    seen_.clear();
  }
  if (seen_.empty()) {
    first_ns_ = start_ns;
    bus_time_ns_ = 0;
  }
  seen_.insert(node);
  bus_time_ns_ += length_ns;
  last_ns_ = start_ns + length_ns;
  if (seen_.size() < nodes_) {
    return;
  }
  seen_.clear();
  bus_time_ms_.add(static_cast<double>(bus_time_ns_) * 1e-6);
  span_ms_.add(static_cast<double>(last_ns_ - first_ns_) * 1e-6);
  if (last_ns_ - first_ns_ == bus_time_ns_) {
    back_to_back_ms_.add(static_cast<double>(last_ns_ - first_ns_) * 1e-6);
  }
}

}  // namespace gaitway::tools
