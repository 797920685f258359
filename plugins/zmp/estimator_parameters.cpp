// The parameters of the estimate as the configuration has them, and the rules that they keep.
#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {
namespace {

constexpr double kLeast = 1e-9, kMost = 1e6;  // of what must be positive
constexpr double kForever_s = 1e9;

}  // namespace

std::vector<NumberParameter> EstimatorParameters::numbers() {
  std::vector<NumberParameter> all{
      {contact_on_share, "contact_on_share", "1", 0.001, 0.499},
      {contact_off_share, "contact_off_share", "1", 0.0001, 0.499},
      {support_margin, "support_margin", "1", 0.0, 0.499},
      {gyro_noise_rad_per_s, "gyro_noise", "rad/s", kLeast, kMost},
      {tilt_noise_rad, "tilt_noise", "rad", kLeast, kMost},
      {accelerometer_band_m_per_s2, "accelerometer_band", "m/s^2", kLeast, kMost},
      {rate_filter_s, "rate_filter", "s", 0.0, 1.0},
      {bias_deviation_rad_per_s, "bias_deviation", "rad/s", kLeast, 0.3},
      {bias_lifetime_s, "bias_lifetime", "s", 1.0, kForever_s},
      {heading_noise_rad, "heading_noise", "rad", kLeast, kMost},
      {creep_rad_rts, "creep", "rad/s^0.5", kLeast, kMost},
      {settling_creep_rad_rts, "settling_creep", "rad/s^0.5", 0.0, 1.0},
      {rattle_creep_rad_rts, "rattle_creep", "rad/s^0.5", 0.0, 1e3},
      {moved_creep_rts, "moved_creep", "s^0.5", 0.0, 1e3},
      {planted_share, "planted_share", "1", 0.001, 0.499},
      {planted_time_s, "planted_time", "s", 0.0, 10.0},
      {cell_noise_N, "cell_noise", "N", kLeast, kMost},
      {cell_gain_deviation, "cell_gain_deviation", "1", kLeast, 0.5},
      {cell_gain_lifetime_s, "cell_gain_lifetime", "s", 1.0, kForever_s},
      {link_mass_deviation, "link_mass_deviation", "1", 0.0, 1.0},
      {trunk_com_deviation_m, "trunk_com_deviation", "m", 0.0, 0.1},
      {joint_zero_deviation_rad, "joint_zero_deviation", "rad", 0.0, 0.2},
      {com_noise_m, "com_noise", "m", kLeast, kMost},
      {acceleration_noise_m_per_s2, "acceleration_noise", "m/s^2", kLeast, kMost},
      {acceleration_drift_m_per_s2_rts, "acceleration_drift", "m/s^2/s^0.5", kLeast, kMost},
      {com_offset_noise_m_rts, "com_offset_noise", "m*s^0.5", kLeast, kMost},
      {com_offset_drift_m_per_rts, "com_offset_drift", "m/s^0.5", kLeast, kMost},
      {slip_leak_s, "slip_leak", "s", 0.01, 10.0},
      {slip_offset_time_s, "slip_offset_time", "s", 0.1, 1e3},
      {stale_after_s, "stale_after", "s", kLeast, kMost},
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
