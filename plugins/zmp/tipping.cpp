// The inverted pendulum over each edge of the soles' convex hull.
#include "gaitway/zmp/tipping.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/convex_hull.hpp"

namespace gaitway::zmp {
namespace {

using facts::kGravity_m_per_s2;
constexpr double kLowestCom_m = 0.05;  // above the edge: below, the pendulum says nothing
constexpr double kShortestEdge_m = 1e-4;
constexpr double kLongestFall_s = 2.0;

struct Pendulum {
  double tilt_rad = 0.0;  // from the vertical above the edge, outwards
  double rate_rad_per_s = 0.0;
  double omega2_per_s2 = 0.0;

  [[nodiscard]] double state() const noexcept {
    return 2.0 * std::sin(0.5 * tilt_rad) + rate_rad_per_s / std::sqrt(omega2_per_s2);
  }
};

Pendulum pendulum_over(const Eigen::Vector3d& edge, const Eigen::Vector2d& outwards, const BodyOverFeet& body,
                       const TippingModel& model) noexcept {
  const Eigen::Vector3d arm = body.com_m - edge;
  const double out = outwards.dot(arm.head<2>());
  const double up = std::max(arm.z(), kLowestCom_m);
  const double speed_out = outwards.dot(body.com_velocity_m_per_s.head<2>());
  const double length2 = out * out + up * up;
  return {.tilt_rad = std::atan2(out, up),
          .rate_rad_per_s = (speed_out * up - body.com_velocity_m_per_s.z() * out) / length2,
          .omega2_per_s2 = kGravity_m_per_s2 / (std::sqrt(length2) * model.inertia_factor)};
}

double time_to_impact_s(Pendulum pendulum, const TippingModel& model) noexcept {
  double time_s = 0.0;
  for (; pendulum.tilt_rad < model.impact_tilt_rad; time_s += facts::kSlot_s) {
    if (time_s >= kLongestFall_s) return kNoImpact_s;
    pendulum.rate_rad_per_s += facts::kSlot_s * pendulum.omega2_per_s2 * std::sin(pendulum.tilt_rad);
    pendulum.tilt_rad += facts::kSlot_s * pendulum.rate_rad_per_s;
  }
  return time_s;
}

}  // namespace

Tipping tipping_of(const BodyOverFeet& body, const TippingModel& model) noexcept {
  std::array<Eigen::Vector3d, 8> soles;
  for (std::size_t i = 0; i < soles.size(); ++i) soles[i] = body.sole_corner_m[i / 4][i % 4];
  const geometry::ConvexHull<Eigen::Vector3d> hull{soles};
  const std::span<const Eigen::Vector3d> corners = hull.corners();
  Tipping worst;
  worst.state = -std::numeric_limits<double>::infinity();
  worst.time_to_impact_s = kNoImpact_s;
  Pendulum falling;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& from = corners[i];
    const Eigen::Vector3d& to = corners[(i + 1) % corners.size()];
    const Eigen::Vector2d along = (to - from).head<2>();
    const double length_m = along.norm();
    if (!(length_m > kShortestEdge_m)) continue;
    const Eigen::Vector2d outwards = Eigen::Vector2d(along.y(), -along.x()) / length_m;
    // Of a tilted sole the lower end of the edge is the one that touches the ground.
    const Pendulum pendulum = pendulum_over(from.z() < to.z() ? from : to, outwards, body, model);
    if (pendulum.state() > worst.state) {
      worst.state = pendulum.state();
      worst.direction = outwards;
      falling = pendulum;
    }
  }
  if (worst.state > 0.0) worst.time_to_impact_s = time_to_impact_s(falling, model);
  return worst;
}

}  // namespace gaitway::zmp
