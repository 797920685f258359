// The files of a robot's folder, as they are.
#pragma once

#include <filesystem>
#include <string>

namespace gaitway::urdf {

// Throws RobotError, which names the file, when it cannot be read.
[[nodiscard]] std::string description_text(const std::filesystem::path& file);

}  // namespace gaitway::urdf
