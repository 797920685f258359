// In which postures a robot meets the ground: as its folder says, or, where that says nothing, as its arms,
// waist and legs allow.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

// Of each joint, in the robot's order, rad; not a number: it stays where it is.
using PostureAngles = std::vector<double>;

// By where to the robot falls.
enum class FallDirection : std::uint8_t { ahead, left, back, right };
using FallPostures = std::array<PostureAngles, 4>;  // [FallDirection]

inline constexpr const char* kFallPostureFile = "fall_postures.yaml";

// Those of <robot's folder>/fall_postures.yaml; without that file own_postures(). Throws urdf::RobotError
// with file, line, field, value, rule and remedy.
[[nodiscard]] std::optional<FallPostures> fall_postures_of(const urdf::RobotModel& robot);

// By what the joints do (urdf::BodyJoints): arms go to where it falls, the waist turns there, knees bend,
// within the joints' stops. Nothing: a robot without both arms falls less hard if it goes soft at once.
// Throws std::invalid_argument if a leg lacks a joint.
[[nodiscard]] std::optional<FallPostures> own_postures(const urdf::RobotModel& robot);

}  // namespace gaitway::trajectory
