// Passes on people's requests for motions, where no plug-in decides what the robot does next.
#pragma once

#include <cstdint>
#include <optional>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgcontroller {

// Reads the topic `motion_request`, writes `motion_command`.
class MotionRequests {
 public:
  // Throws msgclient::TopicError when somebody writes `motion_command`.
  explicit MotionRequests(msgclient::Client& client);

  // Once a millisecond. What has been passed on just now, if anything has. No allocation.
  std::optional<MotionRequest> step(std::int64_t now_ns) noexcept;
  // No request is passed on any more.
  void end() noexcept { ended_ = true; }

 private:
  msgclient::Reader<MotionRequest> requests_;
  msgclient::Writer<MotionRequest> commands_;
  std::uint64_t seen_ = 0;
  bool ended_ = false;
};

}  // namespace gaitway::msgcontroller
