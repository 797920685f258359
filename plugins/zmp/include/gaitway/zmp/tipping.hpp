// The body as an inverted pendulum over the edge of the feet: does it tip, which way, and when does it hit
// the ground.
#pragma once

#include <Eigen/Core>
#include <array>

namespace gaitway::zmp {

// Where the body is over its feet, in one level frame (z against gravity).
struct BodyOverFeet {
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d com_velocity_m_per_s = Eigen::Vector3d::Zero();
  std::array<std::array<Eigen::Vector3d, 4>, 2> sole_corner_m{};  // of both feet, in any order
};

// What the pendulum does not know of the body.
struct TippingModel {
  double impact_tilt_rad = 1.0;  // of the line from the edge to the CoM when the first link hits the ground
  double inertia_factor = 1.25;  // the body's inertia about the edge, over that of all its mass in the CoM
};

struct Tipping {
  // 2 sin(tilt / 2) + rate / ω about the edge: the capture point of the nonlinear pendulum. Above 0 the body
  // passes over the edge, however slowly, unless a foot is put down beyond it. One is some 0.38 m of the DCM.
  double state = 0.0;
  double time_to_impact_s = 0.0;                         // kNoImpact_s if it does not tip
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  // outwards, square to the edge
};

inline constexpr double kNoImpact_s = 10.0;  // and more

// About the edge of the soles' convex hull over which it tips most. Feet in the air count as well: they come
// down before the body does. 0.3 us, 2 us while it tips; no allocation.
Tipping tipping_of(const BodyOverFeet& body, const TippingModel& model) noexcept;

}  // namespace gaitway::zmp
