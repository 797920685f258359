// The rules that the parameters of the estimate keep.
#include "gaitway/zmp/estimator_parameters.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace gaitway::zmp {
namespace {

void require(bool holds, std::string_view name, double value, std::string_view rule) {
  if (!holds) {
    throw std::invalid_argument(
        fmt::format("{} is {}, but must be {}; change it in the plug-in's parameters", name, value, rule));
  }
}

void require_positive(std::string_view name, double value) {
  require(value > 0.0 && value < 1e6, name, value, "positive and finite");
}

}  // namespace

void EstimatorParameters::validate() const {
  require(contact_on_share > 0.0 && contact_on_share < 0.5, "contact_on_share", contact_on_share,
          "between 0 and 0.5");
  require(contact_off_share > 0.0 && contact_off_share < contact_on_share, "contact_off_share",
          contact_off_share, "positive and below contact_on_share");
  require(support_margin >= 0.0 && support_margin < 0.5, "support_margin", support_margin,
          "at least 0 and below 0.5");
  require_positive("gyro_noise_rad_per_s", gyro_noise_rad_per_s);
  require_positive("tilt_noise_rad", tilt_noise_rad);
  require_positive("accelerometer_band_m_per_s2", accelerometer_band_m_per_s2);
  require(rate_filter_s >= 0.0 && rate_filter_s < 1.0, "rate_filter_s", rate_filter_s,
          "at least 0 and below 1");
  require(bias_deviation_rad_per_s > 0.0 && bias_deviation_rad_per_s < 0.3, "bias_deviation_rad_per_s",
          bias_deviation_rad_per_s, "positive and below 0.3");
  require(bias_lifetime_s >= 1.0 && bias_lifetime_s <= 1e9, "bias_lifetime_s", bias_lifetime_s,
          "between 1 and 1e9");
  require_positive("heading_noise_rad", heading_noise_rad);
  require_positive("creep_rad_rts", creep_rad_rts);
  require(settling_creep_rad_rts >= 0.0 && settling_creep_rad_rts < 1.0, "settling_creep_rad_rts",
          settling_creep_rad_rts, "at least 0 and below 1");
  require(rattle_creep_rad_rts >= 0.0 && rattle_creep_rad_rts < 1e3, "rattle_creep_rad_rts",
          rattle_creep_rad_rts, "at least 0 and below 1000");
  require(moved_creep_rts >= 0.0 && moved_creep_rts < 1e3, "moved_creep_rts", moved_creep_rts,
          "at least 0 and below 1000");
  require(planted_share > 0.0 && planted_share < 0.5, "planted_share", planted_share, "between 0 and 0.5");
  require(planted_time_s >= 0.0 && planted_time_s < 10.0, "planted_time_s", planted_time_s,
          "at least 0 and below 10");
  require_positive("cell_noise_N", cell_noise_N);
  require(cell_gain_deviation > 0.0 && cell_gain_deviation < 0.5, "cell_gain_deviation", cell_gain_deviation,
          "between 0 and 0.5");
  require(cell_gain_lifetime_s >= 1.0 && cell_gain_lifetime_s <= 1e9, "cell_gain_lifetime_s",
          cell_gain_lifetime_s, "between 1 and 1e9");
  require(link_mass_deviation >= 0.0 && link_mass_deviation < 1.0, "link_mass_deviation", link_mass_deviation,
          "at least 0 and below 1");
  require(trunk_com_deviation_m >= 0.0 && trunk_com_deviation_m < 0.1, "trunk_com_deviation_m",
          trunk_com_deviation_m, "at least 0 and below 0.1");
  require(joint_zero_deviation_rad >= 0.0 && joint_zero_deviation_rad < 0.2, "joint_zero_deviation_rad",
          joint_zero_deviation_rad, "at least 0 and below 0.2");
  require_positive("com_noise_m", com_noise_m);
  require_positive("acceleration_noise_m_per_s2", acceleration_noise_m_per_s2);
  require_positive("acceleration_drift_m_per_s2_rts", acceleration_drift_m_per_s2_rts);
  require_positive("com_offset_noise_m_rts", com_offset_noise_m_rts);
  require_positive("com_offset_drift_m_per_rts", com_offset_drift_m_per_rts);
  require(slip_leak_s >= 0.01 && slip_leak_s <= 10.0, "slip_leak_s", slip_leak_s, "between 0.01 and 10");
  require(slip_offset_time_s >= 0.1 && slip_offset_time_s <= 1e3, "slip_offset_time_s", slip_offset_time_s,
          "between 0.1 and 1000");
  fall.validate();
  require_positive("stale_after_s", stale_after_s);
}

}  // namespace gaitway::zmp
