// From what an import found to the folder that is kept.
#pragma once

#include <filesystem>
#include <string>

#include "gaitway/importer/import.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

struct BroughtRobot {
  importer::ImportedRobot imported;
  urdf::RobotModel robot;  // as the folder is read
  std::string bus;         // what the proof of its bus says
};

// Writes the robot's folder: with the stand from which it walks fastest, and as many joints as the bus is
// proven for, those that carry most. What `folder` held is gone. Throws urdf::RobotError,
// std::filesystem::filesystem_error, std::system_error.
[[nodiscard]] BroughtRobot bring_robot(importer::ImportedRobot imported, const std::filesystem::path& folder);

}  // namespace gaitway::tools
