// Force and zero moment point (ZMP) under one foot, from its four force cells.
#pragma once

#include <Eigen/Core>
#include <span>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::zmp {

struct FootPressure {
  double force_N = 0.0;  // sum of the cells, as measured (noise can make it negative)
  Eigen::Vector2d zmp_m = Eigen::Vector2d::Zero();  // in the foot's sole frame
};

// The ZMP of cells that carry vertical force is the mean of their places, weighted by force (M. Vukobratovic,
// B. Borovac, "Zero-moment point - thirty-five years of its life", 2004). It may lie outside of the cells (a
// rigid sole on its edge loads the cells behind it with tension), but is limited to the sole, which noise
// alone can leave. Below `least_force_N` it says nothing and is the sole's centre.
[[nodiscard]] FootPressure foot_pressure(const urdf::Foot& foot, std::span<const double, 4> cell_force_N,
                                         double least_force_N) noexcept;

}  // namespace gaitway::zmp
