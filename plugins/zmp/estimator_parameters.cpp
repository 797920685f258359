// The parameters of the estimate as the configuration has them, and the rules that they keep.
#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {
namespace {

constexpr double kLeast = 1e-9, kMost = 1e6;  // of what must be positive
constexpr double kForever_s = 1e9;

}  // namespace

std::vector<NumberParameter> EstimatorParameters::numbers() {
  std::vector<NumberParameter> all{
      {contact_on_share, "contact_on_share", "1", 0.001, 0.499,
       "of the body weight, from which a foot is in contact"},
      {contact_off_share, "contact_off_share", "1", 0.0001, 0.499,
       "of the body weight, below which it is not any more"},
      {support_margin, "support_margin", "1", 0.0, 0.499,
       "the other foot becomes the support foot at 0.5 + this of the load"},
      {gyro_noise_rad_per_s, "gyro_noise", "rad/s", kLeast, kMost,
       "standard deviation of a sample, the mean over 10 ms"},
      {tilt_noise_rad, "tilt_noise", "rad", kLeast, kMost,
       "standard deviation of the sample of an inclinometer that tells roll and pitch"},
      {accelerometer_band_m_per_s2, "accelerometer_band", "m/s^2", kLeast, kMost,
       "with no such inclinometer: specific forces further from g are not used"},
      {rate_filter_s, "rate_filter", "s", 0.0, 1.0, "low-pass of the angular velocity; 0: none"},
      {bias_deviation_rad_per_s, "bias_deviation", "rad/s", kLeast, 0.3,
       "standard deviation of the gyro's bias"},
      {bias_lifetime_s, "bias_lifetime", "s", 1.0, kForever_s, "in which that bias forgets itself"},
      {bias_walk_rad_per_s_rts, "bias_walk", "rad/s/s^0.5", 0.0, 1.0,
       "how that bias walks about the axes that tilt"},
      {heading_noise_rad, "heading_noise", "rad", kLeast, kMost,
       "how far play lets trunk and feet turn unseen"},
      {creep_rad_rts, "creep", "rad/s^0.5", kLeast, kMost, "of standing feet, always"},
      {settling_creep_rad_rts, "settling_creep", "rad/s^0.5", 0.0, 1.0,
       "of feet that have just been planted"},
      {rattle_creep_rad_rts, "rattle_creep", "rad/s^0.5", 0.0, 1e3,
       "for the mean square of the load's change as a share of the weight"},
      {moved_creep_rts, "moved_creep", "s^0.5", 0.0, 1e3,
       "while the legs are moved, for the fastest joint's rate"},
      {planted_share, "planted_share", "1", 0.001, 0.499,
       "of the body weight on each foot, with which the feet stand"},
      {planted_time_s, "planted_time", "s", 0.0, 10.0, "for which they must bear it"},
      {settling_time_s, "settling_time", "s", 0.01, 60.0,
       "time constant with which planted feet come to rest"},
      {rattle_time_s, "rattle_time", "s", 0.01, 60.0, "in which the changes of their load are averaged"},
      {unheard_rate_rad_per_s, "unheard_rate", "rad/s", 0.0, 10.0,
       "how fast a walking trunk turns: what it did while its gyro was not heard"},
      {cell_noise_N, "cell_noise", "N", kLeast, kMost, "standard deviation of a force cell's sample"},
      {cell_gain_deviation, "cell_gain_deviation", "1", kLeast, 0.5,
       "standard deviation of a force cell's gain"},
      {cell_gain_lifetime_s, "cell_gain_lifetime", "s", 1.0, kForever_s, "in which a gain forgets itself"},
      {link_mass_deviation, "link_mass_deviation", "1", 0.0, 1.0,
       "standard deviation of each link's mass, as a share"},
      {trunk_com_deviation_m, "trunk_com_deviation", "m", 0.0, 0.1,
       "standard deviation of the trunk's CoM, each axis"},
      {joint_zero_deviation_rad, "joint_zero_deviation", "rad", 0.0, 0.2,
       "standard deviation of a joint's zero"},
      {tilt_zero_deviation_rad, "tilt_zero_deviation", "rad", 0.0, 0.2,
       "standard deviation of the IMU's roll and pitch, as it is mounted"},
      {com_noise_m, "com_noise", "m", kLeast, kMost, "of the kinematics' CoM, one sample"},
      {acceleration_noise_m_per_s2, "acceleration_noise", "m/s^2", kLeast, kMost,
       "of the pendulum's acceleration, one sample"},
      {acceleration_drift_m_per_s2_rts, "acceleration_drift", "m/s^2/s^0.5", kLeast, kMost,
       "of what the pendulum does not explain"},
      {com_offset_noise_m_rts, "com_offset_noise", "m*s^0.5", kLeast, kMost,
       "of the CoM over a foot, in the mean over a second"},
      {com_offset_drift_m_per_rts, "com_offset_drift", "m/s^0.5", kLeast, kMost,
       "of that offset, as the posture changes"},
      {slip_impact_s, "slip_impact", "s", 0.0, 1.0,
       "after touchdown, in which the sole rolls and strikes: no slip"},
      {slip_leak_s, "slip_leak", "s", 0.01, 10.0,
       "in which an integrated acceleration of a foot is forgotten"},
      {slip_offset_time_s, "slip_offset_time", "s", 0.1, 1e3,
       "in which a sole's tilt is learned that the kinematics does not know"},
      {stale_after_s, "stale_after", "s", kLeast, kMost, "age from which a sensor's last value is only kept",
       false, Scaling::none},
  };
  for (const NumberParameter& number : fall.numbers()) all.push_back(number);
  return all;
}

void EstimatorParameters::validate() const {
  EstimatorParameters copy = *this;
  require_in_range(copy.numbers());
  require_number(contact_off_share < contact_on_share, "contact_off_share", contact_off_share, "1",
                 "below contact_on_share");
}

}  // namespace gaitway::zmp
