// Tells files below a folder from others by where links lead.
#include "mesh_files.hpp"

#include <algorithm>
#include <system_error>

namespace gaitway::importer {

MeshFiles::MeshFiles(const std::filesystem::path& mesh)
    : folders_{std::filesystem::canonical(std::filesystem::absolute(mesh).parent_path()),
               std::filesystem::canonical(mesh).parent_path()} {}

bool MeshFiles::Exists(const char* file) const {
  std::error_code unreadable;
  const std::filesystem::path real = std::filesystem::canonical(file, unreadable);
  return !unreadable && std::filesystem::is_regular_file(real, unreadable) &&
         std::ranges::any_of(folders_, [&](const std::filesystem::path& folder) {
           return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
         });
}

Assimp::IOStream* MeshFiles::Open(const char* file, const char* mode) {
  return Exists(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
}

}  // namespace gaitway::importer
