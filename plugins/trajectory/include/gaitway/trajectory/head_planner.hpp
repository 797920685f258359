// Where the head looks, point by point: to a direction, to a place, or from side to side, within the neck's
// limits and without a jerk.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/neck.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

// Plans the field `head` of motion plans. Each axis goes to its goal by the time-optimal way that its speed
// and acceleration allow, and stops there without passing it.
class HeadPlanner {
 public:
  explicit HeadPlanner(const urdf::RobotModel& robot);

  // The newest command; one with another stamp begins.
  void obey(const HeadCommand& command) noexcept;
  // A safe tail has been played: the head is where the last plan's ends. Where a person has moved the neck
  // meanwhile, that is theirs, and no batch takes it back.
  void begin_after_tail() noexcept;
  // Another part of the plan moves the neck's joints, from where they are: nothing is added to it.
  void leave_to_others(MotionPlan& plan) noexcept;

  // Fills `plan.head` of batch and tail. `allowed`: false while a motion plays, for which the head goes back
  // ahead. `estimate`: where the robot is, for a place to look at; nullptr: not known, and the head stays.
  void plan(bool allowed, const Estimate* estimate, MotionPlan& plan) noexcept;

  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.command_, self.angle_rad_, self.speed_rad_per_s_, self.rest_rad_, self.scan_time_s_);
  }

 private:
  using Angles = std::array<double, 2>;  // yaw, pitch
  struct Axis {
    bool exists = false;
    double lowest_rad = 0.0, highest_rad = 0.0, most_rad_per_s = 0.0;
  };
  // Where it would come to rest.
  [[nodiscard]] Angles rest_rad(const Angles& angle_rad, const Angles& speed_rad_per_s) const noexcept;
  [[nodiscard]] Angles goal_rad(bool allowed, const Estimate* estimate, double hip_height_m,
                                double scan_time_s) const noexcept;
  [[nodiscard]] Angles towards_rad(const Estimate& estimate, double hip_height_m) const noexcept;
  void approach(const Angles& goal_rad, Angles& angle_rad, Angles& speed_rad_per_s) const noexcept;

  urdf::Neck neck_;
  double hip_above_base_m_ = 0.0;
  std::array<Axis, 2> axes_;
  double acceleration_rad_per_s2_ = 0.0, usual_scan_s_ = 0.0;
  HeadCommand command_{};
  Angles angle_rad_{}, speed_rad_per_s_{};  // at the end of the last batch
  Angles rest_rad_{};                       // at the end of its tail
  double scan_time_s_ = 0.0;                // since the scan began
};

}  // namespace gaitway::trajectory
