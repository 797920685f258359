// Compares texts: what is spelt otherwise is not the robot's.
#include "page_host.hpp"

#include <arpa/inet.h>

#include <array>
#include <string>

namespace gaitway::api {
namespace {

// Without the port, and without the brackets of an IPv6 address.
std::string_view address_in(std::string_view host) {
  if (host.starts_with('[')) {
    const std::size_t end = host.find(']');
    return end == std::string_view::npos ? std::string_view() : host.substr(1, end - 1);
  }
  return host.substr(0, host.find(':'));
}

}  // namespace

bool is_numeric_host(std::string_view host) {
  const std::string address(address_in(host));
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  return address == "localhost" || inet_pton(AF_INET, address.c_str(), bytes.data()) == 1 ||
         inet_pton(AF_INET6, address.c_str(), bytes.data()) == 1;
}

bool is_own_page(std::string_view origin, std::string_view host, bool tls) {
  const std::string_view scheme = tls ? "https://" : "http://";
  return origin.starts_with(scheme) && origin.substr(scheme.size()) == host && is_numeric_host(host);
}

}  // namespace gaitway::api
