// Surfaces and tags as pixels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gaitway/world/world.hpp"

namespace gaitway::world {

struct Picture {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;  // rows from top to bottom
};

// One repeat of a surface that is no image file. The same numbers give the same bytes.
[[nodiscard]] Picture picture_of(const Surface& surface);

// Tags are those of the AprilTag family 36h11: 6 x 6 bits in a black border one cell wide.
inline constexpr int kTags = 587;
inline constexpr int kTagCells = 8;  // along a side, border included
// [row from top][column from left]: white or not. `id` is 0..586.
[[nodiscard]] std::array<std::array<bool, kTagCells>, kTagCells> tag_cells(int id) noexcept;
// With a white margin one cell wide around it, without which no reader finds it.
inline constexpr int kTagPictureCells = kTagCells + 2;
[[nodiscard]] Picture picture_of_tag(int id);

}  // namespace gaitway::world
