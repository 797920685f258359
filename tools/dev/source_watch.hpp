// Tells when a source file of a project was saved.
#pragma once

#include <filesystem>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::tools {

class SourceWatch {
 public:
  // The project's folder and those below it, but for hidden ones and `build`. Throws std::runtime_error.
  SourceWatch(const std::filesystem::path& project, const std::filesystem::path& build);

  // Readable when something was saved.
  [[nodiscard]] int wake_fd() const noexcept { return inotify_.get(); }
  // Whether a source file was saved since the last call.
  [[nodiscard]] bool take_change() const;

 private:
  void watch(const std::filesystem::path& folder) const;

  process::FileDescriptor inotify_;
};

}  // namespace gaitway::tools
