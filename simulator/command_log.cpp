// Events in, YAML out.
#include "gaitway/simulator/command_log.hpp"

#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "gaitway/msgclient/mails.hpp"

namespace gaitway::simulator {
namespace {

using Kind = msgclient::UserCommandKind;

double seconds_of(std::int64_t time_ns) noexcept {
  return static_cast<double>(time_ns) * 1e-9;
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

void CommandLog::on_walk_request(const WalkCommand& command, std::int64_t now_ns) {
  const WalkEvent walk{.velocity_m_per_s = {command.velocity[0], command.velocity[1]},
                       .turn_rate_rad_per_s = command.turn_rate,
                       .walk = command.walk != 0};
  events_.push_back({.at_s = seconds_of(now_ns), .action = walk});
}

void CommandLog::on_motion_request(const MotionRequest& request, std::int64_t now_ns) {
  const auto* const name = reinterpret_cast<const char*>(request.name);
  events_.push_back({.at_s = seconds_of(now_ns),
                     .action = MotionEvent{{name, strnlen(name, sizeof request.name)}},
                     .asked = *name != 0});
}

void CommandLog::on_way_request(const WalkToRequest& request, std::int64_t now_ns) {
  WalkToEvent way;
  if (request.cancel == 0) way.goal = std::array{request.goal[0], request.goal[1], request.goal[2]};
  events_.push_back({.at_s = seconds_of(now_ns), .action = way});
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
