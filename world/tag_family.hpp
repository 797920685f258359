// The code words of the tag family.
#pragma once

#include <array>
#include <cstdint>

#include "gaitway/world/picture.hpp"

namespace gaitway::world {

// 36 bits each, row by row; the highest is the upper left cell. 1: white.
extern const std::array<std::uint64_t, kTags> kTagWords;

}  // namespace gaitway::world
