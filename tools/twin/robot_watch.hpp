// A robot's API, watched by a thread of its own: connected to, and connected to again, for as long as it is
// wanted.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"
#include "tools/ctl/api_client.hpp"
#include "tools/twin/robot_news.hpp"

namespace gaitway::tools {

// Since which instant of this computer's monotonic clock a point is here.
struct ArrivedPoint {
  MeasuredPoint point;
  double arrived_s = 0.0;
};

// This computer's monotonic clock.
[[nodiscard]] double monotonic_s();

class RobotWatch {
 public:
  enum class State {
    connecting,
    connected,
    lost,    // it tries again by itself
    refused  // another robot, another release, no right: it tries again when told to
  };
  struct Status {
    State state = State::connecting;
    std::string text;  // why it is lost or refused
    RobotNews news;    // as last heard
  };

  RobotWatch(const ApiAddress& address, const urdf::RobotModel& robot);
  // Waits for the connection's end, 2 s at most.
  ~RobotWatch();
  RobotWatch(const RobotWatch&) = delete;
  RobotWatch& operator=(const RobotWatch&) = delete;

  [[nodiscard]] Status status() const;
  // What has been measured since the last call, the last 2,000 points at most.
  [[nodiscard]] std::deque<ArrivedPoint> take_points();
  // After it was refused.
  void reconnect();

 private:
  class Refused;

  void run();
  void watch();
  void take(const nlohmann::json& message);
  void set(State state, std::string text);
  // False: it is to end.
  [[nodiscard]] bool pause(State state);
  [[nodiscard]] bool ending() const;

  ApiAddress address_;
  RobotReader reader_;
  std::string description_;  // own
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Status status_;
  std::deque<ArrivedPoint> points_;
  bool ending_ = false, reconnect_ = false;
  bool is_described_ = false;  // on this connection, as here; of the thread alone
  std::thread thread_;         // the last: it uses the others
};

}  // namespace gaitway::tools
