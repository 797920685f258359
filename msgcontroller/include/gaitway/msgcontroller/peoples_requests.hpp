// Makes what people ask for, a walk, a way or a motion, the command, where no plug-in decides what the robot
// does next.
#pragma once

#include <cstdint>
#include <optional>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgcontroller {

// The largest command that is taken from a scenario or a command line.
inline constexpr double kLargestWalkSpeed_m_per_s = 1.0;
inline constexpr double kLargestTurnRate_rad_per_s = 2.0;

// Reads the topic `walk_request`, writes `walk_command`. A request that nobody renews in time ends in a
// stand.
class WalkRequests {
 public:
  // The robot stands until the first request. Throws msgclient::TopicError when somebody writes
  // `walk_command`.
  explicit WalkRequests(msgclient::Client& client);
  // The robot obeys `in_force` already, and requests that were made before do not count.
  WalkRequests(msgclient::Client& client, const WalkCommand& in_force);

  // Once a millisecond. What has been commanded just now, if anything has. No allocation.
  std::optional<WalkCommand> step(std::int64_t now_ns) noexcept;
  // The robot stands; no request is obeyed any more.
  void end(std::int64_t now_ns) noexcept;

 private:
  void command(const WalkCommand& command, std::int64_t now_ns) noexcept;

  msgclient::Reader<WalkCommand> requests_;
  msgclient::Writer<WalkCommand> commands_;
  std::uint64_t seen_ = 0;
  bool ended_ = false;
  WalkCommand current_{};
};

// What becomes of a request that was made before anybody obeyed.
enum class Waiting { obeyed, dropped };

// Reads a topic of requests, writes the one of commands, with the stamp of now.
template <class Request>
class PassedRequests {
 public:
  // Once a millisecond. What has been passed on just now, if anything has. No allocation.
  std::optional<Request> step(std::int64_t now_ns) noexcept;
  // No request is passed on any more.
  void end() noexcept { ended_ = true; }

 protected:
  // Throws msgclient::TopicError when somebody else writes `commands`.
  PassedRequests(msgclient::Client& client, const char* requests, const char* commands, Waiting waiting)
      : requests_(client.read<Request>(requests)),
        commands_(client.write<Request>(commands)),
        seen_(waiting == Waiting::dropped ? requests_.newest_sequence() : 0) {}

 private:
  msgclient::Reader<Request> requests_;
  msgclient::Writer<Request> commands_;
  std::uint64_t seen_ = 0;
  bool ended_ = false;
};

// From `motion_request` to `motion_command`.
class MotionRequests : public PassedRequests<MotionRequest> {
 public:
  explicit MotionRequests(msgclient::Client& client, Waiting waiting = Waiting::obeyed)
      : PassedRequests(client, "motion_request", "motion_command", waiting) {}
};

// From `walk_to_request` to `walk_to_command`.
class WayRequests : public PassedRequests<WalkToRequest> {
 public:
  explicit WayRequests(msgclient::Client& client, Waiting waiting = Waiting::obeyed)
      : PassedRequests(client, "walk_to_request", "walk_to_command", waiting) {}
};

}  // namespace gaitway::msgcontroller
