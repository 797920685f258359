// The causes' names, for diagnostics.
#include "gaitway/api/server_statistics.hpp"

namespace gaitway::api {
namespace {

constexpr std::array<std::string_view, kRefusalCount> kRefusals{
    "too many connections", "bad request", "wrong path",     "no WebSocket", "foreign origin",
    "wrong token",          "TLS failed",  "handshake time", "client left"};
constexpr std::array<std::string_view, kClosingCount> kClosings{"closed by client",
                                                                "closed by session",
                                                                "protocol error",
                                                                "message too big",
                                                                "flood",
                                                                "too slow",
                                                                "silent",
                                                                "lost",
                                                                "no place",
                                                                "shut down"};

}  // namespace

std::string_view name(Refusal cause) noexcept {
  return kRefusals[static_cast<std::size_t>(cause)];
}

std::string_view name(Closing cause) noexcept {
  return kClosings[static_cast<std::size_t>(cause)];
}

}  // namespace gaitway::api
