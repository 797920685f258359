// Where the robot API listens, whom it lets in, and the times that the server itself keeps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/api/limits.hpp"

namespace gaitway::api {

struct ServerOptions {
  // A numeric IPv4 or IPv6 address, or localhost for 127.0.0.1. One that is not loopback wants TLS and a
  // token.
  std::string address = "127.0.0.1";
  std::uint16_t port = 9090;  // 0: any that is free
  // Web pages that may connect, as `https://host:port`; empty: those that this machine serves itself. Clients
  // that are no web pages send no origin, and are not asked for one.
  std::vector<std::string> origins;
  std::filesystem::path token_file;        // empty: no token is wanted
  std::filesystem::path certificate_file;  // PEM, the server's first, then its issuers; empty: no TLS
  std::filesystem::path key_file;          // PEM
  Limits limits;
  std::size_t header_bytes = std::size_t{8} * 1024;  // of the request with which a client connects
  std::size_t send_buffer_bytes =
      std::size_t{64} * 1024;                  // in the kernel, for each client: a slow one sees old data
  std::int64_t ping_ns = 300'000'000;          // between pings
  std::int64_t closing_ns = 500'000'000;       // from the decision to close a connection to its end
  std::int64_t accept_pause_ns = 100'000'000;  // before accepting again, when descriptors or memory ran out
  std::int64_t tick_ns = 10'000'000;
  std::int64_t poll_ns = 2'000'000;
};

}  // namespace gaitway::api
