// A maker's description in a folder of its own.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "gaitway/importer/maker_robot.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/process/private_folder.hpp"

namespace gaitway::importer::test {

class MakerFolder {
 public:
  // Any file in it; folders on the way are made.
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    const std::filesystem::path file = folder_.path() / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
    return file;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }

  [[nodiscard]] MakerRobot read(const std::string& urdf, const ReadOptions& options = {}) const {
    return read_maker_urdf(write("robot.urdf", urdf), options);
  }
  // <robot name="r"> around that.
  [[nodiscard]] MakerRobot read_robot(const std::string& elements, const ReadOptions& options = {}) const {
    return read("<robot name=\"r\">\n" + elements + "\n</robot>\n", options);
  }

  // What read() says of it.
  [[nodiscard]] std::string complaint(const std::string& urdf) const {
    try {
      (void)read(urdf);
    } catch (const input::InputError& error) {
      return error.what();
    }
    return "(read without complaint)";
  }

 private:
  process::PrivateFolder folder_{"gaitway-maker"};
};

inline std::string link(const std::string& name, const std::string& elements = "") {
  return "<link name=\"" + name + "\">" + elements + "</link>\n";
}

inline std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                         const std::string& child, const std::string& elements = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + elements + "</joint>\n";
}

inline std::string mass(double mass_kg) {
  return "<inertial><mass value=\"" + std::to_string(mass_kg) +
         "\"/><inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" izz=\"0.1\"/></inertial>";
}

}  // namespace gaitway::importer::test
