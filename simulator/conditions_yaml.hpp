// The conditions of a trial as a scenario writes them.
#pragma once

#include "gaitway/input/yaml_value.hpp"
#include "gaitway/simulator/conditions.hpp"

namespace gaitway::simulator {

// Throws input::InputError with file, line, field, value and rule.
[[nodiscard]] Conditions read_conditions(const input::YamlValue& value);

}  // namespace gaitway::simulator
