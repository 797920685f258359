// A pair of grey pictures as it comes from the robot's stereo camera, and what is known of when it was taken.
#pragma once

#include <cstdint>
#include <span>

namespace gaitway::vision {

// Both are rows of pixels from the top left. The spans belong to the caller.
struct PicturePair {
  std::int64_t stamp_ns = 0;    // middle of the exposure of the middle row
  std::int64_t readout_ns = 0;  // from the first row's to the last row's
  std::uint64_t number = 0;     // counts pairs; a gap: some were dropped
  int width = 0, height = 0;
  std::span<const std::uint8_t> left, right;
};

}  // namespace gaitway::vision
