// On which side a robot lies.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace gaitway::trajectory {

enum class LyingSide : std::uint8_t { front, back, left, right };
inline constexpr std::array<std::string_view, 4> kLyingSideNames{"front", "back", "left", "right"};

[[nodiscard]] constexpr std::string_view name_of(LyingSide side) noexcept {
  return kLyingSideNames[static_cast<std::size_t>(side)];
}

[[nodiscard]] constexpr LyingSide opposite(LyingSide side) noexcept {
  constexpr std::array kOpposite{LyingSide::back, LyingSide::front, LyingSide::right, LyingSide::left};
  return kOpposite[static_cast<std::size_t>(side)];
}

// The side of the trunk (x forward, y left) that points down most. Of a trunk that does not stand upright;
// roll and pitch as in Estimate::attitude.
[[nodiscard]] inline LyingSide lying_side(double roll_rad, double pitch_rad) noexcept {
  const double forward_down = std::sin(pitch_rad);
  const double left_down = -std::cos(pitch_rad) * std::sin(roll_rad);
  if (std::abs(forward_down) >= std::abs(left_down)) {
    return forward_down > 0.0 ? LyingSide::front : LyingSide::back;
  }
  return left_down > 0.0 ? LyingSide::left : LyingSide::right;
}

}  // namespace gaitway::trajectory
