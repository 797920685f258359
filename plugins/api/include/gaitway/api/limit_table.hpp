// The limits as parameters of the plug-in: names, units and meaning, for its set-up and for the reference.
#pragma once

#include <string_view>

#include "gaitway/api/limits.hpp"

namespace gaitway::api {

struct LimitRow {
  std::string_view name;  // of the parameter
  std::string_view unit;  // of the parameter: "s" also where the member is in nanoseconds; empty: a number
  std::string_view doc;
};

// Calls visit(row, member) for every limit; members are std::size_t, double, or std::int64_t in nanoseconds.
// A limit that is added without a row does not compile.
template <class AnyLimits, class Visitor>
void visit_limits(AnyLimits& limits, Visitor&& visit) {
  auto& [connections, of_one_address, message_bytes, depth, subscriptions, advertisements, queue_length,
         waiting_bytes, messages_per_s, handshake, authentication, write, silence, lease, answer, velocity,
         forward, turn] = limits;
  visit(LimitRow{"connections", "", "connections at a time"}, connections);
  visit(LimitRow{"connections_of_one_address", "", "of these from one address"}, of_one_address);
  visit(LimitRow{"message_bytes", "", "bytes of one message from a client"}, message_bytes);
  visit(LimitRow{"depth", "", "nested arrays and objects in a message from a client"}, depth);
  visit(LimitRow{"subscriptions", "", "subscriptions of one client"}, subscriptions);
  visit(LimitRow{"advertisements", "", "topics that one client advertises"}, advertisements);
  visit(LimitRow{"queue_length", "", "messages that wait in one subscription; the oldest are dropped"},
        queue_length);
  visit(LimitRow{"waiting_bytes", "", "bytes that a client leaves unread before it is dropped"},
        waiting_bytes);
  visit(LimitRow{"messages_per_s", "1/s", "messages from one client"}, messages_per_s);
  visit(LimitRow{"handshake", "s", "from connecting to the end of the handshake"}, handshake);
  visit(LimitRow{"authentication", "s", "from the handshake to the token"}, authentication);
  visit(LimitRow{"write", "s", "in which a client takes what was written to it"}, write);
  visit(LimitRow{"silence", "s", "without a sign of life, after which a connection is dead"}, silence);
  visit(LimitRow{"lease", "s", "of the command, without a command or a keep-alive"}, lease);
  visit(LimitRow{"answer", "s", "in which a service that takes time has answered"}, answer);
  visit(LimitRow{"velocity", "s", "that a velocity command holds; then the robot stops smoothly"}, velocity);
  visit(LimitRow{"forward", "m/s", "velocity forward, back, left and right in a command"}, forward);
  visit(LimitRow{"turn", "rad/s", "velocity of turning in a command"}, turn);
}

}  // namespace gaitway::api
