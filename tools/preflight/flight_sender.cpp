// Orders over the robot API, one after the other.
#include "tools/preflight/flight_sender.hpp"

#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>

namespace gaitway::tools {
namespace {

using nlohmann::json;

constexpr double kRenew_s = 0.1;
constexpr int kMostLate = 5;  // a velocity holds for half a second

json call(ApiClient& client, const std::string& service, const json& arguments) {
  json values;
  const ApiClient::ServiceAnswer answer = client.call(service, arguments, values);
  if (!answer.result || !values.value("success", false)) {
    throw ApiError(
        fmt::format("{}: {}", service, answer.result ? values.value("message", "") : answer.problem));
  }
  return values;
}

// Given back with the connection.
class CommandLease {
 public:
  explicit CommandLease(ApiClient& client)
      : client_(client),
        lease_(call(client, "/command/acquire", {{"name", "gaitway preflight"}})
                   .at("lease")
                   .get<std::string>()) {}
  void renew() { call(client_, "/command/keep_alive", {{"lease", lease_}}); }

 private:
  ApiClient& client_;
  std::string lease_;
};

// Whether the last velocity came too late to be walked: the next one may be in time, and until then the one
// before holds. Throws what else the robot had to say.
bool is_late(ApiClient& client) {
  try {
    client.throw_reported_errors();
    return false;
  } catch (const ApiError& error) {
    if (!tells_of_lateness(error.what())) throw;
    return true;
  }
}

void walk(ApiClient& client, CommandLease& command, const RobotTask& task) {
  const auto at = [&task](std::size_t i) { return i < task.walk->size() ? (*task.walk)[i] : 0.0; };
  const json twist{{"linear", {{"x", at(0)}, {"y", at(1)}, {"z", 0.0}}},
                   {"angular", {{"x", 0.0}, {"y", 0.0}, {"z", at(2)}}}};
  client.advertise("/cmd_vel", "geometry_msgs/msg/Twist");
  int late = 0;  // one after the other
  client.repeat(
      [&] {
        client.publish("/cmd_vel", twist);
        command.renew();
        late = is_late(client) ? late + 1 : 0;
        if (late > kMostLate) throw ApiError("/cmd_vel: the connection is too slow: the robot stands");
      },
      kRenew_s, task.walk_seconds);
  call(client, "/stand", json::object());
}

// Keeps the command until a message of the topic says the end by `ended`, which throws if it was a bad one.
void follow(ApiClient& client, CommandLease& command, const std::string& topic,
            const std::function<bool(const json& message)>& ended) {
  using Clock = std::chrono::steady_clock;
  client.subscribe("/joint_states");  // comes often: the command is renewed beside it
  client.subscribe(topic);
  Clock::time_point renewed = Clock::now();
  while (const auto message = client.next_message()) {
    if (Clock::now() - renewed > std::chrono::duration<double>(kRenew_s)) {
      command.renew();
      renewed = Clock::now();
    }
    if (message->value("topic", "") == topic && ended(message->at("msg"))) return;
  }
  throw NoAnswer(topic + ": the robot tells nothing any more");
}

// The robot walks a way by itself, but not without who gave it: so until it has ended.
void walk_to(ApiClient& client, CommandLease& command, const std::array<double, 3>& goal) {
  call(client, "/walk_to", {{"x", goal[0]}, {"y", goal[1]}, {"yaw", goal[2]}});
  follow(client, command, "/walk_to/state", [](const json& state) {
    if (state.at("state") != "idle") return false;
    if (state.at("result") == "arrived") return true;
    throw ApiError(fmt::format("/walk_to: {}: {}", state.at("result").get<std::string>(),
                               state.at("text").get<std::string>()));
  });
}

void play(ApiClient& client, CommandLease& command, const std::string& motion) {
  call(client, "/play_motion", {{"motion", motion}});
  follow(client, command, "/motion_state", [began = false](const json& state) mutable {
    began = began || state.at("state") != "none";
    if (!began || state.at("state") != "none") return false;
    if (state.at("result") == "finished") return true;
    throw ApiError("/play_motion: it was " + state.at("result").get<std::string>());
  });
}

}  // namespace

void send(ApiClient& client, const RobotTask& task) {
  CommandLease command(client);
  for (const ParameterSetting& one : task.settings) {
    call(client, "/plugins/set_parameter",
         {{"plugin", one.plugin}, {"parameter", one.parameter}, {"value", one.value}});
  }
  if (!task.motion.empty()) play(client, command, task.motion);
  if (task.walk) walk(client, command, task);
  if (task.goal) walk_to(client, command, *task.goal);
}

}  // namespace gaitway::tools
