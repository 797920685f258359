// A planned motion: what is played point by point.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <string>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/motion.hpp"

namespace gaitway::motion {

// After the last point a plan stays where it is, for the lag of the servos to settle.
inline constexpr std::size_t kRestPoints = 4;

struct KeyTime {
  std::string name;
  std::size_t reached = 0, left = 0;  // indices of points
};

struct MotionPlan {
  std::string name;
  std::size_t joint_count = 0;
  std::vector<double> joint_rad = {};  // a row of joint_count angles for each point, facts::kSlot_s apart
  // What the servos are given, rows alike: leads the angles by what the planned torques take.
  std::vector<double> reference_rad = {};
  std::vector<Contact> contact = {};  // what stands at each point
  std::vector<Eigen::Isometry3d> pelvis =
      {};  // where the robot stands (or its contact is none): in the motion's frame
  std::vector<KeyTime> keys = {};

  [[nodiscard]] std::size_t point_count() const noexcept { return contact.size(); }
  [[nodiscard]] double duration_s() const noexcept {
    return contact.empty() ? 0.0 : static_cast<double>(contact.size() - 1) * facts::kSlot_s;
  }
  [[nodiscard]] std::span<const double> reference(std::size_t index) const noexcept {
    return std::span(reference_rad).subspan(index * joint_count, joint_count);
  }
  [[nodiscard]] std::span<const double> point(std::size_t index) const noexcept {
    return std::span(joint_rad).subspan(index * joint_count, joint_count);
  }
};

}  // namespace gaitway::motion
