// A walking pattern and what it is told, planned batch by batch: the fixture of its tests. And the geometry
// of a plan's points, as they judge it: soles as rectangles, support polygons, distances.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/convex_hull.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"

namespace gaitway::trajectory {

using facts::kCycle_ns;

class PlannedWalk : public ::testing::Test {
 protected:
  // Plans so many batches of 80 ms.
  void run(int cycles, const Eigen::Vector2d& deviation_m = Eigen::Vector2d::Zero()) {
    for (int i = 0; i < cycles; ++i) {
      ++sequence;
      pattern.plan(sequence, sequence * kCycle_ns, command, correction, *plan, deviation_m);
    }
  }
  void command_walk(double forward, double left, double turn) {
    command.walk = 1;
    command.velocity[0] = forward;
    command.velocity[1] = left;
    command.turn_rate = turn;
  }

  GaitParameters parameters;
  WalkingPattern pattern{parameters};
  WalkCommand command{};
  Correction correction{};
  std::unique_ptr<MotionPlan> plan = std::make_unique<MotionPlan>();
  std::uint32_t sequence = 0;
};

inline std::array<Eigen::Vector2d, 4> sole_corners(const MotionPlan& plan, std::size_t i, std::size_t side,
                                                   const Sole& sole) {
  const double yaw = plan.foot_yaw[i][side];
  const Eigen::Vector2d x(std::cos(yaw), std::sin(yaw)), y(-x.y(), x.x());
  const Eigen::Vector2d origin(plan.foot_position[i][side][0], plan.foot_position[i][side][1]);
  const double toe = sole.centre_forward_m + 0.5 * sole.length_m,
               heel = sole.centre_forward_m - 0.5 * sole.length_m;
  const double half = 0.5 * sole.width_m;
  return {origin + toe * x + half * y, origin + heel * x + half * y, origin + heel * x - half * y,
          origin + toe * x - half * y};
}

// How deep the plan's ZMP lies in the support polygon of point i.
inline double zmp_depth_m(const MotionPlan& plan, std::size_t i, const Sole& sole) {
  std::vector<Eigen::Vector2d> corners;
  for (std::size_t side = 0; side < 2; ++side) {
    if (plan.support[i] != 2 && plan.support[i] != side) continue;
    for (const auto& corner : sole_corners(plan, i, side, sole)) corners.push_back(corner);
  }
  return geometry::ConvexHull<>(corners).margin_m({plan.zmp[i][0], plan.zmp[i][1]});
}

// Clear distance of the soles' rectangles along the best separating edge; negative: they overlap.
inline double sole_gap_m(const MotionPlan& plan, std::size_t i, const Sole& sole) {
  const auto left = sole_corners(plan, i, 0, sole), right = sole_corners(plan, i, 1, sole);
  double gap = -std::numeric_limits<double>::infinity();
  const auto separate = [&gap](const auto& a, const auto& b) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Vector2d edge = a[(k + 1) % 4] - a[k];
      const Eigen::Vector2d outward = Eigen::Vector2d(edge.y(), -edge.x()).normalized();
      double sign = 1.0;
      if (outward.dot(a[(k + 2) % 4] - a[k]) > 0.0) sign = -1.0;
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& corner : b) nearest = std::min(nearest, sign * outward.dot(corner - a[k]));
      gap = std::max(gap, nearest);
    }
  };
  separate(left, right);
  separate(right, left);
  return gap;
}

inline Eigen::Vector2d com_of(const MotionPlan& plan, std::size_t i) {
  return {plan.com[i][0], plan.com[i][1]};
}
inline Eigen::Vector2d com_velocity_of(const MotionPlan& plan, std::size_t i) {
  return {plan.com_velocity[i][0], plan.com_velocity[i][1]};
}
inline Eigen::Vector2d zmp_of(const MotionPlan& plan, std::size_t i) {
  return {plan.zmp[i][0], plan.zmp[i][1]};
}
inline Eigen::Vector3d foot_of(const MotionPlan& plan, std::size_t i, std::size_t side) {
  return {plan.foot_position[i][side][0], plan.foot_position[i][side][1], plan.foot_position[i][side][2]};
}

// Copies point `from` of one plan to point `to` of another.
inline void copy_point(const MotionPlan& source, std::size_t from, MotionPlan& target, std::size_t to) {
  for (std::size_t a = 0; a < 2; ++a) {
    target.com[to][a] = source.com[from][a];
    target.com_velocity[to][a] = source.com_velocity[from][a];
    target.zmp[to][a] = source.zmp[from][a];
    target.foot_yaw[to][a] = source.foot_yaw[from][a];
    for (std::size_t k = 0; k < 3; ++k) target.foot_position[to][a][k] = source.foot_position[from][a][k];
  }
  target.base_yaw[to] = source.base_yaw[from];
  target.hip_height[to] = source.hip_height[from];
  target.support[to] = source.support[from];
}

}  // namespace gaitway::trajectory
