// The names of what posture_errors() returns, in its order.
#pragma once

#include <array>
#include <string_view>

#include "tools/calibrate/calibration_estimator.hpp"

namespace gaitway::calibration {

inline constexpr std::size_t kPostureErrors = 10;

struct NamedQuantity {
  std::string_view name, unit;
};

[[nodiscard]] const std::array<NamedQuantity, kPostureErrors>& posture_quantities();

}  // namespace gaitway::calibration
