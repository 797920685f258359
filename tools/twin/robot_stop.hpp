// Stops a robot over its API, by a connection of its own that nothing else is waited for on: whatever becomes
// of the one that is watched.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {

class RobotStop {
 public:
  explicit RobotStop(const ApiAddress& address);
  // Waits for a stop that was asked for, some seconds at most.
  ~RobotStop();
  RobotStop(const RobotStop&) = delete;
  RobotStop& operator=(const RobotStop&) = delete;

  // At once, whether or not that robot has been let in or is heard of. It is tried for 3 s and not kept for
  // later.
  void stop();

  struct Answer {
    std::uint32_t number = 0;  // of the stops that have been answered or given up
    std::string text;          // why the robot was not stopped; empty: it was
  };
  [[nodiscard]] Answer answer() const;

 private:
  void run();
  [[nodiscard]] std::string try_to_stop() const;

  ApiAddress address_;
  mutable std::mutex mutex_;
  std::condition_variable asked_changed_;
  Answer answer_;
  bool is_asked_ = false, ending_ = false;
  std::thread thread_;  // the last: it uses the others
};

}  // namespace gaitway::tools
