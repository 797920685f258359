// Orders whose answers clients wait for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <utility>

#include "gaitway/api/robot_port.hpp"

namespace gaitway::api {

// Orders that somebody (the robot, or its simulation) has been given and has not answered yet.
class Orders {
 public:
  // One client may wait for so many answers at once.
  static constexpr std::size_t kMostOfOneClient = 32;
  // `result`: null when none has come in time.
  using Finish = std::function<void(const OrderResult* result)>;

  // The next that was answered, if any.
  using TakeResult = std::function<std::optional<OrderResult>()>;

  explicit Orders(TakeResult take_result) : take_result_(std::move(take_result)) {}

  // Throws CommandDenied when the client waits for too many answers already; before it gives another order.
  void require_room(std::uint64_t client) const;
  // `counts`: among those of which one client may wait for so many.
  void wait(std::uint32_t number, std::uint64_t client, std::int64_t ends_ns, Finish finish,
            bool counts = true);
  // Finishes what the robot has told of, and what has waited for too long.
  void step(std::int64_t now_ns);
  // The client is gone: its orders are finished without a word.
  void forget(std::uint64_t client);

 private:
  struct Waiting {
    std::uint64_t client = 0;
    std::int64_t ends_ns = 0;
    Finish finish;
    bool counts = true;
  };
  TakeResult take_result_;
  std::unordered_map<std::uint32_t, Waiting> waiting_;
};

}  // namespace gaitway::api
