// Limits of the robot API from a file, in place of the shipped ones.
#pragma once

#include <filesystem>

#include "gaitway/api/limits.hpp"

namespace gaitway::api {

// YAML: a limit's name and its value, in the unit of its row. Throws input::InputError, which names file,
// line, value and rule.
[[nodiscard]] Limits read_limits(const std::filesystem::path& file);

}  // namespace gaitway::api
