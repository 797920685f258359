// Every number of the state estimate, with its unit, and the rules that these numbers must keep.
#pragma once

#include <vector>

#include "gaitway/plugin/number_parameter.hpp"
#include "gaitway/zmp/fall_recognition.hpp"

namespace gaitway::zmp {

struct EstimatorParameters {
  // Contact, in fractions of the body weight that one foot bears.
  double contact_on_share = 0.10;   // a foot is in contact from here
  double contact_off_share = 0.04;  // and out of contact below
  double support_margin = 0.10;  // the other foot becomes the support foot at 0.5 + margin of the whole load

  // Attitude. Noise: standard deviation of one sample, the mean over 10 ms.
  double gyro_noise_rad_per_s = 0.0035;
  double tilt_noise_rad = 0.001;             // of an inclinometer that tells roll and pitch
  double accelerometer_band_m_per_s2 = 6.0;  // with none: specific forces further from g, of a
                                             // shock or a fall, are not used
  double rate_filter_s = 0.0;                // low-pass of the angular velocity; 0: none
  double bias_deviation_rad_per_s = 0.005;   // of the gyro's bias, each axis
  double bias_lifetime_s = 1e6;              // in which it forgets itself
  // How it walks about the axes that tilt, in the root of a second: more than such gyros do by themselves, so
  // that a bias which a knock or heat has made is learned within some seconds. About the vertical hardly
  // anything would tell it.
  double bias_walk_rad_per_s_rts = 0.0;
  // How far play lets trunk and feet turn unseen, some 0.002 rad. They stay so for tenths of a second, and a
  // hundred samples in a second know no more than a few of such times do: hence the larger number.
  double heading_noise_rad = 0.015;
  // How standing feet creep, per square root of a second: always; when they have just been planted; for a
  // load that rattles, times the mean square of its change as a share of the weight; and while the legs are
  // moved, times the fastest joint's rate.
  double creep_rad_rts = 0.0001;
  double settling_creep_rad_rts = 0.003;
  double rattle_creep_rad_rts = 1.5;
  double moved_creep_rts = 0.01;
  double planted_share = 0.2;  // of the body weight on each foot, for planted_time: the feet stand
  double planted_time_s = 0.2;
  double settling_time_s = 1.0;         // time constant with which feet come to rest
  double rattle_time_s = 0.5;           // in which the load's changes are averaged
  double unheard_rate_rad_per_s = 0.3;  // how fast a walking trunk turns: while its gyro is not heard

  // Force cells. Gains are factors; their lifetime is that in which a gain forgets itself.
  double cell_noise_N = 0.065;
  double cell_gain_deviation = 0.04;
  double cell_gain_lifetime_s = 1e6;

  // What the robot's description does not know, as standard deviations.
  double link_mass_deviation = 0.05;     // of each link, as a share
  double trunk_com_deviation_m = 0.005;  // each axis
  double joint_zero_deviation_rad = 0.007;
  double tilt_zero_deviation_rad = 0.0;  // of the IMU's roll and pitch, as it is mounted

  // Noise densities of the filter of CoM position and velocity.
  double com_noise_m = 0.0005;                   // of the kinematics' CoM, one sample
  double acceleration_noise_m_per_s2 = 1.5;      // of the pendulum's acceleration, one sample
  double acceleration_drift_m_per_s2_rts = 1.5;  // of what it does not explain, per square root of a second

  // Offset of the kinematics' CoM over a foot.
  double com_offset_noise_m_rts = 0.003;       // in the mean over a second
  double com_offset_drift_m_per_rts = 0.0005;  // as the posture changes

  // Slip.
  double slip_impact_s = 0.030;  // after touchdown the sole rolls and strikes: no slip
  double slip_leak_s = 0.15;     // in which an integrated acceleration is forgotten
  double slip_offset_time_s =
      2.0;  // in which the tilt of a sole is learned that the kinematics does not know

  FallParameters fall;

  // Inputs.
  double stale_after_s = 0.035;  // age from which a sensor's last value is only kept

  // As the configuration has them.
  [[nodiscard]] std::vector<NumberParameter> numbers();

  // Throws std::invalid_argument naming parameter, value, rule and remedy.
  void validate() const;
};

}  // namespace gaitway::zmp
