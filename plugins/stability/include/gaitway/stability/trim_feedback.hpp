// The trims of one tick: the gains of the robot's joints, and the shared law, faded in while it has ground to
// stand on and out when that is gone.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgclient/trim_law.hpp"
#include "gaitway/stability/balance_parameters.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/leg_joints.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability {

// Supports of a gain matrix, as in the topics.
inline constexpr std::size_t kLeftFoot = 0;
inline constexpr std::size_t kRightFoot = 1;
inline constexpr std::size_t kBothFeet = 2;

// A joint of a leg: its trim channel (-1: none), and its axis in base axes at the home posture.
struct TrimJoint {
  int channel = -1;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
};
[[nodiscard]] TrimJoint trim_joint(const urdf::RobotModel& model, const urdf::ForwardKinematics& home,
                                   int index);

// Which joint turns which way against a roll or pitch of the trunk.
//
// Signs: let a be a leg joint's unit axis, in base axes at the home posture. While the foot stands still,
// turning the joint by q turns all that is above it by -q about a. To turn the trunk by -k e against an error
// e about the unit vector u (roll: x, pitch: y) takes q = k e (a . u): so an axis along +y turns by +k for a
// trunk that is nose down, the toes press, the ZMP moves forward and pushes the trunk back; an axis along -y
// turns by -k. An axis that lies in between gets its share.
class TrimGainMatrix {
 public:
  // A leg joint without trim channel gets no gain; a trim channel of another joint gets zeros.
  explicit TrimGainMatrix(const urdf::RobotModel& model);

  // The standing robot's; what is handed over. No allocation, 0.1 us.
  [[nodiscard]] msgclient::TrimGains gains(const BalanceParameters& parameters) const noexcept;
  // Such a channel only helps while standing.
  [[nodiscard]] bool is_hip(std::size_t channel) const noexcept { return rows_[channel].is_hip; }

 private:
  struct Row {
    const JointGain BalanceParameters::*gain = nullptr;  // none: zeros
    std::size_t side = 0;
    bool is_hip = false;
    double about_roll = 0.0, about_pitch = 0.0;
  };
  std::uint32_t channel_count_ = 0;
  std::array<Row, kTrimChannels> rows_{};
};

// The trims of one tick: the shared law, faded in while it has ground to stand on and out when that is gone.
class TrimFeedback {
 public:
  TrimFeedback(const urdf::RobotModel& model, const BalanceParameters& parameters);

  // One tick. motion: of the trunk; none: trims fade from their last angles to zero. support: 0 left, 1
  // right, 2 both feet. Fills angles, reference and gains of `command`. The gains are the standing robot's (a
  // safe tail ends in a stand); the angles follow from them, but the hips come in only after some time on
  // both feet.
  void update(const std::optional<msgclient::TrunkMotion>& motion, std::size_t support,
              TrimCommand& command) noexcept;

  [[nodiscard]] double share() const noexcept { return share_; }  // 0 faded out .. 1 in full
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
