// The leaves that trees may have, in words and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gaitway/behaviour/registry.hpp"

namespace gaitway::tools {

// In alphabetical order, each with its ports below it.
[[nodiscard]] std::string leaves_text(const behaviour::Registry& registry);
[[nodiscard]] nlohmann::json leaves_json(const behaviour::Registry& registry);

}  // namespace gaitway::tools
