// The gain matrix of the trims for one robot: which joint turns which way against a roll or pitch of the
// trunk.
#pragma once

#include <array>
#include <cstdint>

#include "gaitway/msgclient/trim_law.hpp"
#include "gaitway/stability/balance_parameters.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability {

// Supports of a gain matrix, as in the topics.
inline constexpr std::size_t kLeftFoot = 0;
inline constexpr std::size_t kRightFoot = 1;
inline constexpr std::size_t kBothFeet = 2;

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

}  // namespace gaitway::stability
