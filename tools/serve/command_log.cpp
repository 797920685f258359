// Events in, YAML out.
#include "tools/serve/command_log.hpp"

#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "gaitway/msgclient/mails.hpp"

namespace gaitway::tools {
namespace {

using Kind = msgclient::UserCommandKind;

double seconds_of(std::int64_t time_ns) noexcept {
  return static_cast<double>(time_ns) * 1e-9;
}

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

struct Yaml {
  const urdf::RobotModel& robot;

  std::string operator()(const simulator::WalkEvent& walk) const {
    return walk.walk ? fmt::format("walk: [{}, {}, {}]", walk.velocity_m_per_s.x(), walk.velocity_m_per_s.y(),
                                   walk.turn_rate_rad_per_s)
                     : "stand: true";
  }
  std::string operator()(const simulator::MotionEvent& motion) const {
    return motion.name.empty() ? "leave_motion: true" : "motion: " + quoted(motion.name);
  }
  std::string operator()(const simulator::WalkToEvent& way) const {
    return way.goal ? fmt::format("walk_to: {{x_m: {}, y_m: {}, yaw_rad: {}}}", (*way.goal)[0],
                                  (*way.goal)[1], (*way.goal)[2])
                    : "leave_way: true";
  }
  std::string operator()(const simulator::StopEvent&) const { return "stop: true"; }
  std::string operator()(const simulator::EmergencyStopEvent& stop) const {
    return fmt::format("emergency_stop: {}", stop.soft ? "soft" : "hold");
  }
  std::string operator()(const simulator::ReleaseEvent&) const { return "release: true"; }
  std::string operator()(const simulator::ManualJointEvent& move) const {
    return fmt::format("move_joint: {{joint: {}, position_rad: {}, duration_slots: {}}}",
                       robot.joints[static_cast<std::size_t>(move.joint)].name, move.position_rad,
                       move.duration_slots);
  }
  std::string operator()(const simulator::PushEvent& push) const {
    return fmt::format("push: {{body: {}, direction: [{}, {}, {}], impulse_Ns: {}, duration_s: {}}}",
                       quoted(push.body), push.direction.x(), push.direction.y(), push.direction.z(),
                       push.impulse_Ns, push.duration_s);
  }
  template <class Other>
  std::string operator()(const Other&) const {
    return {};  // nobody asks for faults
  }
};

std::string world_lines(const std::optional<world::World>& world) {
  if (!world) return {};
  std::string text = "world: " + quoted(std::filesystem::absolute(world->file).string()) + "\n";
  if (world->random_seed) text += fmt::format("world_seed: {}\n", *world->random_seed);
  return text;
}

}  // namespace

CommandLog::CommandLog(simulator::Cosimulation& run)
    : run_(run),
      answers_(run.client().read_stream<UserCommandAnswer>("user_command_answer")),
      stops_(run.client().read<StopRequest>("stop_answer")) {}

void CommandLog::on_walk_request(const WalkCommand& command, std::int64_t now_ns) {
  const simulator::WalkEvent walk{.velocity_m_per_s = {command.velocity[0], command.velocity[1]},
                                  .turn_rate_rad_per_s = command.turn_rate,
                                  .walk = command.walk != 0};
  events_.push_back({.at_s = seconds_of(now_ns), .action = walk});
}

void CommandLog::on_motion_request(const MotionRequest& request, std::int64_t now_ns) {
  const auto* const name = reinterpret_cast<const char*>(request.name);
  events_.push_back({.at_s = seconds_of(now_ns),
                     .action = simulator::MotionEvent{{name, strnlen(name, sizeof request.name)}},
                     .asked = *name != 0});
}

void CommandLog::on_way_request(const WalkToRequest& request, std::int64_t now_ns) {
  simulator::WalkToEvent way;
  if (request.cancel == 0) way.goal = std::array{request.goal[0], request.goal[1], request.goal[2]};
  events_.push_back({.at_s = seconds_of(now_ns), .action = way});
}

void CommandLog::on_end(std::int64_t now_ns) {
  events_.push_back({.at_s = seconds_of(now_ns), .action = simulator::WalkEvent{.walk = false}});
  events_.push_back({.at_s = seconds_of(now_ns), .action = simulator::StopEvent{}});
}

void CommandLog::on_millisecond(std::int64_t began_ns) {
  UserCommandAnswer answer;
  while (answers_.read(answer)) {
    if (static_cast<msgclient::Reason>(answer.reason) != msgclient::Reason::none) {
      continue;
    }
    simulator::ScenarioEvent event{.at_s = seconds_of(began_ns), .action = {}, .asked = true};
    switch (static_cast<Kind>(answer.command)) {
      case Kind::stop:
        event.action = simulator::StopEvent{};
        break;
      case Kind::emergency_stop_hold:
      case Kind::emergency_stop_soft:
        event.action =
            simulator::EmergencyStopEvent{static_cast<Kind>(answer.command) == Kind::emergency_stop_soft};
        break;
      case Kind::manual_joint:
        event.action = simulator::ManualJointEvent{static_cast<int>(answer.joint), answer.position,
                                                   static_cast<int>(answer.duration_slots)};
        break;
      case Kind::release:
        event.action = simulator::ReleaseEvent{};
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
    events_.push_back(
        {.at_s = seconds_of(began_ns), .action = simulator::EmergencyStopEvent{soft}, .asked = true});
  }
  if (obeyed.stops != stops_logged_.stops) {
    events_.push_back({.at_s = seconds_of(began_ns), .action = simulator::StopEvent{}, .asked = true});
  }
  stops_logged_ = obeyed;
}

std::string CommandLog::scenario(double seconds) const {
  std::string text = fmt::format(
      "# What was asked of the robot. With the same robot, seed and plug-ins, `gaitway run --scenario` of "
      "this file "
      "gives the same digest.\nseconds: {}\n{}events:{}\n",
      seconds, world_lines(run_.plant().world()), events_.empty() ? " []" : "");
  for (const simulator::ScenarioEvent& event : events_) {
    text += fmt::format("  - {{at_s: {}, {}{}}}\n", event.at_s, event.asked ? "asked: true, " : "",
                        std::visit(Yaml{run_.robot()}, event.action));
  }
  return text;
}

}  // namespace gaitway::tools
