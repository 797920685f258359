// Keeps the robot's heading at what was commanded, by a small turn rate beside the commanded one.
#pragma once

#include <optional>

#include "gaitway/stability/balance_parameters.hpp"

namespace gaitway::stability {

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

}  // namespace gaitway::stability
