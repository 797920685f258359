// Requests as the topics' types have them.
#include "gaitway/api/link_robot_port.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <ctime>
#include <stdexcept>

#include "gaitway/api/recorder.hpp"
#include "gaitway/api/robot_activity.hpp"
#include "gaitway/api/state_messages.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/mails.hpp"

namespace gaitway::api {
namespace {

using contract::OrderKind;
using Kind = msgclient::UserCommandKind;

static_assert(contract::row(OrderKind::walk).validity_ns == kVelocityValidity_ns);
static_assert(contract::row(OrderKind::motion).validity_ns == kOrderValidity_ns);
static_assert(contract::row(OrderKind::way).validity_ns == kOrderValidity_ns);
static_assert(contract::row(OrderKind::head).validity_ns == kOrderValidity_ns);
static_assert(contract::row(OrderKind::command).validity_ns == kOrderValidity_ns);
static_assert(contract::row(OrderKind::behaviour).validity_ns == kOrderValidity_ns);
static_assert(static_cast<std::uint32_t>(LookMode::hold) == head_command::mode::hold);
static_assert(static_cast<std::uint32_t>(MissionVerb::change) == behaviour_request::verb::change);
static_assert(contract::row(OrderKind::user_command).validity_ns == kOrderValidity_ns);

constexpr std::int64_t kControllerSilence_ns = facts::kSecond_ns;  // of the message controller

template <std::size_t size>
bool copy_text(std::string_view text, std::uint8_t (&field)[size]) noexcept {
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

LinkRobotPort::LinkRobotPort(ModuleLink& link, const urdf::RobotModel& robot, Recorder* recorder)
    : link_(link),
      recorder_(recorder),
      client_(link.topics("sessions")),
      statistics_(client_.read<PluginStatistics>("plugin_statistics")),
      network_(client_.read<NetworkState>("network_state")),
      motion_states_(client_.read<MotionState>("motion_state")),
      estimates_(client_.read<Estimate>("estimate")),
      planned_(client_.read<PlannedState>("planned_state")) {
  for (const urdf::Joint& joint : robot.joints) {
    joints_.push_back({joint.name, joint.lower_rad, joint.upper_rad});
  }
}

void LinkRobotPort::observe(std::int64_t now_ns) noexcept {
  now_ns_ = now_ns;
  const std::int64_t beat_ns = client_.heartbeat_ns();
  if (beat_ns != heartbeat_ns_) {
    heartbeat_ns_ = beat_ns;
    heard_ns_ = now_ns;
  }
  connected_ = link_.open() && heartbeat_ns_ != 0 && now_ns - heard_ns_ < kControllerSilence_ns;
}

std::int64_t LinkRobotPort::now_ns() const {
  return client_.heartbeat_ns();
}

std::optional<std::uint32_t> LinkRobotPort::walk(const Velocity& velocity, std::int64_t holds_ns,
                                                 std::int64_t age_ns) {
  WalkCommand request{};
  request.velocity[0] = velocity.forward_m_per_s;
  request.velocity[1] = velocity.left_m_per_s;
  request.turn_rate = velocity.turn_rad_per_s;
  // A velocity of zero is what clients mean by standing.
  request.walk = request.velocity[0] != 0.0 || request.velocity[1] != 0.0 || request.turn_rate != 0.0 ? 1 : 0;
  request.valid_until_ns = holds_ns;
  return link_.order(OrderKind::walk, request, age_ns, now_ns_);
}

void LinkRobotPort::stand() {
  static_cast<void>(link_.order(OrderKind::walk, WalkCommand{}, 0, now_ns_));
}

std::optional<std::uint32_t> LinkRobotPort::stop() {
  return link_.stop(link::StopKind::stop);
}

std::optional<std::uint32_t> LinkRobotPort::emergency_stop(bool soft) {
  return link_.stop(soft ? link::StopKind::emergency_soft : link::StopKind::emergency_hold);
}

std::optional<std::uint32_t> LinkRobotPort::release(std::int64_t age_ns) {
  return link_.order(OrderKind::user_command, command_of(Kind::release), age_ns, now_ns_);
}

bool LinkRobotPort::emergency_stopped() const {
  NetworkState state;
  return network_.read(state) && state.mode == network_state::mode::emergency_stop;
}

std::string_view LinkRobotPort::activity() const {
  NetworkState network;
  Estimate estimate;
  PlannedState planned;
  MotionState motion;
  return word_of(activity_of({.network = connected_ && network_.read(network) ? &network : nullptr,
                              .estimate = estimates_.read(estimate) ? &estimate : nullptr,
                              .planned = planned_.read(planned) ? &planned : nullptr,
                              .motion = motion_states_.read(motion) ? &motion : nullptr}));
}

std::optional<std::uint32_t> LinkRobotPort::move_joint(int joint, double position_rad, double duration_s,
                                                       std::int64_t age_ns) {
  constexpr double kLongest_slots = 255.0;
  const double slots = std::clamp(std::ceil(duration_s * 1e9 / facts::kSlot_ns), 1.0, kLongest_slots);
  UserCommand command = command_of(Kind::manual_joint);
  command.joint = static_cast<std::uint32_t>(joint);
  command.duration_slots = static_cast<std::uint32_t>(slots);
  command.position = position_rad;
  return link_.order(OrderKind::user_command, command, age_ns, now_ns_);
}

std::optional<std::uint32_t> LinkRobotPort::play_motion(std::string_view name, std::int64_t age_ns) {
  if (name.empty() && !link_.awaits(OrderKind::motion)) {
    MotionState state{};
    if (!motion_states_.read(state) || state.state == 0) {
      return std::nullopt;  // nothing to leave
    }
  }
  MotionRequest request{};
  if (!copy_text(name, request.name)) {
    return std::nullopt;
  }
  return link_.order(OrderKind::motion, request, age_ns, now_ns_);
}

std::optional<std::uint32_t> LinkRobotPort::walk_to(const Goal& goal, std::int64_t age_ns) {
  WalkToRequest request{};
  request.goal[0] = goal.x_m;
  request.goal[1] = goal.y_m;
  request.goal[2] = goal.yaw_rad;
  return link_.order(OrderKind::way, request, age_ns, now_ns_);
}

std::optional<std::uint32_t> LinkRobotPort::leave_way(std::int64_t age_ns) {
  WalkToRequest request{};
  request.cancel = 1;
  return link_.order(OrderKind::way, request, age_ns, now_ns_);
}

std::optional<std::uint32_t> LinkRobotPort::look(const Look& look, std::int64_t age_ns) {
  HeadCommand request{};
  request.mode = static_cast<std::uint32_t>(look.mode);
  request.direction[0] = look.yaw_rad;
  request.direction[1] = look.pitch_rad;
  request.extent = look.extent_rad;
  request.period = look.period_s;
  request.point[0] = look.x_m;
  request.point[1] = look.y_m;
  request.point[2] = look.z_m;
  request.speed = look.speed_rad_per_s;
  return link_.order(OrderKind::head, request, age_ns, now_ns_);
}

std::optional<std::uint32_t> LinkRobotPort::take_command(std::int64_t age_ns) {
  CommandRequest request{};
  request.verb = command_request::verb::take;
  return link_.order(OrderKind::command, request, age_ns, now_ns_);
}

std::optional<std::uint32_t> LinkRobotPort::let_command_go(std::int64_t age_ns) {
  CommandRequest request{};
  request.verb = command_request::verb::let_go;
  return link_.order(OrderKind::command, request, age_ns, now_ns_);
}

std::optional<std::uint32_t> LinkRobotPort::mission(MissionVerb verb, std::string_view mission,
                                                    std::int64_t age_ns) {
  BehaviourRequest request{};
  request.verb = static_cast<std::uint32_t>(verb);
  return copy_text(mission, request.mission)
             ? std::optional(link_.order(OrderKind::behaviour, request, age_ns, now_ns_))
             : std::nullopt;
}

std::optional<std::uint32_t> LinkRobotPort::order(const PluginOrder& order) {
  PluginRequest request{};
  request.verb = static_cast<std::uint32_t>(order.verb);
  request.index = order.index;
  const bool fits = copy_text(order.plugin, request.plugin) && copy_text(order.library, request.library) &&
                    copy_text(order.parameter, request.parameter) && copy_text(order.value, request.value);
  return fits ? std::optional(link_.order(OrderKind::plugin_request, request, 0, now_ns_)) : std::nullopt;
}

std::optional<OrderResult> LinkRobotPort::take_result() {
  if (auto recording = recorder_ == nullptr ? std::nullopt : recorder_->take_result()) {
    return recording;
  }
  return link_.take_result(now_ns_);
}

std::vector<PluginStatus> LinkRobotPort::plugins() const {
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

Recorder& LinkRobotPort::recorder() const {
  if (recorder_ == nullptr) {
    throw std::runtime_error(
        "this module records nothing: it was started without a folder for recordings (--recordings)");
  }
  return *recorder_;
}

std::uint32_t LinkRobotPort::start_recording(std::string_view name) {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), "%Y%m%dT%H%M%SZ", &utc);
  const std::uint32_t number = link_.next_number();
  recorder().start(number, name.empty() ? std::string(text.data(), size) : std::string(name), now_ns());
  return number;
}

std::uint32_t LinkRobotPort::stop_recording() {
  const std::uint32_t number = link_.next_number();
  recorder().stop(number);
  return number;
}

std::uint32_t LinkRobotPort::list_recordings(std::size_t most) {
  const std::uint32_t number = link_.next_number();
  recorder().list(number, most);
  return number;
}

}  // namespace gaitway::api
