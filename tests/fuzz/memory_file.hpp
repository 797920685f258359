// A file in memory with a path of its own: for readers that want a file.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::fuzz {

class MemoryFile {
 public:
  explicit MemoryFile(std::string_view content = {}) : file_(memfd_create("gaitway_fuzz", MFD_CLOEXEC)) {
    if (!file_ ||
        write(file_.get(), content.data(), content.size()) != static_cast<ssize_t>(content.size())) {
      throw std::runtime_error("no memory file can be made");
    }
  }
  [[nodiscard]] std::filesystem::path path() const { return "/proc/self/fd/" + std::to_string(file_.get()); }

 private:
  process::FileDescriptor file_;
};

}  // namespace gaitway::fuzz
