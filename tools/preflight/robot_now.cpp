// One message of each topic.
#include "tools/preflight/robot_now.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "gaitway/input/text.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;

std::vector<double> posture_from(const json& message, const urdf::RobotModel& robot) {
  const json& names = message.at("name");
  const json& positions = message.at("position");
  std::map<std::string, double> told;
  for (std::size_t i = 0; i < std::min(names.size(), positions.size()); ++i) {
    told.emplace(names[i].get<std::string>(),
                 positions[i].is_number() ? positions[i].get<double>() : std::nan(""));
  }
  std::vector<double> posture;
  for (const urdf::Joint& joint : robot.joints) {
    const auto found = told.find(joint.name);
    if (found == told.end()) {
      throw ApiError(
          fmt::format("/joint_states: the robot there has no joint '{}' of {}: give its own description "
                      "(--robot)",
                      joint.name, robot.name));
    }
    if (!std::isfinite(found->second)) {
      throw ApiError(fmt::format("/joint_states: the position of '{}' is not known there", joint.name));
    }
    // Encoders and calibrations may put a joint a little beyond its stop.
    posture.push_back(std::clamp(found->second, joint.lower_rad, joint.upper_rad));
    told.erase(found);
  }
  if (!told.empty()) {
    throw ApiError(
        fmt::format("/joint_states: the robot there has a joint '{}', which {} has not: give its own "
                    "description (--robot)",
                    input::terminal_text(told.begin()->first), robot.name));
  }
  return posture;
}

}  // namespace

RobotNow ask_where(ApiClient& client, const urdf::RobotModel& robot) {
  for (const char* topic : {"/joint_states", "/robot_state", "/walk_to/state"}) client.subscribe(topic);
  RobotNow now;
  // The way's state comes once the robot has a map; nobody waits for it once the others are there twice.
  for (int joint_states = 0; joint_states < 20 && !(joint_states > 0 && !now.state.empty() && now.place);) {
    const auto message = client.next_message();
    if (!message) throw NoAnswer("the robot has not told where its joints are");
    try {
      const auto topic = message->at("topic").get<std::string>();
      const json& told = message->at("msg");
      if (topic == "/joint_states") {
        now.joint_rad = posture_from(told, robot);
        ++joint_states;
      } else if (topic == "/robot_state") {
        now.state = told.at("state").get<std::string>();
      } else if (topic == "/walk_to/state") {
        now.place = told.at("pose").get<std::array<double, 3>>();
      }
    } catch (const json::exception& error) {
      throw ApiError(
          fmt::format("the robot's message is not understood ({}): is it of another release?", error.what()));
    }
  }
  return now;
}

}  // namespace gaitway::tools
