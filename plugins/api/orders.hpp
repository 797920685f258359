// Orders that the robot has been given and has not answered yet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>

#include "gaitway/api/robot_port.hpp"

namespace gaitway::api {

class Orders {
 public:
  // One client may wait for so many answers at once.
  static constexpr std::size_t kMostOfOneClient = 32;
  // `result`: null when none has come in time.
  using Finish = std::function<void(const OrderResult* result)>;

  explicit Orders(RobotPort& robot) noexcept : robot_(robot) {}

  // Throws CommandDenied when the client waits for too many answers already; before it gives another order.
  void require_room(std::uint64_t client) const;
  void wait(std::uint32_t number, std::uint64_t client, std::int64_t ends_ns, Finish finish);
  // Finishes what the robot has told of, and what has waited for too long.
  void step(std::int64_t now_ns);
  // The client is gone: its orders are finished without a word.
  void forget(std::uint64_t client);

 private:
  struct Waiting {
    std::uint64_t client = 0;
    std::int64_t ends_ns = 0;
    Finish finish;
  };
  RobotPort& robot_;
  std::unordered_map<std::uint32_t, Waiting> waiting_;
};

}  // namespace gaitway::api
