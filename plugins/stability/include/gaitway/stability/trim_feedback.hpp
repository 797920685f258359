// The trims of one tick: the shared law, faded in while it has ground to stand on and out when that is gone.
#pragma once

#include <array>
#include <optional>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgclient/trim_law.hpp"
#include "gaitway/stability/balance_parameters.hpp"
#include "gaitway/stability/trim_gain_matrix.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability {

class TrimFeedback {
 public:
  TrimFeedback(const urdf::RobotModel& model, const BalanceParameters& parameters);

  // One tick. motion: of the trunk; none: trims fade from their last angles to zero. support: 0 left, 1
  // right, 2 both feet. Fills angles, reference and gains of `command`. The gains are the standing robot's (a
  // safe tail ends in a stand); the angles follow from them, but the hips come in only after some time on
  // both feet.
  void update(const std::optional<msgclient::TrunkMotion>& motion, std::size_t support,
              TrimCommand& command) noexcept;

  [[nodiscard]] double share() const noexcept { return share_; }          // 0 faded out .. 1 in full
  [[nodiscard]] double hip_share() const noexcept { return hip_share_; }  // likewise, of the hips
  [[nodiscard]] double limit_rad() const noexcept;  // of the robot and of the parameters, the smaller one

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.standing_s_, self.share_, self.hip_share_, self.law_rad_);
  }

 private:
  void update_hip_share(bool both_feet) noexcept;
  [[nodiscard]] double ramp_step() const noexcept;  // of a share in one tick

  const BalanceParameters& parameters_;
  double robot_limit_rad_;
  TrimGainMatrix matrix_;
  double standing_s_ = 0.0;
  double share_ = 0.0;
  double hip_share_ = 0.0;
  std::array<double, kTrimChannels> law_rad_{};  // newest angles of the law, before fading
};

}  // namespace gaitway::stability
