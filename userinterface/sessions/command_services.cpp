// The services of who commands the robot, of its head and of its behaviour.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "client_message.hpp"
#include "service_desk.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;

struct Bound {
  const char* name;
  double value;
  double least, most;
  const char* unit;
};

void require_within(const Bound& bound) {
  if (!(bound.value >= bound.least && bound.value <= bound.most)) {  // so for NaN, too
    throw Refused(std::string(bound.name) + " is " + shown_json(json(bound.value)) + ", but must be from " +
                  shown_json(json(bound.least)) + " to " + shown_json(json(bound.most)) + " " + bound.unit);
  }
}

LookMode mode_of(const std::string& word) {
  constexpr std::array<std::string_view, 5> kModes{"ahead", "direction", "point", "scan", "hold"};
  const auto* const found = std::ranges::find(kModes, word);
  if (found == kModes.end()) {
    throw Refused("mode is " + shown(word) +
                  ", but must be \"ahead\", \"direction\", \"point\", \"scan\" or \"hold\"");
  }
  return static_cast<LookMode>(found - kModes.begin());
}

// Within the limits of HeadCommand; how far the neck goes, whoever plans knows.
Look look_of(const ros::Look::Request& asked) {
  constexpr double kMostAngle_rad = 3.2, kLongest_s = 600.0, kFarthest_m = 1000.0, kFastest_rad_per_s = 100.0;
  const Look look{.mode = mode_of(asked.mode),
                  .yaw_rad = asked.yaw,
                  .pitch_rad = asked.pitch,
                  .extent_rad = asked.extent,
                  .period_s = asked.period,
                  .x_m = asked.x,
                  .y_m = asked.y,
                  .z_m = asked.z,
                  .speed_rad_per_s = asked.speed};
  for (const Bound& bound : {Bound{"yaw", look.yaw_rad, -kMostAngle_rad, kMostAngle_rad, "rad"},
                             Bound{"pitch", look.pitch_rad, -kMostAngle_rad, kMostAngle_rad, "rad"},
                             Bound{"extent", look.extent_rad, 0.0, kMostAngle_rad, "rad"},
                             Bound{"period", look.period_s, 0.0, kLongest_s, "s"},
                             Bound{"x", look.x_m, -kFarthest_m, kFarthest_m, "m"},
                             Bound{"y", look.y_m, -kFarthest_m, kFarthest_m, "m"},
                             Bound{"z", look.z_m, -kFarthest_m, kFarthest_m, "m"},
                             Bound{"speed", look.speed_rad_per_s, 0.0, kFastest_rad_per_s, "rad/s"}}) {
    require_within(bound);
  }
  if (look.mode == LookMode::scan && look.extent_rad == 0.0) {
    throw Refused(
        "extent is 0 rad, but must be above 0 for the mode \"scan\": as far it looks to either side");
  }
  return look;
}

}  // namespace

void ServiceDesk::look(const Caller& caller) {
  const Look look = look_of(request<ros::Look>(caller));
  orders_.require_room(caller.call.client);
  await<ros::Look>(caller, commands_.look(caller.claimant, look, caller.now_ns));
}

void ServiceDesk::take_command(const Caller& caller) {
  static_cast<void>(request<ros::Trigger>(caller));
  orders_.require_room(caller.call.client);
  await<ros::Trigger>(caller, commands_.take_command(caller.claimant, caller.now_ns));
}

void ServiceDesk::let_command_go(const Caller& caller) {
  static_cast<void>(request<ros::Trigger>(caller));
  orders_.require_room(caller.call.client);
  await<ros::Trigger>(caller, commands_.let_command_go(caller.claimant, caller.now_ns));
}

void ServiceDesk::start_mission(const Caller& caller) {
  constexpr std::size_t kMostMissionBytes = 255;
  const auto asked = request<ros::StartMission>(caller);
  require_short("mission", asked.mission, kMostMissionBytes);
  orders_.require_room(caller.call.client);
  await<ros::StartMission>(
      caller, commands_.mission(caller.claimant, MissionVerb::start, asked.mission, caller.now_ns));
}

void ServiceDesk::change_mission(MissionVerb verb, const Caller& caller) {
  static_cast<void>(request<ros::Trigger>(caller));
  orders_.require_room(caller.call.client);
  await<ros::Trigger>(caller, commands_.mission(caller.claimant, verb, "", caller.now_ns));
}

}  // namespace gaitway::api
