// Orders of the twin, and their answers.
#include "twin_services.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "client_message.hpp"
#include "simulator_answers.hpp"

namespace gaitway::api {

using nlohmann::json;

namespace {

constexpr std::size_t kNumbers = 3;                      // of a walk, and of a goal
constexpr double kShortest_s = 0.5, kLongest_s = 599.0;  // of a walk
constexpr std::size_t kMostBytes = 3000;                 // of an order's texts together
constexpr std::size_t kMostSettings = 32;

void require_three(const char* field, const std::vector<double>& numbers, const char* meaning) {
  if (!numbers.empty() && numbers.size() != kNumbers) {
    throw Refused(std::string(field) + " has " + std::to_string(numbers.size()) +
                  " numbers, but must be empty or have 3: " + meaning);
  }
}

void require_sendable(const ros::SendToRobot::Request& asked) {
  require_three("walk", asked.walk, "m/s ahead, m/s to the left, rad/s");
  require_three("goal", asked.goal, "x [m], y [m], yaw [rad]");
  const int tasks =
      (asked.walk.empty() ? 0 : 1) + (asked.motion.empty() ? 0 : 1) + (asked.goal.empty() ? 0 : 1);
  if (tasks > 1) throw Refused("walk, motion and goal: one of them is sent at a time");
  if (tasks == 0 && asked.settings.empty()) {
    throw Refused("there is nothing to send: give walk, motion, goal or settings");
  }
  if (!(asked.duration == 0.0 || (asked.duration >= kShortest_s && asked.duration <= kLongest_s))) {
    throw Refused("duration is " + shown_json(json(asked.duration)) +
                  ", but must be from 0.5 to 599 s, or 0: 10");
  }
  std::size_t bytes = asked.motion.size() + asked.reason.size();
  for (const std::string& setting : asked.settings) bytes += setting.size();
  if (asked.settings.size() > kMostSettings || bytes > kMostBytes) {
    throw Refused("settings, motion and reason are too long: " + std::to_string(bytes) +
                  " bytes, but must be at most " + std::to_string(kMostBytes) + ", and 32 settings");
  }
}

}  // namespace

void TwinServices::take(const std::string& answer) {
  news_ = twin_state_of(answer);
}

void TwinServices::give(const SimulationCall& call, const json& order) {
  orders_.ask(call, order, SimulationOrders::kPatience_ns, [this, call](const OrderResult& result) {
    orders_.reply(call, ros::Trigger::Response{result.done, result.done ? "" : result.text});
  });
}

void TwinServices::follow(const SimulationCall& call, const ros::SetBool::Request& asked) {
  give(call, {{"order", "twin_follow"}, {"follow", asked.data}});
}

void TwinServices::send(const SimulationCall& call, const ros::SendToRobot::Request& asked) {
  require_sendable(asked);
  // Whoever is told that it was not done in time must be able to rely on that.
  give(call, {{"order", "twin_send"},
              {"until_ns", call.began_ns + SimulationOrders::kPatience_ns},
              {"walk", asked.walk},
              {"duration_s", asked.duration},
              {"motion", asked.motion},
              {"goal", asked.goal},
              {"settings", asked.settings},
              {"reason", asked.reason}});
}

void TwinServices::stop(const SimulationCall& call, const ros::Trigger::Request&) {
  give(call, {{"order", "twin_stop"}});
}

void TwinServices::reconnect(const SimulationCall& call, const ros::Trigger::Request&) {
  give(call, {{"order", "twin_reconnect"}});
}

void TwinServices::tell_picture(const SimulationCall& call, const ros::GetPicture::Request& asked) {
  orders_.ask(call, {{"order", "twin_picture"}, {"from", asked.first}}, SimulationOrders::kPatience_ns,
              [this, call](const OrderResult& result) {
                ros::GetPicture::Response response;
                response.success = result.done;
                if (result.done) {
                  const auto part = read_answer<PictureAnswer>(result.text);
                  response.total = part.total;
                  response.data = part.data;
                } else {
                  response.message = result.text;
                }
                orders_.reply(call, response);
              });
}

}  // namespace gaitway::api
