// Every number of the balance feedback, with its unit, and the rules that these numbers must keep.
#pragma once

#include <array>
#include <vector>

#include "gaitway/plugin/number_parameter.hpp"
#include "gaitway/stability/fall_reaction.hpp"

namespace gaitway::stability {

// How far a joint turns for an error of the trunk's roll or pitch (whichever its axis can change). Positive:
// against the error.
struct JointGain {
  double angle_rad_per_rad = 0.0;
  double rate_rad_per_rad_per_s = 0.0;  // s
};

struct BalanceParameters {
  // Trims.
  JointGain ankle_pitch{0.25, 0.03};  // of the stance leg; with both feet on the ground, of both legs
  JointGain ankle_roll{0.25, 0.06};
  JointGain hip_pitch{0.15, 0.015};  // of both legs, while standing
  JointGain hip_roll{0.0, 0.0};
  std::array<double, 2> attitude_reference_rad{};  // trunk roll, pitch
  double trim_limit_rad = 0.11;                    // no further than the robot's own limit
  double ramp_s = 0.10;            // in which trims fade to zero when their ground is gone, and come back
  double standing_after_s = 0.15;  // of both feet on the ground: then the hips help
  double fallen_at_rad = 0.8;      // roll or pitch beyond which there is nothing to balance
  double airborne_after_s = 0.05;  // without contact of any foot
  double estimate_lifetime_s = 0.05;

  FallSoftness fall;

  // Heading, through the commanded turn rate.
  double heading_gain_per_s = 1.0;
  double heading_limit_rad_per_s = 0.30;
  double heading_filter_s = 0.20;  // low-pass of the heading's error: the trunk's yaw swings with every step

  // Speed, through the commanded velocity.
  double speed_filter_s = 2.0;  // several steps; 0: no feedback of the speed
  double speed_limit_m_per_s = 0.06;

  // Share of the trims' rate gains about the pitch axis while it stands calmly: all of them would have it
  // tremble in the play of its joints.
  double calm_damping = 0.67;
  // A push of 0.3 N*s turns humanoid22's trunk faster; the sway of a robot that has just begun to stand is
  // slower.
  double calm_rate_rad_per_s = 0.2;

  // Lean, through the batches' base attitude and CoM.
  double lean_gain_per_s = 1.5;           // while standing; 0: off
  double walking_lean_gain_per_s = 0.15;  // small: walking sways, and the batches answer late
  double lean_limit_rad = 0.17;

  // The standing CoM, through the batches.
  double centring_gain_per_s = 2.0;  // 0: off
  double centring_limit_m = 0.02;

  double centring_most_m = 0.005;  // of the CoM's error at a time: a body that is off by more is pushed
  double centring_calm_m = 0.020;  // of the DCM's: a body that is off by more is being caught

  // Soles, through constant trims of the ankles.
  double sole_gain_rad_per_m_s = 3.0;  // of what a centre of pressure is beside its place; 0: off
  double sole_limit_rad = 0.04;

  // Bow, of a robot that stands: see HipStrategy.
  double bow_beyond_m = 0.02;        // of the DCM from the soles' middle, forward or back
  double bow_sway_m = 0.015;         // of the DCM beyond the CoM, of a body that is not pushed
  double bow_gain_rad_per_m = 50.0;  // for what it is further; 0: off
  double bow_limit_rad = 0.6;
  double bow_speed_rad_per_s = 3.2;  // the hips turn twice as fast
  double bow_return_rad_per_s = 0.4;
  double bow_damping = 0.75;  // share of the trims' rate gains about the pitch axis while it bows

  // As the configuration has them.
  [[nodiscard]] std::vector<NumberParameter> numbers();

  // Throws std::invalid_argument naming parameter, value, rule and remedy.
  void validate() const;
};

}  // namespace gaitway::stability
