// Brown's distortion and its inverse.
#include "gaitway/urdf/lens.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

namespace gaitway::urdf {
namespace {

constexpr double kLeastDepth_m = 1e-6;
constexpr double kWidest = 8.0;  // 83 degrees from the axis: no lens of this model sees farther

// d(radius after distortion) / d(radius), tangential parts left out.
double radial_slope(const std::array<double, 5>& k, double radius) noexcept {
  const double s = radius * radius;
  return 1.0 + s * (3.0 * k[0] + s * (5.0 * k[1] + s * 7.0 * k[4]));
}

double radius_of_turn(const std::array<double, 5>& k) noexcept {
  constexpr double kStep = 1.0 / 256.0;
  double rising = 0.0;
  while (rising < kWidest && radial_slope(k, rising + kStep) > 0.0) rising += kStep;
  if (rising >= kWidest) return std::numeric_limits<double>::infinity();
  double turned = rising + kStep;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (rising + turned);
    (radial_slope(k, middle) > 0.0 ? rising : turned) = middle;
  }
  return rising;
}

// d distort(x, y) / d(x, y).
Eigen::Matrix2d distortion_slope(const std::array<double, 5>& k, const Eigen::Vector2d& direction) noexcept {
  const double x = direction.x(), y = direction.y(), s = direction.squaredNorm();
  const double radial = 1.0 + s * (k[0] + s * (k[1] + s * k[4]));
  const double slope = 2.0 * (k[0] + s * (2.0 * k[1] + s * 3.0 * k[4]));  // d radial / d s, times two
  const double across = slope * x * y + 2.0 * (k[2] * x + k[3] * y);
  Eigen::Matrix2d result;
  result << radial + slope * x * x + 2.0 * k[2] * y + 6.0 * k[3] * x, across,  //
      across, radial + slope * y * y + 6.0 * k[2] * y + 2.0 * k[3] * x;
  return result;
}

}  // namespace

Lens::Lens(const LensParameters& parameters)
    : parameters_(parameters), largest_radius_(radius_of_turn(parameters.distortion)) {}

Eigen::Vector2d Lens::distort(const Eigen::Vector2d& direction) const noexcept {
  const auto& k = parameters_.distortion;
  const double x = direction.x(), y = direction.y(), s = direction.squaredNorm();
  const double radial = 1.0 + s * (k[0] + s * (k[1] + s * k[4]));
  return {x * radial + 2.0 * k[2] * x * y + k[3] * (s + 2.0 * x * x),
          y * radial + k[2] * (s + 2.0 * y * y) + 2.0 * k[3] * x * y};
}

std::optional<Eigen::Vector2d> Lens::project(const Eigen::Vector3d& point_m) const noexcept {
  if (!(point_m.z() > kLeastDepth_m)) return std::nullopt;
  const Eigen::Vector2d direction = point_m.head<2>() / point_m.z();
  if (!(direction.norm() < largest_radius_)) return std::nullopt;
  const Eigen::Vector2d seen = distort(direction);
  return Eigen::Vector2d(parameters_.fx_px * seen.x() + parameters_.cx_px,
                         parameters_.fy_px * seen.y() + parameters_.cy_px);
}

std::optional<Eigen::Vector2d> Lens::unproject(const Eigen::Vector2d& pixel) const noexcept {
  constexpr int kMostSteps = 30;
  constexpr double kDone = 1e-12;
  const Eigen::Vector2d seen((pixel.x() - parameters_.cx_px) / parameters_.fx_px,
                             (pixel.y() - parameters_.cy_px) / parameters_.fy_px);
  Eigen::Vector2d direction = seen;
  for (int step = 0; step < kMostSteps; ++step) {
    const Eigen::Vector2d off = distort(direction) - seen;
    if (off.norm() < kDone) {
      return direction.norm() < largest_radius_ ? std::optional(direction) : std::nullopt;
    }
    const Eigen::Matrix2d slope = distortion_slope(parameters_.distortion, direction);
    if (!(slope.determinant() > 0.0)) return std::nullopt;
    direction -= slope.inverse() * off;
  }
  return std::nullopt;
}

}  // namespace gaitway::urdf
