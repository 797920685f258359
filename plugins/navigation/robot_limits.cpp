// Slices the robot's shapes into bands, and takes over the gait's numbers.
#include "gaitway/navigation/robot_limits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "gaitway/geometry/convex_hull.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::navigation {
namespace {

// On a body of humanoid22's size: `gaitway measure gait` has it walk over steps and tiles so high without
// knowing of them.
constexpr double kStepHeight_m = 0.010, kUnevenness_m = 0.006;
constexpr double kTracking_m = 0.010;   // of the swing foot's lift, which servos and the body's sway take
constexpr double kClearance_m = 0.030;  // sway to the sides, and the error of a walk
constexpr std::array kBandShares{0.0, 0.25, 0.5};  // of the height: legs, hips and hands, trunk and shoulders
constexpr double kCellPerSoleWidth = 0.118;

// The corners of one collision shape, in the frame of the soles' middle.
struct Part {
  std::array<Eigen::Vector3d, 8> corner_m;
  double lowest_m, highest_m;
};

std::vector<Part> parts_of(const urdf::RobotModel& robot) {
  const urdf::ForwardKinematics home(robot);
  const Eigen::Isometry3d left = home.sole_pose(urdf::Side::left), right = home.sole_pose(urdf::Side::right);
  Eigen::Isometry3d middle = left;
  middle.translation() = 0.5 * (left.translation() + right.translation());
  std::vector<Part> parts;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    for (const urdf::Shape& shape : robot.links[link].collision) {
      const Eigen::Isometry3d pose = middle.inverse() * home.link_pose(static_cast<int>(link)) * shape.pose;
      Part part{.corner_m = {}, .lowest_m = 1e9, .highest_m = -1e9};
      for (std::size_t i = 0; i < part.corner_m.size(); ++i) {
        const Eigen::Vector3d sign((i & 1U) != 0 ? 0.5 : -0.5, (i & 2U) != 0 ? 0.5 : -0.5,
                                   (i & 4U) != 0 ? 0.5 : -0.5);
        part.corner_m[i] = pose * Eigen::Vector3d(sign.cwiseProduct(shape.size_m));
        part.lowest_m = std::min(part.lowest_m, part.corner_m[i].z());
        part.highest_m = std::max(part.highest_m, part.corner_m[i].z());
      }
      parts.push_back(part);
    }
  }
  return parts;
}

// Of all parts that are somewhere between two heights, whole.
planning::Band band_of(const std::vector<Part>& parts, double from_m, double to_m) {
  constexpr std::size_t kMost = 4096;
  std::vector<Eigen::Vector2d> points;
  for (const Part& part : parts) {
    if (part.highest_m <= from_m || part.lowest_m >= to_m) continue;
    for (const Eigen::Vector3d& corner : part.corner_m) points.emplace_back(corner.head<2>());
  }
  const geometry::ConvexHull<Eigen::Vector2d, kMost> hull{std::span<const Eigen::Vector2d>(points)};
  return {from_m, {hull.corners().begin(), hull.corners().end()}};
}

}  // namespace

planning::Limits limits_of(const urdf::RobotModel& robot) {
  const trajectory::GaitParameters gait = trajectory::gait_of(robot);
  const double size = robot.body_scale().factor("m");
  planning::Limits limits{.sole = {gait.sole.length_m, gait.sole.width_m, gait.sole.centre_forward_m},
                          .foot_spacing_m = gait.foot_spacing_m,
                          .max_step_forward_m = gait.max_step_forward_m,
                          .max_step_backward_m = gait.max_step_backward_m,
                          .max_foot_spacing_m = gait.max_foot_spacing_m,
                          .max_step_turn_rad = gait.max_step_turn_rad,
                          .min_sole_gap_m = gait.min_sole_gap_m,
                          .max_step_height_m = kStepHeight_m * size,
                          .sole_unevenness_m = kUnevenness_m * size,
                          .lift_m = std::max(gait.lift_m - kTracking_m * size, 0.0),
                          .bands = {},
                          .height_m = 0.0,
                          .clearance_m = kClearance_m * size};
  const std::vector<Part> parts = parts_of(robot);
  for (const Part& part : parts) limits.height_m = std::max(limits.height_m, part.highest_m);
  for (std::size_t i = 0; i < kBandShares.size(); ++i) {
    const double from_m = std::max(kBandShares[i] * limits.height_m, limits.lift_m);
    const double to_m = i + 1 < kBandShares.size() ? kBandShares[i + 1] * limits.height_m : limits.height_m;
    planning::Band band = band_of(parts, from_m, to_m);
    if (band.outline_m.size() >= 3) limits.bands.push_back(std::move(band));
  }
  limits.validate();
  return limits;
}

double step_time_s(const urdf::RobotModel& robot) {
  return trajectory::gait_of(robot).step_time_s;
}

double cell_for(const planning::Limits& limits) {
  constexpr double kStep_m = 0.0005;
  return std::max(1.0, std::floor(kCellPerSoleWidth * limits.sole.width_m / kStep_m)) * kStep_m;
}

}  // namespace gaitway::navigation
