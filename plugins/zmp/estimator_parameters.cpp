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
  require_positive("tilt_time_constant_s", tilt_time_constant_s);
  require_positive("accelerometer_band_m_per_s2", accelerometer_band_m_per_s2);
  require(rate_filter_s >= 0.0 && rate_filter_s < 1.0, "rate_filter_s", rate_filter_s,
          "at least 0 and below 1");
  require_positive("still_rate_rad_per_s", still_rate_rad_per_s);
  require_positive("still_joint_rate_rad_per_s", still_joint_rate_rad_per_s);
  require_positive("still_time_s", still_time_s);
  require_positive("bias_time_constant_s", bias_time_constant_s);
  require_positive("bias_limit_rad_per_s", bias_limit_rad_per_s);
  require_positive("com_noise_m", com_noise_m);
  require_positive("acceleration_noise_m_per_s2", acceleration_noise_m_per_s2);
  require_positive("acceleration_drift_m_per_s2_rts", acceleration_drift_m_per_s2_rts);
  require_positive("stale_after_s", stale_after_s);
}

}  // namespace gaitway::zmp
