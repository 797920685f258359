// The forms in which messages go out.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gaitway::api {

enum class Encoding : std::uint8_t {
  json,
  cbor,
  cbor_raw  // an envelope of CBOR around the message in ROS 2's own encoding (CDR)
};
inline constexpr std::size_t kEncodings = 3;

[[nodiscard]] constexpr bool is_binary(Encoding encoding) noexcept {
  return encoding != Encoding::json;
}

}  // namespace gaitway::api
