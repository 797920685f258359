// Orders into queues, answers back by their numbers.
#include "gaitway/api/memory_robot_port.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <ctime>
#include <random>
#include <stdexcept>

#include "gaitway/api/recorder.hpp"
#include "gaitway/api/state_messages.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/mails.hpp"

namespace gaitway::api {
namespace {

using Kind = msgclient::UserCommandKind;

constexpr std::int64_t kControllerSilence_ns = 1'000'000'000;  // of the message controller, by the wall clock

template <std::size_t size>
bool copy_text(const std::string& text, std::uint8_t (&field)[size]) noexcept {
  const bool fits = text.size() < size;
  std::memcpy(field, text.data(), fits ? text.size() : 0);
  return fits;
}

UserCommand command_of(Kind kind) noexcept {
  UserCommand command{};
  command.kind = static_cast<std::uint32_t>(kind);
  return command;
}

std::string state_text(std::uint32_t state) {
  constexpr std::array<const char*, 4> kNames{"works", "failing", "out of service", "stopped"};
  return state < kNames.size() ? kNames[state] : "unknown";
}

}  // namespace

MemoryRobotPort::MemoryRobotPort(msgclient::Client& client, const urdf::RobotModel& robot, Recorder* recorder)
    : client_(client),
      recorder_(recorder),
      walk_requests_(client.write<WalkCommand>("walk_request")),
      stop_requests_(client.write<StopRequest>("stop_request")),
      stop_answers_(client.read<StopRequest>("stop_answer")),
      commands_(client.write_queue<UserCommand>("user_command")),
      command_answers_(client.read_stream<UserCommandAnswer>("user_command_answer")),
      orders_(client.write_queue<PluginRequest>("api_plugin_request")),
      order_answers_(client.read_stream<PluginAnswer>("plugin_answer")),
      statistics_(client.read<PluginStatistics>("plugin_statistics")),
      network_(client.read<NetworkState>("network_state")),
      motion_requests_(client.write<MotionRequest>("motion_request")),
      motion_states_(client.read<MotionState>("motion_state")),
      last_number_(std::random_device{}()) {  // answers to a process before this one are not ours
  for (const urdf::Joint& joint : robot.joints) {
    joints_.push_back({joint.name, joint.lower_rad, joint.upper_rad});
  }
  // Goes on from what was obeyed, never from what a process before this one has left in its own topic.
  static_cast<void>(stop_answers_.read(stops_asked_));
  stop_requests_.publish(stops_asked_, now_ns());
}

void MemoryRobotPort::observe(std::int64_t wall_ns) noexcept {
  const std::int64_t beat_ns = client_.heartbeat_ns();
  if (beat_ns != heartbeat_ns_) {
    heartbeat_ns_ = beat_ns;
    heard_ns_ = wall_ns;
  }
  connected_ = heartbeat_ns_ != 0 && wall_ns - heard_ns_ < kControllerSilence_ns;
}

std::int64_t MemoryRobotPort::now_ns() const {
  return client_.heartbeat_ns();
}

void MemoryRobotPort::walk(const Velocity& velocity, std::int64_t valid_ns) {
  const bool moves =
      velocity.forward_m_per_s != 0.0 || velocity.left_m_per_s != 0.0 || velocity.turn_rad_per_s != 0.0;
  if (!moves) {
    stand();  // what clients mean by a velocity of zero
    return;
  }
  const std::int64_t robot_ns = now_ns();
  WalkCommand request{};
  request.stamp_ns = robot_ns;
  request.walk = 1;
  request.velocity[0] = velocity.forward_m_per_s;
  request.velocity[1] = velocity.left_m_per_s;
  request.turn_rate = velocity.turn_rad_per_s;
  request.valid_until_ns = robot_ns + valid_ns;
  walk_requests_.publish(request, robot_ns);
}

void MemoryRobotPort::stand() {
  WalkCommand request{};
  request.stamp_ns = now_ns();
  walk_requests_.publish(request, request.stamp_ns);
}

std::uint32_t MemoryRobotPort::next_number() noexcept {
  last_number_ = std::max<std::uint32_t>(last_number_ + 1, 1);
  return last_number_;
}

std::uint32_t MemoryRobotPort::ask(std::uint32_t StopRequest::*kind) {
  constexpr std::size_t kMostAwaited = 65536;  // while nobody answers: the oldest run out of time unanswered
  stops_asked_.stamp_ns = now_ns();
  stops_awaited_.push_back({next_number(), kind, ++(stops_asked_.*kind)});
  stop_requests_.publish(stops_asked_, stops_asked_.stamp_ns);
  if (stops_awaited_.size() > kMostAwaited) {
    stops_awaited_.pop_front();
  }
  return last_number_;
}

// No answer is overwritten: the stream holds as many as the queue, whose commands alone can be without one
// when the stream has just been read.
std::optional<std::uint32_t> MemoryRobotPort::push(UserCommand command) {
  collect();
  command.number = next_number();
  if (!commands_.push(command, now_ns())) {
    return std::nullopt;
  }
  awaited_.insert(last_number_);
  return last_number_;
}

std::optional<std::uint32_t> MemoryRobotPort::stop() {
  return ask(&StopRequest::stops);
}

std::optional<std::uint32_t> MemoryRobotPort::emergency_stop(bool soft) {
  return ask(soft ? &StopRequest::softs : &StopRequest::holds);
}

std::optional<std::uint32_t> MemoryRobotPort::release() {
  return push(command_of(Kind::release));
}

bool MemoryRobotPort::emergency_stopped() const {
  NetworkState state;
  return network_.read(state) && state.mode == network_state::mode::emergency_stop;
}

std::optional<std::uint32_t> MemoryRobotPort::move_joint(int joint, double position_rad, double duration_s) {
  constexpr double kLongest_slots = 255.0;
  const double slots = std::clamp(std::ceil(duration_s * 1e9 / facts::kSlot_ns), 1.0, kLongest_slots);
  UserCommand command = command_of(Kind::manual_joint);
  command.joint = static_cast<std::uint32_t>(joint);
  command.duration_slots = static_cast<std::uint32_t>(slots);
  command.position = position_rad;
  return push(command);
}

std::optional<std::uint32_t> MemoryRobotPort::play_motion(std::string_view name) {
  if (name.empty() && motions_awaited_.empty()) {
    MotionState state{};
    static_cast<void>(motion_states_.read(state));
    if (state.state == 0) {
      return std::nullopt;  // nothing to leave
    }
  }
  MotionRequest request{};
  request.stamp_ns = now_ns();
  request.number = next_number();
  if (!copy_text(std::string(name), request.name)) {
    return std::nullopt;
  }
  motion_requests_.publish(request, request.stamp_ns);
  motions_awaited_.push_back(last_number_);
  return last_number_;
}

// A request that came before another one could be answered was never seen.
std::optional<OrderResult> MemoryRobotPort::take_motion_answer() {
  if (motions_awaited_.size() > 1) {
    const std::uint32_t number = motions_awaited_.front();
    motions_awaited_.pop_front();
    return OrderResult{number, false, "another motion was asked for before this one could begin"};
  }
  if (motions_awaited_.empty() || motion_states_.newest_sequence() == motion_state_seen_) {
    return std::nullopt;
  }
  MotionState state;
  const auto read = motion_states_.read(state);
  if (!read) {
    return std::nullopt;
  }
  motion_state_seen_ = read.sequence;
  if (state.answered != motions_awaited_.front()) {
    return std::nullopt;
  }
  motions_awaited_.pop_front();
  return OrderResult{state.answered, state.refused == 0, text_of(state.text)};
}

std::optional<std::uint32_t> MemoryRobotPort::order(const PluginOrder& order) {
  collect();
  PluginRequest request{};
  request.number = next_number();
  request.verb = static_cast<std::uint32_t>(order.verb);
  request.index = order.index;
  const bool fits = copy_text(order.plugin, request.plugin) && copy_text(order.library, request.library) &&
                    copy_text(order.parameter, request.parameter) && copy_text(order.value, request.value);
  if (!fits || !orders_.push(request, now_ns())) {
    return std::nullopt;
  }
  awaited_.insert(last_number_);
  return last_number_;
}

std::optional<OrderResult> MemoryRobotPort::take_result() {
  if (const auto answer = take_motion_answer()) {
    return answer;
  }
  if (auto recording = recorder_ == nullptr ? std::nullopt : recorder_->take_result()) {
    return recording;
  }
  collect();
  if (results_.empty()) {
    return std::nullopt;
  }
  OrderResult result = std::move(results_.front());
  results_.pop_front();
  return result;
}

// Reads every answer that has come.
void MemoryRobotPort::collect() {
  StopRequest obeyed;
  if (!stops_awaited_.empty() && stop_answers_.read(obeyed)) {
    std::erase_if(stops_awaited_, [&](const AwaitedStop& stop) {
      const bool done = static_cast<std::int32_t>(obeyed.*stop.kind - stop.count) >= 0;
      if (done) {
        results_.push_back({stop.number, true,
                            stop.kind == &StopRequest::stops ? "" : "the joints are stopped until /release"});
      }
      return done;
    });
  }
  UserCommandAnswer answer;
  while (command_answers_.read(answer)) {
    if (awaited_.erase(answer.number) != 0) {
      const auto reason = static_cast<msgclient::Reason>(answer.reason);
      results_.push_back(
          {answer.number, reason == msgclient::Reason::none,
           reason == msgclient::Reason::none ? "" : std::string(msgclient::reason_text(reason))});
    }
  }
  PluginAnswer done;
  while (order_answers_.read(done)) {
    if (awaited_.erase(done.number) != 0) {
      results_.push_back({done.number, done.done != 0, text_of(done.text)});
    }
  }
}

std::vector<PluginStatus> MemoryRobotPort::plugins() const {
  PluginStatistics values;
  std::vector<PluginStatus> list;
  if (!statistics_.read(values)) {
    return list;
  }
  const std::uint32_t count = std::min<std::uint32_t>(values.plugin_count, kReportedPlugins);
  for (std::size_t i = 0; i < count; ++i) {
    constexpr double kMicrosecond = 1e-3;
    list.push_back({.name = text_of(values.name[i]),
                    .state = state_text(values.state[i]),
                    .steps = values.steps[i],
                    .faults = values.faults[i],
                    .overruns = values.overruns[i],
                    .p50_step_us = static_cast<double>(values.p50_step_ns[i]) * kMicrosecond,
                    .p99_step_us = static_cast<double>(values.p99_step_ns[i]) * kMicrosecond,
                    .worst_step_us = static_cast<double>(values.worst_step_ns[i]) * kMicrosecond});
  }
  return list;
}

Recorder& MemoryRobotPort::recorder() const {
  if (recorder_ == nullptr) {
    throw std::runtime_error("this robot records nothing: its configuration names no folder to write to");
  }
  return *recorder_;
}

std::uint32_t MemoryRobotPort::start_recording(std::string_view name) {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), "%Y%m%dT%H%M%SZ", &utc);
  recorder().start(next_number(), name.empty() ? std::string(text.data(), size) : std::string(name),
                   now_ns());
  return last_number_;
}

std::uint32_t MemoryRobotPort::stop_recording() {
  recorder().stop(next_number());
  return last_number_;
}

std::uint32_t MemoryRobotPort::list_recordings(std::size_t most) {
  recorder().list(next_number(), most);
  return last_number_;
}

}  // namespace gaitway::api
