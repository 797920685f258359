// Newest request in, command out, with the time at which it counts.
#include "gaitway/msgcontroller/motion_requests.hpp"

namespace gaitway::msgcontroller {

MotionRequests::MotionRequests(msgclient::Client& client)
    : requests_(client.read<MotionRequest>("motion_request")),
      commands_(client.write<MotionRequest>("motion_command")) {}

std::optional<MotionRequest> MotionRequests::step(std::int64_t now_ns) noexcept {
  if (ended_ || requests_.newest_sequence() == seen_) return std::nullopt;
  MotionRequest request;
  const auto read = requests_.read(request);
  if (!read) return std::nullopt;
  seen_ = read.sequence;
  request.stamp_ns = now_ns;
  request.name[sizeof request.name - 1] = 0;  // another process wrote it
  commands_.publish(request, now_ns);
  return request;
}

}  // namespace gaitway::msgcontroller
