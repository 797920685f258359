// unix:PATH and serial:DEVICE:BAUD.
#include "gaitway/link/link_address.hpp"

#include <charconv>

#include "gaitway/link/serial_carrier.hpp"
#include "gaitway/process/listening_socket.hpp"

namespace gaitway::link {
namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& rule) {
  throw LinkAddressError("link '" + std::string(text) + "': " + rule +
                         "; write unix:PATH, or serial:DEVICE:BAUD, as unix:/run/gaitway/link.sock or "
                         "serial:/dev/ttyS1:1000000");
}

}  // namespace

std::string text_of(const LinkAddress& address) {
  return address.kind == LinkAddress::Kind::serial
             ? "serial:" + address.path.native() + ":" + std::to_string(address.baud)
             : "unix:" + address.path.native();
}

LinkAddress parse_link_address(std::string_view text) {
  constexpr std::string_view kUnix = "unix:", kSerial = "serial:";
  if (text.starts_with(kUnix)) {
    const std::string_view path = text.substr(kUnix.size());
    if (path.empty()) {
      refuse(text, "names no path");
    }
    try {
      static_cast<void>(process::socket_address(path));
    } catch (const process::SocketError& error) {
      refuse(text, error.what());
    }
    return {LinkAddress::Kind::unix_socket, path, 0};
  }
  if (!text.starts_with(kSerial)) {
    refuse(text, "is no kind of link that there is");
  }
  const std::string_view rest = text.substr(kSerial.size());
  const std::size_t colon = rest.rfind(':');
  if (colon == std::string_view::npos || colon == 0) {
    refuse(text, "names no device and baud rate");
  }
  const std::string_view number = rest.substr(colon + 1);
  std::uint32_t baud = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), baud);
  if (read.ec != std::errc() || read.ptr != number.data() + number.size() || baud == 0) {
    refuse(text, "has the baud rate '" + std::string(number) + "', which is no whole number above 0");
  }
  try {
    SerialCarrier::check(rest.substr(0, colon), baud);
  } catch (const SerialError& error) {
    refuse(text, error.what());
  }
  return {LinkAddress::Kind::serial, rest.substr(0, colon), baud};
}

}  // namespace gaitway::link
