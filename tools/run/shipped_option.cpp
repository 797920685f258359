// The file first, so that nobody's own is hidden by a shipped one.
#include "tools/run/shipped_option.hpp"

#include "gaitway/input/complaint.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/shipped_files.hpp"

namespace gaitway::tools {

std::filesystem::path file_or_shipped(const std::string& option, const std::filesystem::path& given,
                                      const std::filesystem::path& directory) {
  if (process::is_file(given) || given.has_parent_path()) return given;
  if (const auto shipped = process::find_shipped(directory, given.string(), ".yaml")) return *shipped;
  input::refuse({option, 0, "name", "'" + given.string() + "'",
                 "there is no such file, and none of that name is shipped",
                 input::suggest(given.string(), process::shipped_names(directory, ".yaml"))});
}

std::filesystem::path configuration_file(const std::filesystem::path& given) {
  return file_or_shipped("--config", given, process::config_directory());
}

}  // namespace gaitway::tools
