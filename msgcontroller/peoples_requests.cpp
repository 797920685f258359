// Newest request in, command out, and a stand when its time is over.
#include "gaitway/msgcontroller/peoples_requests.hpp"

#include <algorithm>
#include <string_view>

namespace gaitway::msgcontroller {
namespace {

WalkCommand stand_at(std::int64_t now_ns) noexcept {
  WalkCommand stand{};
  stand.stamp_ns = now_ns;
  return stand;
}

// Another process wrote it: as far as the type allows, and no further.
bool sensible(const WalkCommand& request) noexcept {
  const auto within = [](std::string_view name, double value) {
    const auto& fields = TopicType<WalkCommand>::fields;
    const auto field = std::ranges::find_if(fields, [name](const auto& one) { return one.name == name; });
    return field != fields.end() && value >= field->lowest && value <= field->highest;
  };
  return within("velocity", request.velocity[0]) && within("velocity", request.velocity[1]) &&
         within("turn_rate", request.turn_rate);
}

// Another process wrote these, too.
void make_sound(MotionRequest& request) noexcept {
  request.name[sizeof request.name - 1] = 0;
}
void make_sound(WalkToRequest&) noexcept {}  // whoever walks there looks at its numbers

}  // namespace

WalkRequests::WalkRequests(msgclient::Client& client)
    : requests_(client.read<WalkCommand>("walk_request")),
      commands_(client.write<WalkCommand>("walk_command")) {
  commands_.publish(current_, 0);
}

WalkRequests::WalkRequests(msgclient::Client& client, const WalkCommand& in_force)
    : requests_(client.read<WalkCommand>("walk_request")),
      commands_(client.write<WalkCommand>("walk_command")),
      seen_(requests_.newest_sequence()),
      current_(in_force) {}

std::optional<WalkCommand> WalkRequests::step(std::int64_t now_ns) noexcept {
  WalkCommand request;
  if (!ended_ && requests_.newest_sequence() != seen_) {
    if (const auto read = requests_.read(request)) {
      seen_ = read.sequence;
      request.stamp_ns = now_ns;
      const bool over = request.valid_until_ns != 0 && now_ns >= request.valid_until_ns;
      if (over || !sensible(request)) {
        request = stand_at(now_ns);
      }
      command(request, now_ns);
      return current_;
    }
  }
  if (current_.valid_until_ns != 0 && now_ns >= current_.valid_until_ns) {
    command(stand_at(now_ns), now_ns);
    return current_;
  }
  return std::nullopt;
}

void WalkRequests::end(std::int64_t now_ns) noexcept {
  ended_ = true;
  command(stand_at(now_ns), now_ns);
}

void WalkRequests::command(const WalkCommand& command, std::int64_t now_ns) noexcept {
  current_ = command;
  commands_.publish(command, now_ns);
}

template <class Request>
std::optional<Request> PassedRequests<Request>::step(std::int64_t now_ns) noexcept {
  if (ended_ || requests_.newest_sequence() == seen_) return std::nullopt;
  Request request;
  const auto read = requests_.read(request);
  if (!read) return std::nullopt;
  seen_ = read.sequence;
  request.stamp_ns = now_ns;
  make_sound(request);
  commands_.publish(request, now_ns);
  return request;
}

template class PassedRequests<MotionRequest>;
template class PassedRequests<WalkToRequest>;

}  // namespace gaitway::msgcontroller
