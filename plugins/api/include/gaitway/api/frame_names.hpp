// Frames of the messages that are no links of the robot. Links bear their URDF's names.
#pragma once

#include <array>
#include <string_view>

namespace gaitway::api {

// Fixed to the ground, z = 0 on it; origin between the feet at the start (robot_frames.hpp).
inline constexpr std::string_view kOdomFrame = "odom";
// [Side]: below the ankle on the sole, as the robot's description has it; children of the feet's links.
inline constexpr std::array<std::string_view, 2> kSoleFrames{"left_sole", "right_sole"};

}  // namespace gaitway::api
