// Where the meshes lie that a URDF names.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/importer/maker_robot.hpp"

namespace gaitway::importer {

class MeshPlaces {
 public:
  MeshPlaces(const std::filesystem::path& urdf, const ReadOptions& options);

  // The file behind package://NAME/rest, model://NAME/rest, file:///path, an absolute path or one from the
  // URDF's folder; nothing where there is none.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& uri) const;

 private:
  std::filesystem::path urdf_folder_;
  std::vector<std::filesystem::path> package_folders_;
};

}  // namespace gaitway::importer
