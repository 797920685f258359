// Where the socketcand server listens: reads "[ADDRESS:]PORT" and lets loopback addresses pass, no others.
#include <arpa/inet.h>
#include <netinet/in.h>

#include <charconv>

#include "gaitway/can/simulated/socketcand_server.hpp"

namespace gaitway::can {
namespace {

[[noreturn]] void refuse(std::string_view text, std::string_view why) {
  throw BusError("socketcand address '" + std::string(text) + "': " + std::string(why));
}

bool is_loopback(const std::string& host) {
  in_addr v4{};
  in6_addr v6{};
  if (inet_pton(AF_INET, host.c_str(), &v4) == 1) {
    return (ntohl(v4.s_addr) >> 24U) == IN_LOOPBACKNET;
  }
  return inet_pton(AF_INET6, host.c_str(), &v6) == 1 && IN6_IS_ADDR_LOOPBACK(&v6);
}

}  // namespace

SocketcandAddress SocketcandAddress::parse(std::string_view text) {
  SocketcandAddress address;
  const std::size_t colon = text.rfind(':');
  const std::string_view port = colon == std::string_view::npos ? text : text.substr(colon + 1);
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (port.empty() || error != std::errc() || end != port.data() + port.size()) {
    refuse(text, "must be [ADDRESS:]PORT with a port from 0 (any that is free) to 65535, such as 29536");
  }
  if (colon == std::string_view::npos) {
    return address;
  }
  std::string_view host = text.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') {
    host = host.substr(1, host.size() - 2);
  }
  if (host != "localhost") {
    address.host = host;
  }
  if (!is_loopback(address.host)) {
    refuse(
        text,
        "is not on this machine's loopback. The protocol has no passwords, and whoever reaches it can move "
        "the robot. Use 127.0.0.1 or ::1, and an ssh tunnel (ssh -L 29536:127.0.0.1:29536) from elsewhere");
  }
  return address;
}

}  // namespace gaitway::can
