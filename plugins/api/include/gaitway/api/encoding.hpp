// The forms in which messages go out.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gaitway::api {

enum class Encoding : std::uint8_t { json, cbor };
inline constexpr std::size_t kEncodings = 2;

}  // namespace gaitway::api
