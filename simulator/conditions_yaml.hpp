// The conditions of a trial as a scenario writes them.
#pragma once

#include "gaitway/simulator/conditions.hpp"
#include "gaitway/urdf/yaml_value.hpp"

namespace gaitway::simulator {

// Throws urdf::RobotError with file, line, field, value and rule.
[[nodiscard]] Conditions read_conditions(const urdf::YamlValue& value);

}  // namespace gaitway::simulator
