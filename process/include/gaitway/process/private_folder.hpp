// A place for what only this process and its children need.
#pragma once

#include <filesystem>
#include <string>

namespace gaitway::process {

// A folder that only this user can look into, removed with what is in it.
class PrivateFolder {
 public:
  // `name`: what its own begins with. Throws std::system_error.
  explicit PrivateFolder(const std::string& name);
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  ~PrivateFolder();
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace gaitway::process
