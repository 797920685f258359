// Where a command puts its results.
#pragma once

#include <filesystem>

namespace gaitway::tools {

// The folder is there and a file can be made in it. Throws std::invalid_argument, to be called before
// anything moves.
void prepare_output(const std::filesystem::path& folder);

}  // namespace gaitway::tools
