// Looks for meshes in packages, in the folders above the URDF and beside it.
#include "mesh_places.hpp"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <sstream>
#include <string_view>

namespace gaitway::importer {
namespace {

std::vector<std::filesystem::path> folders_of_environment(const char* variable) {
  std::vector<std::filesystem::path> result;
  const char* const value = std::getenv(variable);
  std::istringstream folders(value ? value : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (!folder.empty()) {
      result.emplace_back(folder);
    }
  }
  return result;
}

bool is_file(const std::filesystem::path& path) {
  std::error_code unreadable;
  return std::filesystem::is_regular_file(path, unreadable);
}

// Without what stands before the path; nothing for another kind of place.
std::optional<std::string> without_scheme(const std::string& uri,
                                          std::initializer_list<const char*> schemes) {
  for (const std::string_view scheme : schemes) {
    if (uri.starts_with(scheme)) {
      return uri.substr(scheme.size());
    }
  }
  return std::nullopt;
}

std::string without_slashes(const std::string& path) {
  return path.substr(std::min(path.find_first_not_of('/'), path.size()));
}

}  // namespace

MeshPlaces::MeshPlaces(const std::filesystem::path& urdf, const ReadOptions& options)
    : urdf_folder_(std::filesystem::absolute(urdf).lexically_normal().parent_path()),
      package_folders_(options.package_folders) {
  for (std::filesystem::path folder = urdf_folder_;; folder = folder.parent_path()) {
    package_folders_.push_back(folder);
    if (folder == folder.parent_path()) {
      break;
    }
  }
  for (const std::filesystem::path& folder : folders_of_environment("ROS_PACKAGE_PATH")) {
    package_folders_.push_back(folder);
  }
  for (const std::filesystem::path& folder : folders_of_environment("AMENT_PREFIX_PATH")) {
    package_folders_.push_back(folder / "share");
  }
}

std::optional<std::filesystem::path> MeshPlaces::find(const std::string& uri) const {
  const auto in_package = without_scheme(uri, {"package://", "model://"});
  if (!in_package) {
    const std::filesystem::path path = urdf_folder_ / without_scheme(uri, {"file://"}).value_or(uri);
    return is_file(path) ? std::optional(path.lexically_normal()) : std::nullopt;
  }
  const std::string named = without_slashes(*in_package);
  const std::size_t name_end = named.find('/');
  const std::string rest = name_end == named.npos ? "" : without_slashes(named.substr(name_end));
  for (const std::string& wanted : {named, rest}) {
    for (const std::filesystem::path& folder : package_folders_) {
      if (is_file(folder / wanted)) {
        return (folder / wanted).lexically_normal();
      }
    }
  }
  return std::nullopt;
}

}  // namespace gaitway::importer
