// Texts that topics carry in arrays of fixed size: UTF-8, ended by 0.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

namespace gaitway::api {

template <std::size_t size>
[[nodiscard]] std::string text_of(const std::uint8_t (&bytes)[size]) {
  return {bytes, std::find(bytes, bytes + size, std::uint8_t{0})};
}

}  // namespace gaitway::api
