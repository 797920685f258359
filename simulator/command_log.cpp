// Events in, YAML out.
#include "gaitway/simulator/command_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "gaitway/msgclient/mails.hpp"

namespace gaitway::simulator {
namespace {

using Kind = msgclient::UserCommandKind;

double seconds_of(std::int64_t time_ns) noexcept {
  return static_cast<double>(time_ns) * 1e-9;
}

WalkEvent event_of(const WalkCommand& walk) {
  return {.velocity_m_per_s = {walk.velocity[0], walk.velocity[1]},
          .turn_rate_rad_per_s = walk.turn_rate,
          .walk = walk.walk != 0};
}

WalkToEvent event_of(const WalkToRequest& way) {
  if (way.cancel != 0) return {};
  return {std::array{way.goal[0], way.goal[1], way.goal[2]}};
}

MotionEvent event_of(const MotionRequest& motion) {
  const auto* const name = reinterpret_cast<const char*>(motion.name);
  return {{name, strnlen(name, sizeof motion.name)}};
}

HeadEvent event_of(const HeadCommand& head) {
  return {.mode = static_cast<HeadEvent::Mode>(std::min(head.mode, head_command::mode::hold)),
          .direction_rad = {head.direction[0], head.direction[1]},
          .extent_rad = head.extent,
          .period_s = head.period,
          .point_m = Eigen::Vector3d(head.point[0], head.point[1], head.point[2]),
          .speed_rad_per_s = head.speed};
}

std::string world_lines(const std::optional<world::World>& world) {
  if (!world) return {};
  std::string text =
      fmt::format("world: {}\n", nlohmann::json(std::filesystem::absolute(world->file).string()).dump());
  if (world->random_seed) text += fmt::format("world_seed: {}\n", *world->random_seed);
  return text;
}

}  // namespace

CommandLog::CommandLog(Cosimulation& run)
    : run_(run),
      answers_(run.client().read_stream<UserCommandAnswer>("user_command_answer")),
      stops_(run.client().read<StopRequest>("stop_answer")),
      releases_logged_(run.message_controller().releases_taken()) {
  UserCommandAnswer before;
  while (answers_.read(before)) {
  }
  static_cast<void>(stops_.read(stops_logged_));
}

void CommandLog::on_orders(const msgcontroller::PassedOrders& orders, std::int64_t now_ns) {
  const double at_s = seconds_of(now_ns);
  const bool lets_go = orders.verb == msgcontroller::CommandVerb::let_go;
  if (orders.verb && !lets_go) events_.push_back({.at_s = at_s, .action = CommandEvent{*orders.verb}});
  if (orders.walk) events_.push_back({.at_s = at_s, .action = event_of(*orders.walk)});
  if (orders.way) events_.push_back({.at_s = at_s, .action = event_of(*orders.way)});
  if (orders.motion) {
    const MotionEvent motion = event_of(*orders.motion);
    events_.push_back({.at_s = at_s, .action = motion, .asked = !motion.name.empty()});
  }
  if (orders.head) events_.push_back({.at_s = at_s, .action = event_of(*orders.head)});
  if (lets_go) events_.push_back({.at_s = at_s, .action = CommandEvent{*orders.verb}});
}

void CommandLog::on_end(std::int64_t now_ns) {
  events_.push_back({.at_s = seconds_of(now_ns), .action = WalkEvent{.walk = false}});
  events_.push_back({.at_s = seconds_of(now_ns), .action = StopEvent{}});
}

void CommandLog::on_millisecond(std::int64_t began_ns) {
  // In the millisecond in which it begins: its answer comes slots later, when every joint has confirmed it.
  const std::uint64_t releases = run_.message_controller().releases_taken();
  for (; releases_logged_ < releases; ++releases_logged_) {
    events_.push_back({.at_s = seconds_of(began_ns), .action = ReleaseEvent{}, .asked = true});
  }
  UserCommandAnswer answer;
  while (answers_.read(answer)) {
    if (static_cast<msgclient::Reason>(answer.reason) != msgclient::Reason::none ||
        static_cast<Kind>(answer.command) == Kind::release) {
      continue;
    }
    ScenarioEvent event{.at_s = seconds_of(began_ns), .action = {}, .asked = true};
    switch (static_cast<Kind>(answer.command)) {
      case Kind::stop:
        event.action = StopEvent{};
        break;
      case Kind::emergency_stop_hold:
      case Kind::emergency_stop_soft:
        event.action = EmergencyStopEvent{static_cast<Kind>(answer.command) == Kind::emergency_stop_soft};
        break;
      case Kind::manual_joint:
        event.action = ManualJointEvent{static_cast<int>(answer.joint), answer.position,
                                        static_cast<int>(answer.duration_slots)};
        break;
      case Kind::release:
        break;
    }
    events_.push_back(event);
  }
  // In the order in which the message controller obeys them.
  StopRequest obeyed;
  if (!stops_.read(obeyed)) {
    return;
  }
  const bool soft = obeyed.softs != stops_logged_.softs;
  if (soft || obeyed.holds != stops_logged_.holds) {
    events_.push_back({.at_s = seconds_of(began_ns), .action = EmergencyStopEvent{soft}, .asked = true});
  }
  if (obeyed.stops != stops_logged_.stops) {
    events_.push_back({.at_s = seconds_of(began_ns), .action = StopEvent{}, .asked = true});
  }
  stops_logged_ = obeyed;
}

std::string CommandLog::scenario(double seconds) const {
  return scenario_text(seconds, run_.plant().world(), events_, run_.robot());
}

std::string scenario_text(double seconds, const std::optional<world::World>& world,
                          std::span<const ScenarioEvent> events, const urdf::RobotModel& robot) {
  std::string text = fmt::format(
      "# What was asked of the robot. With the same robot, seed and plug-ins, `gaitway run --scenario` of "
      "this file "
      "gives the same digest.\nseconds: {}\nto_the_end: true\n{}events:{}\n",
      seconds, world_lines(world), events.empty() ? " []" : "");
  for (const ScenarioEvent& event : events) {
    text += fmt::format("  - {{at_s: {}, {}{}}}\n", event.at_s, event.asked ? "asked: true, " : "",
                        action_text(event, robot));
  }
  return text;
}

}  // namespace gaitway::simulator
