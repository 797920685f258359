// Where the other end of the link is, as people write it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gaitway::link {

// The text says what was read, the rule and the remedy.
class LinkAddressError : public std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

//   unix:PATH             a Unix socket, on one computer
//   serial:DEVICE:BAUD    a serial line
struct LinkAddress {
  enum class Kind : std::uint8_t { unix_socket, serial };
  Kind kind = Kind::unix_socket;
  std::filesystem::path path;  // of the socket or the device
  std::uint32_t baud = 0;      // of a serial line

  [[nodiscard]] bool narrow() const noexcept { return kind == Kind::serial; }
};

// As people write it.
[[nodiscard]] std::string text_of(const LinkAddress& address);

// Throws LinkAddressError.
[[nodiscard]] LinkAddress parse_link_address(std::string_view text);

}  // namespace gaitway::link
