// Names, units and ranges of the parameters; their defaults are those of ServerOptions and Limits.
#include "gaitway/api/api_parameters.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

#include "gaitway/api/recorder.hpp"
#include "gaitway/core/plugin.hpp"

namespace gaitway::api {
namespace {

constexpr double kNanoseconds = 1e9;

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    const auto begin = part.find_first_not_of(' ');
    if (begin != std::string::npos) {
      parts.push_back(part.substr(begin, part.find_last_not_of(' ') - begin + 1));
    }
  }
  return parts;
}

void declare_limits(Setup& setup, Limits& limits) {
  const auto count = [&setup](std::size_t& value, const char* name, double highest, const char* doc) {
    value = static_cast<std::size_t>(
        setup.parameter(name, static_cast<std::int64_t>(value), "1", {1.0, highest, doc}));
  };
  const auto time = [&setup](std::int64_t& value_ns, const char* name, double lowest_s, double highest_s,
                             const char* doc) {
    value_ns = static_cast<std::int64_t>(
        setup.parameter(name, static_cast<double>(value_ns) / kNanoseconds, "s", {lowest_s, highest_s, doc}) *
        kNanoseconds);
  };
  count(limits.connections, "connections", 4000.0, "clients at a time");
  count(limits.connections_of_one_address, "connections_of_one_address", 4000.0,
        "of these, from one address");
  count(limits.message_bytes, "message_bytes", 1e7, "largest message that a client may send");
  count(limits.depth, "depth", 1000.0, "nested arrays and objects in it");
  count(limits.subscriptions, "subscriptions", 1000.0, "of one client");
  count(limits.advertisements, "advertisements", 1000.0, "of one client");
  count(limits.queue_length, "queue_length", 10000.0, "longest queue of a subscription");
  count(limits.waiting_bytes, "waiting_bytes", 1e8, "what one client may leave unread");
  limits.messages_per_s = setup.parameter("message_rate", limits.messages_per_s, "1/s",
                                          {1.0, 1e6, "messages that one client may send"});
  time(limits.handshake_ns, "handshake_time", 0.1, 60.0, "from connecting to the end of the handshake");
  time(limits.authentication_ns, "authentication_time", 0.1, 60.0, "from the handshake to the token");
  time(limits.write_ns, "write_time", 0.1, 60.0, "in which a client must take what was written to it");
  time(limits.silence_ns, "silence", 0.1, 60.0, "without a sign of life: the connection is dead");
  time(limits.lease_ns, "lease", 0.1, 60.0, "of the command, without a command or a keep-alive");
  time(limits.answer_ns, "answer_time", 0.1, 600.0, "in which a service that takes time must have answered");
  time(limits.velocity_ns, "velocity_time", 0.05, 10.0, "that a velocity command holds");
  limits.forward_m_per_s = setup.parameter("largest_speed", limits.forward_m_per_s, "m/s",
                                           {0.01, 1.5, "of a velocity command, in each direction"});
  limits.turn_rad_per_s = setup.parameter("largest_turn_rate", limits.turn_rad_per_s, "rad/s",
                                          {0.01, 3.0, "of a velocity command"});
}

}  // namespace

ApiParameters declare_parameters(Setup& setup) {
  ApiParameters parameters;
  ServerOptions& server = parameters.server;
  server.address =
      setup.parameter("address", server.address, "to listen on; not loopback: with TLS and token");
  server.port = static_cast<std::uint16_t>(setup.parameter("port", static_cast<std::int64_t>(server.port),
                                                           "1", {0.0, 65535.0, "TCP port; 0: any free one"}));
  server.origins = split(setup.parameter("origins", "", "web origins that may connect, with commas between"));
  server.token_file = setup.parameter("token_file", "", "file with the token that clients must know");
  server.certificate_file = setup.parameter("tls_certificate", "", "certificate chain (PEM)");
  server.key_file = setup.parameter("tls_key", "", "its private key (PEM)");
  parameters.recording_bytes = static_cast<std::uint64_t>(
      setup.parameter("recording_bytes", static_cast<double>(kRecordingLimit_bytes), "1",
                      {1e6, 1e12, "a recording's size, at most"}));
  declare_limits(setup, server.limits);
  return parameters;
}

}  // namespace gaitway::api
