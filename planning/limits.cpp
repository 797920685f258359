// The rules of a step, and those that the limits themselves must keep.
#include "gaitway/planning/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace gaitway::planning {
namespace {

constexpr double kRounding = 1e-9;

void require(bool kept, const char* field, double value, const char* rule) {
  if (!kept) throw std::invalid_argument(fmt::format("limits: {} = {:g}: must be {}", field, value, rule));
}

void require_convex(const Band& band) {
  const std::size_t count = band.outline_m.size();
  bool kept = count >= 3;
  for (std::size_t i = 0; kept && i < count; ++i) {
    const Eigen::Vector2d& from = band.outline_m[i];
    const Eigen::Vector2d edge = band.outline_m[(i + 1) % count] - from;
    const Eigen::Vector2d next = band.outline_m[(i + 2) % count] - from;
    // counter-clockwise, with the body's middle inside
    kept = from.allFinite() && edge.x() * next.y() - edge.y() * next.x() > 0.0 &&
           edge.y() * from.x() - edge.x() * from.y() > 0.0;
  }
  require(kept, "bands.outline_m of the band from_m", band.from_m,
          "a convex polygon, counter-clockwise, around the body's middle");
}

}  // namespace

double wrapped(double angle_rad) noexcept {
  const double turned = std::remainder(angle_rad, 2.0 * std::numbers::pi);
  return turned <= -std::numbers::pi ? turned + 2.0 * std::numbers::pi : turned;
}

Eigen::Vector2d Pose::point(const Eigen::Vector2d& local_m) const noexcept {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  return {x_m + c * local_m.x() - s * local_m.y(), y_m + s * local_m.x() + c * local_m.y()};
}

Pose Pose::compose(const Pose& local) const noexcept {
  const Eigen::Vector2d at = point({local.x_m, local.y_m});
  return {at.x(), at.y(), wrapped(yaw_rad + local.yaw_rad)};
}

Pose Pose::relative_of(const Pose& placed) const noexcept {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  const double dx = placed.x_m - x_m, dy = placed.y_m - y_m;
  return {c * dx + s * dy, c * dy - s * dx, wrapped(placed.yaw_rad - yaw_rad)};
}

Pose middle_of(const Pose& a, const Pose& b) noexcept {
  return {0.5 * (a.x_m + b.x_m), 0.5 * (a.y_m + b.y_m),
          wrapped(a.yaw_rad + 0.5 * wrapped(b.yaw_rad - a.yaw_rad))};
}

double way_m(const Pose& a, const Pose& b) noexcept {
  return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m);
}

double turn_rad(const Pose& a, const Pose& b) noexcept {
  return std::abs(wrapped(b.yaw_rad - a.yaw_rad));
}

void Limits::validate() const {
  require(sole.length_m > 0.0 && std::isfinite(sole.length_m), "sole.length_m", sole.length_m, "above 0");
  require(sole.width_m > 0.0 && std::isfinite(sole.width_m), "sole.width_m", sole.width_m, "above 0");
  require(std::abs(sole.centre_forward_m) < 0.5 * sole.length_m, "sole.centre_forward_m",
          sole.centre_forward_m, "so small that the sole lies below its origin");
  require(min_sole_gap_m >= 0.0, "min_sole_gap_m", min_sole_gap_m, "at least 0");
  require(foot_spacing_m >= sole.width_m + min_sole_gap_m - kRounding, "foot_spacing_m", foot_spacing_m,
          "at least the sole's width and min_sole_gap_m");
  require(max_foot_spacing_m >= foot_spacing_m && std::isfinite(max_foot_spacing_m), "max_foot_spacing_m",
          max_foot_spacing_m, "at least foot_spacing_m");
  require(max_step_forward_m > 0.0 && std::isfinite(max_step_forward_m), "max_step_forward_m",
          max_step_forward_m, "above 0");
  require(max_step_backward_m > 0.0 && std::isfinite(max_step_backward_m), "max_step_backward_m",
          max_step_backward_m, "above 0");
  require(max_step_turn_rad > 0.0 && max_step_turn_rad <= 1.0, "max_step_turn_rad", max_step_turn_rad,
          "above 0, at most 1");
  require(max_step_height_m >= 0.0, "max_step_height_m", max_step_height_m, "at least 0");
  require(sole_unevenness_m >= 0.0, "sole_unevenness_m", sole_unevenness_m, "at least 0");
  require(lift_m >= 0.0 && std::isfinite(lift_m), "lift_m", lift_m, "at least 0");
  require(clearance_m >= 0.0 && std::isfinite(clearance_m), "clearance_m", clearance_m, "at least 0");
  require(!bands.empty(), "bands", 0.0, "at least one");
  require(bands.front().from_m <= lift_m, "bands[0].from_m", bands.front().from_m, "at most lift_m");
  double above_m = 0.0;
  for (const Band& band : bands) {
    require(band.from_m >= above_m, "bands.from_m", band.from_m, "at least 0, in rising order");
    require_convex(band);
    above_m = band.from_m;
  }
  require(height_m > above_m && std::isfinite(height_m), "height_m", height_m, "above all bands' from_m");
}

double Limits::least_spacing_m(double outward_rad) const noexcept {
  const double toe_m = sole.centre_forward_m + 0.5 * sole.length_m;
  const double heel_m = sole.centre_forward_m - 0.5 * sole.length_m;
  const double outward = std::sin(outward_rad);  // toes turned outward: the heel comes in
  return 0.5 * sole.width_m * (1.0 + std::cos(outward_rad)) + std::max(-toe_m * outward, -heel_m * outward) +
         min_sole_gap_m;
}

double Limits::effort(const Pose& landing, Side swing) const noexcept {
  const double lateral_m = sign_of(swing) * landing.y_m;
  const double outward_rad = sign_of(swing) * landing.yaw_rad;
  const double least_m = least_spacing_m(outward_rad);
  const double ahead = landing.x_m / (landing.x_m >= 0.0 ? max_step_forward_m : max_step_backward_m);
  const double turn = landing.yaw_rad / max_step_turn_rad;
  if (lateral_m < least_m - kRounding || lateral_m > max_foot_spacing_m + kRounding) {
    return std::numeric_limits<double>::infinity();
  }
  const double wider_m = lateral_m - std::max(foot_spacing_m, least_m);
  const double side = wider_m <= kRounding ? 0.0 : wider_m / (max_foot_spacing_m - foot_spacing_m);
  return std::hypot(ahead, turn, side);
}

Pose Limits::beside(const Pose& stance, Side swing) const noexcept {
  return stance.compose({0.0, sign_of(swing) * foot_spacing_m, 0.0});
}

Pose Limits::middle_beside(const Pose& stance, Side stance_side) const noexcept {
  return stance.compose({0.0, -0.5 * sign_of(stance_side) * foot_spacing_m, 0.0});
}

Pose Limits::foot_of(const Pose& middle, Side side) const noexcept {
  return middle.compose({0.0, 0.5 * sign_of(side) * foot_spacing_m, 0.0});
}

}  // namespace gaitway::planning
