// Looks for files by their names.
#include "gaitway/process/shipped_files.hpp"

#include <algorithm>

namespace gaitway::process {

std::vector<std::string> shipped_names(const std::filesystem::path& directory, const std::string& extension) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(directory, none)) {
    if (entry.path().extension() == extension) names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

std::optional<std::filesystem::path> find_shipped(const std::filesystem::path& directory,
                                                  const std::string& name, const std::string& extension) {
  for (const std::filesystem::path& file : {directory / name, directory / (name + extension)}) {
    if (is_file(file)) return file;
  }
  return std::nullopt;
}

bool is_file(const std::filesystem::path& path) {
  std::error_code unknown;
  return std::filesystem::exists(path, unknown) && !std::filesystem::is_directory(path, unknown);
}

}  // namespace gaitway::process
