// A shared library's private copy in memory: whoever overwrites or truncates the file afterwards harms
// nobody, and nobody writes the copy.
#pragma once

#include <filesystem>
#include <string>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::core {

// Keeps its bytes for as long as it lives; two copies of one file are two libraries to the loader.
class LibraryCopy {
 public:
  // Reads the file and checks its ELF header. Throws PluginError: not readable, no shared library, one for
  // another machine.
  explicit LibraryCopy(const std::filesystem::path& file);

  // What dlopen() takes.
  [[nodiscard]] std::string path() const;

 private:
  process::FileDescriptor memory_;
};

}  // namespace gaitway::core
