// The leaves that trees are checked against: the shipped ones, and those of libraries.
#pragma once

#include <filesystem>
#include <vector>

#include "gaitway/behaviour/registry.hpp"

namespace gaitway::tools {

// Throws std::invalid_argument, naming the library and what is wrong with it. Libraries stay loaded.
[[nodiscard]] behaviour::Registry registry_with(const std::vector<std::filesystem::path>& libraries);

}  // namespace gaitway::tools
