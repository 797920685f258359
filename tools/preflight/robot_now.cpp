// One message of each topic.
#include "tools/preflight/robot_now.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/urdf/description_text.hpp"
#include "tools/twin/compatibility.hpp"

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

json call(ApiClient& client, const char* service, const json& arguments) {
  json values;
  const ApiClient::ServiceAnswer answer = client.call(service, arguments, values);
  if (answer.result && values.value("success", false)) return values;
  throw ApiError(
      fmt::format("{}: {}", service, answer.result ? values.value("message", "") : answer.problem));
}

std::vector<RobotParameter> parameters_of(ApiClient& client) {
  std::vector<RobotParameter> parameters;
  const json list = call(client, "/plugins/list", json::object());
  for (const json& plugin : list.at("plugins")) {
    const auto name = plugin.at("name").get<std::string>();
    const json told = call(client, "/plugins/get_parameters", {{"plugin", name}});
    for (std::size_t i = 0; i < told.at("names").size(); ++i) {
      // Those that cannot change are the configuration's.
      if (!told.at("live").at(i).get<bool>()) continue;
      parameters.push_back(
          {name, told.at("names").at(i).get<std::string>(), told.at("values").at(i).get<std::string>()});
    }
  }
  return parameters;
}

void require_same_robot(ApiClient& client, const json& description, const urdf::RobotModel& robot) {
  std::string why = release_difference(client.server(), GAITWAY_VERSION);
  if (why.empty()) {
    why = description_difference(description.at("data").get<std::string>(),
                                 urdf::description_text(robot.directory / "robot.urdf"));
  }
  if (!why.empty()) throw ApiError(why);
}

}  // namespace

RobotNow ask_where(ApiClient& client, const urdf::RobotModel& robot) {
  for (const char* topic :
       {"/robot_description", "/joint_states", "/robot_state", "/odom", "/walk_to/state"}) {
    client.subscribe(topic);
  }
  RobotNow now;
  bool is_described = false;
  // The way's state comes once the robot has a map; nobody waits for it once the others are there twice.
  for (int joint_states = 0; joint_states < 20 && !(is_described && joint_states > 0 && !now.state.empty() &&
                                                    now.base_m && now.place);) {
    const auto message = client.next_message();
    if (!message) throw NoAnswer("the robot has not told where its joints are");
    try {
      const auto topic = message->at("topic").get<std::string>();
      const json& told = message->at("msg");
      if (topic == "/robot_description") {
        require_same_robot(client, told, robot);
        is_described = true;
      } else if (topic == "/joint_states") {
        now.joint_rad = posture_from(told, robot);
        ++joint_states;
      } else if (topic == "/robot_state") {
        now.state = told.at("state").get<std::string>();
      } else if (topic == "/odom") {
        const json& position = told.at("pose").at("pose").at("position");
        now.base_m = std::array{position.at("x").get<double>(), position.at("y").get<double>()};
      } else if (topic == "/walk_to/state") {
        now.place = told.at("pose").get<std::array<double, 3>>();
      }
    } catch (const json::exception& error) {
      throw ApiError(
          fmt::format("the robot's message is not understood ({}): is it of another release?", error.what()));
    }
  }
  if (!is_described) throw NoAnswer("the robot has not told what it is (/robot_description)");
  return now;
}

RobotNow ask_state(ApiClient& client, const urdf::RobotModel& robot) {
  std::vector<RobotParameter> parameters;
  try {
    parameters = parameters_of(client);
  } catch (const json::exception& error) {
    throw ApiError(fmt::format("the robot's parameters are not understood ({}): is it of another release?",
                               error.what()));
  }
  RobotNow now = ask_where(client, robot);  // the last, since that changes more quickly
  now.parameters = std::move(parameters);
  return now;
}

std::string change_between(const RobotNow& then, const RobotNow& now, const urdf::RobotModel& robot) {
  constexpr double kMoved_m = 0.03, kBent_rad = 0.05;
  if (now.state != "stands") {
    return fmt::format("the robot {} and must stand", input::terminal_text(now.state));
  }
  // By its odometry, which goes on all the time: its place in the map is told when its navigation has a new
  // one.
  if (then.base_m && now.base_m) {
    const double moved_m =
        std::hypot((*now.base_m)[0] - (*then.base_m)[0], (*now.base_m)[1] - (*then.base_m)[1]);
    if (moved_m > kMoved_m) {
      return fmt::format("the robot has moved by {:.0f} mm since it was tried", moved_m * 1e3);
    }
  }
  for (std::size_t i = 0; i < now.joint_rad.size(); ++i) {
    const double bent_rad = std::abs(now.joint_rad[i] - then.joint_rad[i]);
    if (bent_rad > kBent_rad) {
      return fmt::format("{} has moved by {:.1f} deg since it was tried", robot.joints[i].name,
                         bent_rad / facts::kRadPerDegree);
    }
  }
  for (const RobotParameter& one : now.parameters) {
    if (std::ranges::find(then.parameters, one) != then.parameters.end()) continue;
    return fmt::format("{}.{} is {} now, and was another when it was tried", input::terminal_text(one.plugin),
                       input::terminal_text(one.name), input::terminal_text(one.value));
  }
  return {};
}

}  // namespace gaitway::tools
