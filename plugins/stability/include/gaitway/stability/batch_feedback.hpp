// The slow feedbacks, which reach the robot through its batches: heading, speed, lean, and the standing CoM.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>

#include "gaitway/stability/balance_parameters.hpp"

namespace gaitway::stability {

// Keeps the robot's heading at what was commanded, by a small turn rate beside the commanded one.
// The plan's own heading contains the corrections made so far, so it is no reference: a correction would move
// its own goal. The reference is the plan's `commanded_yaw`; turn rate = gain * (commanded - measured).
class HeadingFeedback {
 public:
  explicit HeadingFeedback(const BalanceParameters& parameters) noexcept : parameters_(parameters) {}

  // One tick. measured: integrated yaw of the trunk; commanded: the plan's at the same time. Returns the turn
  // rate to add, rad/s, counter-clockwise; zero unless walking, when a correction would change nothing.
  double update(double measured_yaw_rad, double commanded_yaw_rad, bool walking) noexcept;
  // A tick without estimate or plan: no correction, and the next tick's headings count as equal but for the
  // error so far.
  void pause() noexcept { last_difference_rad_.reset(); }

  [[nodiscard]] double error_rad() const noexcept { return error_rad_; }  // filtered

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.last_difference_rad_, self.strayed_rad_, self.error_rad_);
  }

 private:
  const BalanceParameters& parameters_;
  std::optional<double> last_difference_rad_;  // measured - commanded
  double strayed_rad_ = 0.0;                   // the same since the start, without the plan's jumps
  double error_rad_ = 0.0;
};

// Keeps the robot's speed at what was commanded: it walks somewhat faster than its plan says, since the
// ankles' trims carry the body on over the stance foot.
// The plan contains the offset, so planned minus measured speed, averaged over some steps, is by how much the
// robot goes slower than it is told: that is what the command must be raised by.
class SpeedFeedback {
 public:
  explicit SpeedFeedback(const BalanceParameters& parameters) noexcept : parameters_(parameters) {}

  // One tick; CoM velocities forward and left of the base, of the plan at this time and estimated. Returns
  // the offset of the commanded velocity; while the robot does not walk it fades.
  Eigen::Vector2d update(const Eigen::Vector2d& planned_m_per_s, const Eigen::Vector2d& estimated_m_per_s,
                         bool walking) noexcept;
  void pause() noexcept { update(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), false); }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.offset_m_per_s_);
  }

 private:
  const BalanceParameters& parameters_;
  Eigen::Vector2d offset_m_per_s_ = Eigen::Vector2d::Zero();
};

// Takes out a lasting lean of the trunk (a slope, joint zeros), slowly, through the batches: the base is
// turned back upright, and the CoM goes where it would be if the whole body had been turned about the ground
// below it.
class LeanIntegrator {
 public:
  // com_height_m: of the CoM above the ground.
  LeanIntegrator(const BalanceParameters& parameters, double com_height_m) noexcept
      : parameters_(parameters), com_height_m_(com_height_m) {}

  // One tick with the trunk's measured roll and pitch, rad.
  void update(double roll_rad, double pitch_rad, bool walking) noexcept;
  // One tick without: what was learned fades away in some seconds.
  void fade() noexcept;

  // Roll, pitch to add to the base's attitude: against the lean.
  [[nodiscard]] const std::array<double, 2>& offset_rad() const noexcept { return offset_rad_; }

  // To add to the planned CoM, base axes: plans place it along the ground's normal above the feet, balance
  // asks for the vertical.
  [[nodiscard]] std::array<double, 2> com_offset_m() const noexcept {
    return {com_height_m_ * std::sin(offset_rad_[1]), -com_height_m_ * std::sin(offset_rad_[0])};
  }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.offset_rad_);
  }

 private:
  const BalanceParameters& parameters_;
  double com_height_m_;
  std::array<double, 2> offset_rad_{};
};

// Brings the CoM of a standing robot to where it is planned.
// A trunk that is heavier in front than its description says, and joints whose zeros are wrong, leave the CoM
// a centimetre off its place: a sixth of the way to the toes. The estimate learns that from the force cells;
// while the robot stands calmly, the CoM is brought to where the plan has it, and what that takes is added to
// all batches, also in the walk that follows.
class ComCentring {
 public:
  explicit ComCentring(const BalanceParameters& parameters) noexcept : parameters_(parameters) {}

  // One tick of a calm stand on both feet: the estimated CoM and DCM less the planned CoM, base axes.
  // Learns nothing while the body is being caught, and from what is not finite.
  void learn(const Eigen::Vector2d& com_error_m, const Eigen::Vector2d& dcm_error_m) noexcept;

  // To add to the planned CoM, base axes.
  [[nodiscard]] const Eigen::Vector2d& offset_m() const noexcept { return offset_m_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.offset_m_);
  }

 private:
  const BalanceParameters& parameters_;
  Eigen::Vector2d offset_m_ = Eigen::Vector2d::Zero();
};

}  // namespace gaitway::stability
