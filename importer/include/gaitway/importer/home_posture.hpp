// The posture in which an imported robot stands.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gaitway/importer/body_plan.hpp"
#include "gaitway/importer/maker_robot.hpp"
#include "gaitway/importer/sole.hpp"

namespace gaitway::importer {

struct HomePosture {
  std::vector<double> angle_rad;  // MakerRobot::joints' order
  double hip_height_m = 0.0;      // of the hip pitch joints above the soles
  double knee_bend_rad = 0.0;     // of the shin against the thigh
  std::vector<std::string> notes;
};

// Of the knees in the stand: humanoid22's.
inline constexpr double kUsualBend_rad = 0.69;

// Zero, or as near to it as the joint's limits allow and a little leeway inside them.
[[nodiscard]] double neutral_rad(const MakerJoint& joint) noexcept;

// Soles level side by side, the CoM over their middle, the knees bent forward by `most_bend_rad` or as far as
// the limits of hip, knee and ankle leave them room for steps; arms as they are at zero if they hang there,
// hanging otherwise; everything else at zero, or as near as its limits allow. `robot` is in its base frame.
// Throws input::InputError naming the joint whose limits allow no such stand.
[[nodiscard]] HomePosture find_home_posture(const MakerRobot& robot, const BodyPlan& plan,
                                            const std::array<FoundSole, 2>& soles,
                                            double most_bend_rad = kUsualBend_rad);

}  // namespace gaitway::importer
