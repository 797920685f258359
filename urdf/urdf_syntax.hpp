// What stands where in a URDF: urdfdom itself neither tells lines nor minds misspelt elements.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace gaitway::urdf {

// Lines (from 1) of the elements of a URDF, by name.
struct UrdfLines {
  std::map<std::string, int> link;
  std::map<std::string, int> joint;
};

// Checks that the text is well-formed XML and holds nothing but what this loader understands: known elements
// and attributes, numbers where numbers belong, each link and joint name once. Throws RobotError with the
// line.
[[nodiscard]] UrdfLines check_urdf_syntax(const std::filesystem::path& file, const std::string& text);

}  // namespace gaitway::urdf
