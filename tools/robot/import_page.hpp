// What an import found, as a text for the terminal and as a page with a picture.
#pragma once

#include <filesystem>
#include <string>

#include "gaitway/importer/import.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

struct ImportSummary {
  const importer::ImportedRobot& imported;
  const urdf::RobotModel& robot;  // as its new folder is read
  std::string bus;                // what the proof of its bus says
};

[[nodiscard]] std::string import_text(const ImportSummary& summary);

// The same robot for a picture: colours too dark to see its shape are mixed with white, as much as they need.
[[nodiscard]] urdf::RobotModel with_visible_colours(urdf::RobotModel robot);

// Writes robot.png, the robot in its home posture, and import.html. Without OpenGL the page has no picture,
// and the function returns why; empty otherwise. Throws std::runtime_error for a file that can't be written.
std::string write_import_page(const ImportSummary& summary, const std::filesystem::path& folder);

}  // namespace gaitway::tools
