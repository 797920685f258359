// A plug-in's project: tells when a source file of it was saved, and builds it with CMake in a process of its
// own.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::tools {

class ProjectBuild {
 public:
  ProjectBuild(std::filesystem::path project, std::filesystem::path build);
  ~ProjectBuild();
  ProjectBuild(const ProjectBuild&) = delete;
  ProjectBuild& operator=(const ProjectBuild&) = delete;

  // Configures if need be, then builds. Ends a build that is still running.
  void start();
  [[nodiscard]] bool running() const noexcept { return process_ > 0; }
  // Readable when the running build has ended.
  [[nodiscard]] int wake_fd() const noexcept { return ended_.get(); }
  // Whether it succeeded; nothing while it runs. `wait`: until it has ended.
  std::optional<bool> take_result(bool wait = false);
  // What the last one printed.
  [[nodiscard]] std::string output() const;
  // The newest plug-in library in the build folder; empty: there is none.
  [[nodiscard]] std::filesystem::path library() const;

 private:
  void stop() noexcept;

  std::filesystem::path project_, build_, log_;
  pid_t process_ = 0;
  process::FileDescriptor ended_;
};

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
