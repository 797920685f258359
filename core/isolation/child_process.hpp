// A child as a process: found, started, watched by its descriptor, ended.
#pragma once

#include <sys/types.h>

#include <array>
#include <filesystem>
#include <string_view>

#include "bounds.hpp"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::core {

// What the process of a plug-in runs: gaitway_python_child for one in Python; else the binary that
// GAITWAY_PLUGIN_CHILD names, or gaitway_plugin_child. Both are looked for beside the running executable and
// among the programs of the installation. Throws PluginError with the places tried.
[[nodiscard]] std::filesystem::path find_plugin_child(std::string_view library);

class ChildProcess {
 public:
  ChildProcess() = default;
  // Starts `binary`; `socket` becomes its only descriptor beside the standard ones. Throws PluginError.
  ChildProcess(const std::filesystem::path& binary, const process::FileDescriptor& socket,
               const ChildBounds& bounds);
  // Kills it if it still runs.
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept { *this = std::move(other); }
  ChildProcess& operator=(ChildProcess&& other) noexcept;

  // Readable once it has ended.
  [[nodiscard]] int fd() const noexcept { return pidfd_.get(); }
  // Waits at most `timeout_ms`.
  [[nodiscard]] bool has_ended(int timeout_ms = 0) const noexcept;
  void kill() noexcept;
  // Of one that has ended: "exited with code 3", "was ended by SIGSEGV".
  [[nodiscard]] std::string_view end() noexcept;
  [[nodiscard]] bool ended_well() noexcept { return end() == "exited with code 0"; }

 private:
  pid_t pid_ = -1;
  process::FileDescriptor pidfd_;
  bool reaped_ = false;
  std::array<char, 64> end_{};
};

}  // namespace gaitway::core
