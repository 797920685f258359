// Every order of the hip's and the ankle's joints is tried; the one whose axes lie best is the leg's.
#include "gaitway/urdf/leg_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

namespace gaitway::urdf {
namespace {

constexpr double kLeastCosine = 0.643;  // of 50 deg
constexpr std::array<std::string_view, 6> kNames{"hip yaw", "hip roll",    "hip pitch",
                                                 "knee",    "ankle pitch", "ankle roll"};

// The base axis that a joint is to turn about.
Eigen::Index base_axis_of(LegJoint which) noexcept {
  switch (which) {
    case LegJoint::hip_yaw:
      return 2;
    case LegJoint::hip_roll:
    case LegJoint::ankle_roll:
      return 0;
    default:
      return 1;
  }
}

}  // namespace

std::string_view leg_joint_name(LegJoint which) noexcept {
  return kNames[static_cast<std::size_t>(which)];
}

LegJoints::LegJoints(const RobotModel& model, const ForwardKinematics& home, Side side) {
  const Leg& leg = model.legs[index_of(side)];
  const auto cosine = [&](int joint, LegJoint which) {
    return std::abs(home.joint_axis(model, joint)[base_axis_of(which)]);
  };
  const auto assign = [&](std::span<const LegJoint> roles, std::size_t first) {
    const auto begin = leg.joints.begin() + static_cast<std::ptrdiff_t>(first);
    std::vector<int> order(begin,
                           begin + static_cast<std::ptrdiff_t>(roles.size()));  // ascends along the leg
    std::vector<int> best;
    double best_sum = -1.0;
    do {
      double sum = 0.0;
      for (std::size_t i = 0; i < roles.size(); ++i) sum += cosine(order[i], roles[i]);
      if (sum > best_sum) {
        best_sum = sum;
        best = order;
      }
    } while (std::next_permutation(order.begin(), order.end()));
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (cosine(best[i], roles[i]) < kLeastCosine) {
        throw std::invalid_argument(fmt::format(
            "the {} leg has no {} joint: none of its joints {} to {} turns about the base's {} axis in the "
            "home posture",
            side == Side::left ? "left" : "right", leg_joint_name(roles[i]), first + 1, first + roles.size(),
            std::string_view("xyz").substr(static_cast<std::size_t>(base_axis_of(roles[i])), 1)));
      }
      index_[static_cast<std::size_t>(roles[i])] = best[i];
    }
  };
  assign(std::array{LegJoint::hip_yaw, LegJoint::hip_roll, LegJoint::hip_pitch}, 0);
  assign(std::array{LegJoint::knee}, 3);
  assign(std::array{LegJoint::ankle_pitch, LegJoint::ankle_roll}, 4);
}

double slowest_leg_joint_rad_per_s(const RobotModel& model) noexcept {
  double slowest_rad_per_s = std::numeric_limits<double>::infinity();
  for (const Leg& leg : model.legs) {
    for (const int joint : leg.joints) {
      const double limit_rad_per_s = model.joints[static_cast<std::size_t>(joint)].velocity_limit_rad_per_s;
      if (limit_rad_per_s > 0.0) slowest_rad_per_s = std::min(slowest_rad_per_s, limit_rad_per_s);
    }
  }
  return slowest_rad_per_s;
}

}  // namespace gaitway::urdf
