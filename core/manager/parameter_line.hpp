// A parameter as a line of JSON, for those who are not in this process.
#pragma once

#include <cstddef>
#include <string>

#include "gaitway/manager/parameter_set.hpp"

namespace gaitway::core {

// {"name", "value", "unit", "doc", "live", "lowest", "highest"}: value as text; limits null where there are
// none, or where they have no meaning. At most `most_bytes`: its doc is shortened, and then its value. Throws
// PluginError where that is not enough.
[[nodiscard]] std::string parameter_line(const Parameter& parameter, std::size_t most_bytes);

}  // namespace gaitway::core
