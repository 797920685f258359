// One status for each part of the robot.
#include "gaitway/api/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "gaitway/api/state_messages.hpp"

namespace gaitway::api {
namespace {

using Level = DiagnosticLevel;

constexpr std::int64_t kHeartbeatSilence_ns = 100'000'000;  // beats come every millisecond
constexpr std::string_view kNotThere = "nothing has been heard of it yet";

template <class Value>
void add(ros::DiagnosticStatus& status, std::string_view key, const Value& value) {
  status.values.push_back({std::string(key), fmt::format("{}", value)});
}

void add_us(ros::DiagnosticStatus& status, std::string_view key, std::int64_t time_ns) {
  status.values.push_back({std::string(key), fmt::format("{:.1f}", static_cast<double>(time_ns) * 1e-3)});
}

void say(ros::DiagnosticStatus& status, Level level, std::string_view message) {
  status.level = static_cast<std::uint8_t>(level);
  status.message = message;
}

ros::DiagnosticStatus status_of(std::string name, const std::string& robot) {
  ros::DiagnosticStatus status;
  status.name = std::move(name);
  status.hardware_id = robot;
  return status;
}

// How something is, and how that is to be taken.
struct Condition {
  Level level;
  std::string_view text;
};
constexpr std::array kPluginConditions{
    Condition{Level::ok, "works"},
    Condition{Level::warning, "failed in its last step"},
    Condition{Level::error, "out of service"},
    Condition{Level::warning, "stopped"},
};

constexpr std::array kBusConditions{
    Condition{Level::ok, "error-active"},
    Condition{Level::warning, "error-passive"},
    Condition{Level::error, "bus-off"},
    Condition{Level::error, "down"},
};

constexpr std::array kModes{
    Condition{Level::ok, "plays batches"},
    Condition{Level::warning, "plays a safe tail"},
    Condition{Level::ok, "holds, and waits for a batch"},
    Condition{Level::error, "emergency stop: /release ends it"},
};

constexpr std::array<std::string_view, 5> kNodeFaults{"position limit", "torque saturated", "SYNC lost",
                                                      "encoder", "restarted"};

// The row of a table; the last one for what is beyond it.
template <class Row, std::size_t size>
const Row& row_of(const std::array<Row, size>& table, std::uint32_t index) noexcept {
  return table[std::min<std::size_t>(index, size - 1)];
}

std::string faults_of(const NetworkHealth& health, std::size_t joint) {
  std::string text;
  const auto say_also = [&](std::string_view what) {
    if (!text.empty()) text += ", ";
    text += what;
  };
  if ((health.missing >> joint & 1U) != 0) say_also("missing");
  for (std::size_t bit = 0; bit < kNodeFaults.size(); ++bit) {
    if ((health.faults[joint] >> bit & 1U) != 0) say_also(kNodeFaults[bit]);
  }
  return text;
}

}  // namespace

Diagnostics::Diagnostics(const urdf::RobotModel& model) : robot_(model.name) {
  for (const urdf::Joint& joint : model.joints) joints_.push_back(joint.name);
}

ros::DiagnosticArray Diagnostics::report(const RobotCondition& condition) {
  ros::DiagnosticArray array;
  array.header.stamp = ros_time(condition.stamp_ns);
  if (condition.plugins != nullptr) add_plugins(*condition.plugins, array.status);
  array.status.push_back(bus(condition.health));
  array.status.push_back(nodes(condition.health));
  array.status.push_back(loop(condition));
  return array;
}

void Diagnostics::add_plugins(const PluginStatistics& plugins, std::vector<ros::DiagnosticStatus>& to) {
  const std::size_t count = std::min<std::size_t>(plugins.plugin_count, kReportedPlugins);
  const bool known =
      before_.plugin_faults.size() == count;  // the same plug-ins as before, as far as one sees
  for (std::size_t i = 0; i < count; ++i) {
    ros::DiagnosticStatus status = status_of("plugin/" + text_of(plugins.name[i]), robot_);
    const Condition& state = row_of(kPluginConditions, plugins.state[i]);
    say(status, state.level, state.text);
    if (state.level == Level::ok && known && plugins.faults[i] > before_.plugin_faults[i]) {
      say(status, Level::warning,
          fmt::format("works; {} faults since the last report",
                      plugins.faults[i] - before_.plugin_faults[i]));
    }
    add(status, "steps", plugins.steps[i]);
    add(status, "faults", plugins.faults[i]);
    add(status, "overruns", plugins.overruns[i]);
    add_us(status, "budget_us", plugins.budget_ns[i]);
    add_us(status, "last_step_us", plugins.last_step_ns[i]);
    add_us(status, "p50_step_us", plugins.p50_step_ns[i]);
    add_us(status, "p99_step_us", plugins.p99_step_ns[i]);
    add_us(status, "worst_step_us", plugins.worst_step_ns[i]);
    add_us(status, "worst_input_age_us", plugins.worst_input_age_ns[i]);
    to.push_back(std::move(status));
  }
  before_.plugin_faults.assign(plugins.faults, plugins.faults + count);
}

ros::DiagnosticStatus Diagnostics::bus(const NetworkHealth* health) {
  ros::DiagnosticStatus status = status_of("bus", robot_);
  if (health == nullptr) {
    say(status, Level::stale, kNotThere);
    return status;
  }
  const Condition& state = row_of(kBusConditions, health->bus_state);
  say(status, state.level, state.text);
  add(status, "transmit_errors", health->transmit_errors);
  add(status, "receive_errors", health->receive_errors);
  std::uint64_t incidents = 0;
  for (const FieldDescriptor& field : TopicType<NetworkHealth>::fields) {
    if (field.type == ScalarType::uint64_value && field.name != "missing") {  // a counter
      std::uint64_t count = 0;
      std::memcpy(&count, reinterpret_cast<const std::byte*>(health) + field.offset, sizeof count);
      add(status, field.name, count);
      incidents += count;
    }
  }
  if (state.level == Level::ok && incidents > before_.incidents.value_or(incidents)) {
    say(status, Level::warning,
        fmt::format("{}; {} incidents since the last report", state.text, incidents - *before_.incidents));
  }
  before_.incidents = incidents;
  return status;
}

ros::DiagnosticStatus Diagnostics::nodes(const NetworkHealth* health) const {
  ros::DiagnosticStatus status = status_of("nodes", robot_);
  if (health == nullptr) {
    say(status, Level::stale, kNotThere);
    return status;
  }
  std::size_t missing = 0, faulty = 0;
  for (std::size_t joint = 0; joint < std::min<std::size_t>(joints_.size(), kMaxJoints); ++joint) {
    const std::string faults = faults_of(*health, joint);
    if (faults.empty()) continue;
    ((health->missing >> joint & 1U) != 0 ? missing : faulty) += 1;
    add(status, joints_[joint], faults);
  }
  if (missing + faulty == 0) {
    say(status, Level::ok, "all joints answer");
  } else {
    say(status, missing > 0 ? Level::error : Level::warning,
        fmt::format("{} joints are missing, {} report faults", missing, faulty));
  }
  return status;
}

ros::DiagnosticStatus Diagnostics::loop(const RobotCondition& condition) {
  ros::DiagnosticStatus status = status_of("loop", robot_);
  const NetworkState* state = condition.network;
  if (state == nullptr) {
    say(status, Level::stale, kNotThere);
  } else {
    const Condition& mode = row_of(kModes, state->mode);
    say(status, mode.level, mode.text);
    const std::uint64_t refusals = state->late + state->refused;
    if (mode.level == Level::ok && refusals > before_.refusals.value_or(refusals)) {
      say(status, Level::warning,
          fmt::format("{}; {} batches late or refused since the last report", mode.text,
                      refusals - *before_.refusals));
    }
    before_.refusals = refusals;
    add(status, "mode", mode.text);
    add(status, "cycle", state->cycle);
    add(status, "accepted_sequence", state->accepted_sequence);
    add(status, "handed_over", state->handed_over);
    add(status, "late", state->late);
    add(status, "refused", state->refused);
    add(status, "tail_played", state->tail_played);
    add(status, "repaired", state->repaired);
    add(status, "resynchronised", state->resynchronised);
  }
  add(status, "heartbeat_age_ms", condition.heartbeat_age_ns / 1'000'000);
  if (condition.heartbeat_age_ns > kHeartbeatSilence_ns) {
    say(status, Level::stale, "the message controller has fallen silent; is it running?");
  }
  return status;
}

}  // namespace gaitway::api
