// Has the simulated robot do what a real one is told: as a client of its API, as anybody could be.
#pragma once

#include <array>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tools/ctl/api_client.hpp"
#include "tools/twin/robot_news.hpp"

namespace gaitway::tools {

// What the simulated robot is to be told, in order.
struct FollowOrder {
  std::string service;               // empty: a velocity
  std::string argument;              // JSON
  std::array<double, 3> velocity{};  // m/s ahead, m/s to the left, rad/s; all 0: stand
};

// From what is told of the real robot to orders: what it began, left or was stopped in since the last look.
// What it did already at the first look counts as begun then.
class FollowRules {
 public:
  [[nodiscard]] std::vector<FollowOrder> look(const RobotNews& news);

 private:
  void look_at_motion(const RobotNews& news, std::vector<FollowOrder>& orders);
  void look_at_way(const RobotNews& news, std::vector<FollowOrder>& orders);

  RobotNews seen_;
};

class Follower {
 public:
  // Under which it has the command of the simulated robot.
  static constexpr const char* kName = "the robot there";

  // `address`: of the simulated robot's API.
  explicit Follower(const ApiAddress& address);
  // Waits for the answer of an order that has been given, 3 s at most.
  ~Follower();
  Follower(const Follower&) = delete;
  Follower& operator=(const Follower&) = delete;

  // `follows`: false gives the command back. Whoever begins to follow forgets why it ended before.
  void set(bool follows);
  // The simulated robot is to walk there (x m, y m, yaw rad) while it follows.
  void join(const std::array<double, 3>& place);
  // `keeps_pace`: the simulation runs as fast as real time; otherwise the simulated robot is told nothing,
  // and gives up what it was told.
  void hear(const RobotNews& news, bool keeps_pace);

  struct Status {
    bool follows = false;
    std::string text;  // why it ended by itself, or does not come about
  };
  [[nodiscard]] Status status() const;

 private:
  class Refused;

  void run();
  bool follow_while_well();
  void follow();
  void note(bool follows, std::string text);
  [[nodiscard]] bool goes_on() const;
  [[nodiscard]] RobotNews heard() const;
  void walk_there(ApiClient& client);
  void carry_out(ApiClient& client, const FollowOrder& order);
  static void require_obeyed(ApiClient& client);

  ApiAddress address_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  RobotNews news_;
  Status status_;
  std::optional<std::array<double, 3>> first_to_;
  bool keeps_pace_ = true, ending_ = false;
  std::thread thread_;  // the last: it uses the others
};

}  // namespace gaitway::tools
