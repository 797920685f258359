// Those who have told the robot to stand, and want to know when it does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/api/robot_port.hpp"
#include "robot_commands.hpp"
#include "service_call.hpp"

namespace gaitway::api {

class StandWaits {
 public:
  // One client may wait so often at once.
  static constexpr std::size_t kMostOfOneClient = 8;
  // What is ordered shows in what the robot does after so much of its time, at the latest: the batches that
  // are on their way to it come first.
  static constexpr std::int64_t kShows_ns = 500'000'000;

  enum class Outcome : std::uint8_t {
    stands,
    prevented,  // it will not
    late        // it does not stand yet, and the caller waits no more
  };
  // `text`: for people.
  using Finish = std::function<void(const ServiceCall& call, Outcome outcome, const std::string& text)>;

  StandWaits(const RobotPort& robot, const RobotCommands& commands, Finish finish);

  // Throws CommandDenied when the client waits too often already; before it gives the order.
  void require_room(std::uint64_t client) const;
  // After the order.
  void wait(const ServiceCall& call, std::int64_t now_ns, std::int64_t most_ns);
  void step(std::int64_t now_ns);
  // The link to the robot was lost, or is there again.
  void robot_lost();
  // The client is gone.
  void forget(std::uint64_t client);

 private:
  struct Waiting {
    ServiceCall call;
    std::int64_t began_ns = 0, ends_ns = 0;
    std::uint64_t stops = 0;  // that there had been when it began
  };
  struct Answer {
    Outcome outcome;
    std::string text;
  };
  [[nodiscard]] std::optional<Answer> answer(const Waiting& waiting, std::int64_t now_ns) const;
  [[nodiscard]] bool stands() const;

  const RobotPort& robot_;
  const RobotCommands& commands_;
  Finish finish_;
  std::vector<Waiting> waiting_;
};

}  // namespace gaitway::api
