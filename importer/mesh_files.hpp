// The files that a mesh's reader may open.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <array>
#include <filesystem>

namespace gaitway::importer {

// Regular files below the mesh's folder, or that of the file that it links to: what a mesh names besides
// itself may be a device, a pipe or anybody's.
class MeshFiles final : public Assimp::DefaultIOSystem {
 public:
  explicit MeshFiles(const std::filesystem::path& mesh);
  [[nodiscard]] bool Exists(const char* file) const override;
  Assimp::IOStream* Open(const char* file, const char* mode) override;

 private:
  std::array<std::filesystem::path, 2> folders_;
};

}  // namespace gaitway::importer
