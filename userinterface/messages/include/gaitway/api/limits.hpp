// What a client may ask for, before it is refused. Each can be set by a file of limits, and is documented:
// names, units and meaning stand in a table.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace gaitway::api {

struct Limits {
  std::size_t connections = 256;
  std::size_t connections_of_one_address = 224;              // so that others always find places
  std::size_t strangers_of_one_address = 64;                 // of these; who have shown no token yet
  std::size_t message_bytes = std::size_t{64} * 1024;        // of one that comes in
  std::size_t depth = 32;                                    // nested arrays and objects in it
  std::size_t subscriptions = 64;                            // of one client
  std::size_t advertisements = 16;                           // of one client
  std::size_t client_topics = 256;                           // of all clients together
  std::size_t kept_bytes = std::size_t{16} * 1024;           // of one message of a client's latched topic
  std::size_t services = 16;                                 // that one client offers
  std::size_t client_services = 256;                         // of all clients together
  std::size_t calls_of_provider = 32;                        // under way to one client
  std::size_t calls_of_all = 256;                            // under way to all clients
  std::size_t queue_length = 100;                            // of one subscription
  std::size_t waiting_bytes = std::size_t{1} * 1024 * 1024;  // that one client may leave unread
  std::size_t waiting_bytes_of_all = std::size_t{16} * 1024 * 1024;  // all clients together
  double messages_per_s = 500.0;                                     // from one client, over a second
  std::int64_t handshake_ns = 5'000'000'000;       // from connecting to the end of the handshake
  std::int64_t authentication_ns = 5'000'000'000;  // from the handshake to the token
  std::int64_t write_ns = 2'000'000'000;           // in which a client must take what was written to it
  std::int64_t silence_ns = 10'000'000'000;        // without a sign of life: the connection is dead
  std::int64_t lease_ns = 1'000'000'000;           // of the command, without a command or a keep-alive
  std::int64_t answer_ns = 10'000'000'000;         // in which a service that takes time must have answered
  std::int64_t velocity_ns = 500'000'000;          // that a velocity command holds
  double forward_m_per_s = 1.0;  // of a velocity command, in either direction, also to the left
  double turn_rad_per_s = 2.0;
};

// Bytes that the process takes at most, by which it bounds itself.
[[nodiscard]] constexpr std::uint64_t most_memory_bytes(const Limits& limits) noexcept {
  constexpr std::uint64_t kKiB = 1024, kMiB = 1024 * kKiB;
  constexpr std::uint64_t kWithoutClients_bytes = 128 * kMiB;  // programs, stacks, mirror, recorder, meshes
  constexpr std::uint64_t kConnection_bytes = 512 * kKiB;      // WebSocket, TLS, and what is being written
  constexpr std::uint64_t kRoom = 2;        // a text that has grown has up to so many times its bytes
  constexpr std::uint64_t kUnlookedAt = 3;  // messages of one client: one that is being read, two that wait
  constexpr std::uint64_t kTopic_bytes = 8 * kKiB;    // of clients: its names, types, ids and who uses it
  constexpr std::uint64_t kService_bytes = 2 * kKiB;  // of clients, and a call that is under way
  return kWithoutClients_bytes + limits.client_topics * kTopic_bytes +
         (limits.client_services + limits.calls_of_all) * kService_bytes +
         limits.connections * (kConnection_bytes + kUnlookedAt * limits.message_bytes) +
         kRoom * limits.waiting_bytes_of_all;
}

inline constexpr int kMostOfAKind = 65'536, kMostLimitBytes = 1 << 30, kMostDepth = 1000;

struct LimitRow {
  std::string_view name;  // of the parameter
  std::string_view unit;  // of the parameter: "s" also where the member is in nanoseconds; empty: a number
  std::string_view doc;
  int highest = kMostOfAKind;  // that a file may set, of a std::size_t
};

// Calls visit(row, member) for every limit; members are std::size_t, double, or std::int64_t in nanoseconds.
// A limit that is added without a row does not compile.
template <class AnyLimits, class Visitor>
void visit_limits(AnyLimits& limits, Visitor&& visit) {
  auto& [connections, of_one_address, strangers, message_bytes, depth, subscriptions, advertisements,
         client_topics, kept_bytes, services, client_services, calls_of_provider, calls_of_all, queue_length,
         waiting_bytes, waiting_bytes_of_all, messages_per_s, handshake, authentication, write, silence,
         lease, answer, velocity, forward, turn] = limits;
  visit(LimitRow{"connections", "",
                 "connections at a time; beyond them the oldest without a handshake or token gives way"},
        connections);
  visit(LimitRow{"connections_of_one_address", "",
                 "of these from one address; beyond them its oldest gives way in the same way"},
        of_one_address);
  visit(LimitRow{"strangers_of_one_address", "",
                 "of these whose handshake has not ended yet, or who have not shown a token that is wanted; "
                 "beyond them the oldest gives way"},
        strangers);
  visit(LimitRow{"message_bytes", "", "bytes of one message from a client", kMostLimitBytes}, message_bytes);
  visit(LimitRow{"depth", "", "nested arrays and objects in a message from a client", kMostDepth}, depth);
  visit(LimitRow{"subscriptions", "", "subscriptions of one client"}, subscriptions);
  visit(LimitRow{"advertisements", "", "topics that one client advertises"}, advertisements);
  visit(LimitRow{"client_topics", "", "topics that clients have among themselves, of all together"},
        client_topics);
  visit(LimitRow{"kept_bytes", "",
                 "bytes, as JSON, of a message of a client's latched topic, which is kept; counts with what "
                 "waits for it",
                 kMostLimitBytes},
        kept_bytes);
  visit(LimitRow{"services", "", "services that one client offers"}, services);
  visit(LimitRow{"client_services", "", "services that all clients together offer"}, client_services);
  visit(LimitRow{"calls_of_provider", "", "calls of one client's services that wait for its answers"},
        calls_of_provider);
  visit(LimitRow{"calls_of_all", "", "calls of all clients' services that wait for answers"}, calls_of_all);
  visit(LimitRow{"queue_length", "", "messages that wait in one subscription; the oldest are dropped"},
        queue_length);
  visit(LimitRow{"waiting_bytes", "",
                 "bytes that a client leaves unread before it is dropped; each message counts 128 more",
                 kMostLimitBytes},
        waiting_bytes);
  visit(LimitRow{"waiting_bytes_of_all", "",
                 "bytes that all clients together leave unread before the one with the most is dropped",
                 kMostLimitBytes},
        waiting_bytes_of_all);
  visit(LimitRow{"messages_per_s", "1/s", "messages from one client"}, messages_per_s);
  visit(LimitRow{"handshake", "s", "from connecting to the end of the handshake"}, handshake);
  visit(LimitRow{"authentication", "s", "from the handshake to the token"}, authentication);
  visit(LimitRow{"write", "s", "in which a client takes what was written to it"}, write);
  visit(LimitRow{"silence", "s",
                 "without a sign of life while it is listened to, after which a connection is dead"},
        silence);
  visit(LimitRow{"lease", "s", "of the command, without a command or a keep-alive"}, lease);
  visit(LimitRow{"answer", "s", "in which a service that takes time has answered"}, answer);
  visit(LimitRow{"velocity", "s", "that a velocity command holds; then the robot stops smoothly"}, velocity);
  visit(LimitRow{"forward", "m/s", "velocity forward, back, left and right in a command"}, forward);
  visit(LimitRow{"turn", "rad/s", "velocity of turning in a command"}, turn);
}

}  // namespace gaitway::api
