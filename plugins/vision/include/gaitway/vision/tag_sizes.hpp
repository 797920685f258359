// Sizes of single tags as people write them: "3: 0.2 m, 17: 80 mm".
#pragma once

#include <string_view>
#include <vector>

#include "gaitway/vision/vision.hpp"

namespace gaitway::vision {

// Throws input::InputError with value, rule and remedy.
[[nodiscard]] std::vector<TagSize> tag_sizes_in(std::string_view text);

}  // namespace gaitway::vision
