// What a client may ask for, before it is refused. Each is a parameter of the plug-in, so each can be
// configured and is documented there.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gaitway::api {

struct Limits {
  std::size_t connections = 256;
  std::size_t connections_of_one_address = 256;
  std::size_t message_bytes = std::size_t{64} * 1024;        // of one that comes in
  std::size_t depth = 32;                                    // nested arrays and objects in it
  std::size_t subscriptions = 64;                            // of one client
  std::size_t advertisements = 16;                           // of one client
  std::size_t queue_length = 100;                            // of one subscription
  std::size_t waiting_bytes = std::size_t{4} * 1024 * 1024;  // that one client may leave unread
  double messages_per_s = 500.0;                             // from one client, over a second
  std::int64_t handshake_ns = 5'000'000'000;                 // from connecting to the end of the handshake
  std::int64_t authentication_ns = 5'000'000'000;            // from the handshake to the token
  std::int64_t write_ns = 2'000'000'000;    // in which a client must take what was written to it
  std::int64_t silence_ns = 1'000'000'000;  // without a sign of life: the connection is dead
  std::int64_t lease_ns = 1'000'000'000;    // of the command, without a command or a keep-alive
  std::int64_t answer_ns = 10'000'000'000;  // in which a service that takes time must have answered
  std::int64_t velocity_ns = 500'000'000;   // that a velocity command holds
  double forward_m_per_s = 1.0;             // of a velocity command, in either direction, also to the left
  double turn_rad_per_s = 2.0;
};

}  // namespace gaitway::api
