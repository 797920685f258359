// A classic CAN data frame with an 11-bit identifier: the unit that everything on the bus is made of.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace gaitway::can {

struct Frame {
  std::uint16_t id = 0;   // 0..0x7FF; the lower, the higher its priority
  std::uint8_t size = 0;  // number of valid bytes in data, 0..8
  std::array<std::uint8_t, 8> data{};

  friend bool operator==(const Frame&, const Frame&) = default;
  [[nodiscard]] std::span<const std::uint8_t> payload() const noexcept { return {data.data(), size}; }
};

}  // namespace gaitway::can
