// Whether each camera's picture shows anything: dead, dark, too bright, or the same one again.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "gaitway/vision/pictures.hpp"

namespace gaitway::vision {

enum class PictureFault : std::uint8_t { none, dark, bright, dead };

struct PairCheck {
  std::array<PictureFault, 2> fault{};  // left, right
  std::array<bool, 2> frozen{};
};

// Looks at every pair in turn. No allocation.
class PictureCheck {
 public:
  [[nodiscard]] PairCheck check(const PicturePair& pair) noexcept;

 private:
  struct Camera {
    std::uint64_t last = 0;  // of all its pixels
    int repeats = 0;         // pictures in a row that were the same to the bit
  };
  std::array<Camera, 2> cameras_{};
};

// Of one picture's grey levels.
[[nodiscard]] PictureFault fault_of(std::span<const std::uint8_t> picture) noexcept;

}  // namespace gaitway::vision
