// Differences between two looks, and a connection on which they are carried out.
#include "tools/twin/follower.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace gaitway::tools {
namespace {

using nlohmann::json;

constexpr double kObeyed_s = 3.0;  // a stand takes a walk's last steps
constexpr double kLook_s = 0.05;
constexpr int kRenewedAfter = 2;  // looks; a velocity holds for half a second
constexpr std::chrono::milliseconds kFollowAgain{500};

bool is_zero(const std::array<double, 3>& velocity) {
  return std::ranges::all_of(velocity, [](double one) { return one == 0.0 || !std::isfinite(one); });
}

bool is_under_way(const std::string& motion_state) {
  return motion_state == "approaching" || motion_state == "playing";
}

FollowOrder service(const char* name, const json& arguments = json::object()) {
  return {.service = name, .argument = arguments.dump(), .velocity = {}};
}

}  // namespace

std::vector<FollowOrder> FollowRules::look(const RobotNews& news) {
  std::vector<FollowOrder> orders;
  if (news.activity != seen_.activity) {
    if (news.activity == "stopped") orders.push_back(service("/emergency_stop", {{"data", false}}));
    if (seen_.activity == "stopped") orders.push_back(service("/release"));
    if (news.activity == "stops") orders.push_back(service("/stop"));
  }
  if (news.walk != seen_.walk) {
    const bool stands = is_zero(news.walk);
    orders.push_back(stands ? service("/stand") : FollowOrder{{}, {}, news.walk});
  }
  look_at_motion(news, orders);
  look_at_way(news, orders);
  seen_ = news;
  return orders;
}

void FollowRules::look_at_motion(const RobotNews& news, std::vector<FollowOrder>& orders) {
  const bool begins =
      is_under_way(news.motion_state) && (!is_under_way(seen_.motion_state) || news.motion != seen_.motion);
  if (begins) orders.push_back(service("/play_motion", {{"motion", news.motion}}));
  const bool ended = news.motions_ended != seen_.motions_ended && seen_.motions_ended != 0;
  if (ended && news.motion_result == "left") orders.push_back(service("/play_motion", {{"motion", ""}}));
}

void FollowRules::look_at_way(const RobotNews& news, std::vector<FollowOrder>& orders) {
  const bool is_idle = news.way_state.empty() || news.way_state == "idle";
  const bool was_idle = seen_.way_state.empty() || seen_.way_state == "idle";
  if (!is_idle && news.goal && (was_idle || news.goal != seen_.goal)) {
    const auto& [x_m, y_m, yaw_rad] = *news.goal;
    orders.push_back(service("/walk_to", {{"x", x_m}, {"y", y_m}, {"yaw", yaw_rad}}));
  }
  if (is_idle && !was_idle && news.way_result == "cancelled") orders.push_back(service("/walk_to/cancel"));
}

// Somebody else has the command, or the robot will not: trying again changes nothing.
class Follower::Refused : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

Follower::Follower(const ApiAddress& address)
    : address_(address.with_timeout(kObeyed_s)), thread_([this] { run(); }) {}

Follower::~Follower() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Follower::set(bool follows) {
  {
    const std::lock_guard lock(mutex_);
    first_to_.reset();
    status_ = {.follows = follows, .text = {}};
  }
  changed_.notify_all();
}

void Follower::join(const std::array<double, 3>& place) {
  const std::lock_guard lock(mutex_);
  first_to_ = place;
}

void Follower::hear(const RobotNews& news, bool keeps_pace) {
  bool is_other_pace = false;
  {
    const std::lock_guard lock(mutex_);
    news_ = news;
    is_other_pace = std::exchange(keeps_pace_, keeps_pace) != keeps_pace;
  }
  if (is_other_pace) changed_.notify_all();
}

Follower::Status Follower::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

bool Follower::goes_on() const {
  const std::lock_guard lock(mutex_);
  return status_.follows && keeps_pace_ && !ending_;
}

void Follower::note(bool follows, std::string text) {
  const std::lock_guard lock(mutex_);
  if (!status_.follows) return;  // somebody has ended it meanwhile
  status_ = {.follows = follows, .text = shortened(std::move(text))};
}

void Follower::run() {
  const auto may_follow = [this] { return ending_ || (status_.follows && keeps_pace_); };
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, may_follow);
    if (ending_) return;
    lock.unlock();
    const bool went_wrong = !follow_while_well();
    lock.lock();
    if (went_wrong) changed_.wait_for(lock, kFollowAgain, [this] { return ending_; });
  }
}

// False: it ended by itself.
bool Follower::follow_while_well() {
  try {
    follow();
    return true;
  } catch (const Refused& refused) {
    note(false, refused.what());
  } catch (const std::exception& error) {  // a link that was lost, an answer that has not come: once more
    note(true, error.what());
  }
  return false;
}

// Until it is to end. The connection's end is the command's: the simulated robot stands.
void Follower::follow() {
  ApiClient client(address_);
  client.advertise("/cmd_vel", "geometry_msgs/msg/Twist");
  FollowRules rules;
  std::array<double, 3> velocity{};
  for (int look = 0; goes_on(); ++look) {
    walk_there(client);
    const std::vector<FollowOrder> orders = rules.look(heard());
    if (!orders.empty()) carry_out(client, service("/command/acquire", {{"name", kName}}));
    for (const FollowOrder& order : orders) {
      velocity = order.velocity;  // every other order ends the walk
      if (!order.service.empty()) carry_out(client, order);
    }
    if (!is_zero(velocity) && (look % kRenewedAfter == 0 || !orders.empty())) {
      client.publish("/cmd_vel", {{"linear", {{"x", velocity[0]}, {"y", velocity[1]}, {"z", 0.0}}},
                                  {"angular", {{"x", 0.0}, {"y", 0.0}, {"z", velocity[2]}}}});
    }
    client.rest(kLook_s);
    require_obeyed(client);
    note(true, "");  // it is well again; not before: what goes wrong each time is told once
  }
}

// What the robot says of a velocity that it does not walk.
void Follower::require_obeyed(ApiClient& client) {
  try {
    client.throw_reported_errors();
  } catch (const ApiError& error) {
    if (tells_of_lateness(error.what())) return;  // the next one may be in time
    throw Refused(error.what());
  }
}

// To where the robot there is, until it has begun to walk there.
void Follower::walk_there(ApiClient& client) {
  std::optional<std::array<double, 3>> place;
  {
    const std::lock_guard lock(mutex_);
    place = first_to_;
  }
  if (!place) return;
  const auto& [x_m, y_m, yaw_rad] = *place;
  carry_out(client, service("/command/acquire", {{"name", kName}}));
  carry_out(client, service("/walk_to", {{"x", x_m}, {"y", y_m}, {"yaw", yaw_rad}}));
  const std::lock_guard lock(mutex_);
  if (first_to_ == place) first_to_.reset();  // not before: what is not answered is tried again
}

RobotNews Follower::heard() const {
  const std::lock_guard lock(mutex_);
  return news_;
}

void Follower::carry_out(ApiClient& client, const FollowOrder& order) {
  json values;
  const ApiClient::ServiceAnswer answer = client.call(order.service, json::parse(order.argument), values);
  if (answer.result && values.value("success", false)) return;
  const std::string why =
      order.service + ": " + (answer.result ? values.value("message", "") : answer.problem);
  if (tells_of_lateness(why) || !answer.result) throw ApiError(why);
  throw Refused(why);
}

}  // namespace gaitway::tools
