// Where a robot's sockets, locks and logs lie: folders that nobody else may write to.
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "tools/robot/keeper/robot_plan.hpp"

namespace gaitway::tools {
namespace {

void prepare(const std::filesystem::path& folder, const char* option) {
  std::error_code failed;
  std::filesystem::create_directories(folder.parent_path(), failed);
  constexpr mode_t kOwnFolder = 0700;
  if (mkdir(folder.c_str(), kOwnFolder) != 0 && errno != EEXIST) {
    throw std::invalid_argument(fmt::format("{} {}: the folder cannot be made: {}. Choose another one",
                                            option, folder.string(), std::strerror(errno)));
  }
  if (!std::filesystem::is_directory(folder)) {
    throw std::invalid_argument(
        fmt::format("{} {}: is there and is no folder. Choose another one", option, folder.string()));
  }
  struct stat status {};
  constexpr mode_t kOthersWrite = S_IWGRP | S_IWOTH;
  if (lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != geteuid() ||
      (status.st_mode & kOthersWrite) != 0) {
    throw std::invalid_argument(fmt::format(
        "{} {}: must be a folder of this user's, to which nobody else may write, since who writes to "
        "it moves the robot. Correct its rights (chmod go-w), or choose another one",
        option, folder.string()));
  }
}

}  // namespace

std::filesystem::path usual_robot_folder() {
  if (const char* const given = std::getenv("RUNTIME_DIRECTORY"); given != nullptr && *given != '\0') {
    return given;
  }
  if (geteuid() == 0) return "/run/gaitway";
  if (const char* const own = std::getenv("XDG_RUNTIME_DIR"); own != nullptr && *own != '\0') {
    return std::filesystem::path(own) / "gaitway";
  }
  return fmt::format("/tmp/gaitway-{}", geteuid());
}

RobotFolders prepare_folders(const std::filesystem::path& folder, const std::filesystem::path& log) {
  RobotFolders folders = folders_at(folder);
  prepare(folders.folder, "--folder");
  if (!log.empty()) {
    folders.log = std::filesystem::absolute(log).lexically_normal();
    prepare(folders.log, "--log");
  }
  return folders;
}

RobotFolders folders_at(const std::filesystem::path& folder) {
  std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  if (!whole.has_filename()) whole = whole.parent_path();  // "/run/gaitway/"
  return {.folder = whole, .log = whole};
}

}  // namespace gaitway::tools
