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
struct TrimGainMatrix {
  msgclient::TrimGains gains;      // the standing robot's; what is handed over
  std::uint32_t hip_channels = 0;  // bit c: channel c is a hip joint, which only helps while standing
};

// A leg joint without trim channel gets no gain; a trim channel of another joint gets zeros.
[[nodiscard]] TrimGainMatrix make_trim_gain_matrix(const urdf::RobotModel& model,
                                                   const BalanceParameters& parameters);

}  // namespace gaitway::stability
