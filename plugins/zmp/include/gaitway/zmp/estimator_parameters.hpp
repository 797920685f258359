// Every number of the state estimate, with its unit, and the rules that these numbers must keep.
#pragma once

namespace gaitway::zmp {

struct EstimatorParameters {
  // Contact, in fractions of the body weight that one foot bears.
  double contact_on_share = 0.10;   // a foot is in contact from here
  double contact_off_share = 0.04;  // and out of contact below
  double support_margin = 0.10;  // the other foot becomes the support foot at 0.5 + margin of the whole load

  // Attitude.
  double tilt_time_constant_s = 0.5;  // roll and pitch follow the gyro in less, the inclinometer in more time
  double accelerometer_band_m_per_s2 =
      1.0;                     // without inclinometer: specific forces further from g are not used
  double rate_filter_s = 0.0;  // low-pass of the angular velocity; 0: none

  // Gyro bias, learned while standing still.
  double still_rate_rad_per_s = 0.05;        // gyro, each axis
  double still_joint_rate_rad_per_s = 0.25;  // leg joints
  double still_time_s = 0.5;                 // so long, before learning begins
  double bias_time_constant_s = 3.0;
  double bias_limit_rad_per_s = 0.05;

  // Noise densities of the filter of CoM position and velocity.
  double com_noise_m = 0.0005;                   // of the kinematics' CoM, one sample
  double acceleration_noise_m_per_s2 = 1.5;      // of the pendulum's acceleration, one sample
  double acceleration_drift_m_per_s2_rts = 1.5;  // of what it does not explain, per square root of a second

  // Inputs.
  double stale_after_s = 0.035;  // age from which a sensor's last value is only kept

  // Throws std::invalid_argument naming parameter, value, rule and remedy.
  void validate() const;
};

}  // namespace gaitway::zmp
