// Room on a disk that is kept for what must be written when it is full.
#pragma once

#include <cstdint>
#include <filesystem>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::process {

// A file without a name, whose blocks belong to it until it is given back or the process ends, however it
// does. Where there is no room to be had, none is kept.
class SpareRoom {
 public:
  SpareRoom(std::filesystem::path folder, std::uint64_t bytes) noexcept;
  // Gives it back for the time of a writing, and takes it again.
  void give_back() noexcept { file_ = FileDescriptor(); }
  void take() noexcept;

 private:
  std::filesystem::path folder_;
  std::uint64_t bytes_;
  FileDescriptor file_;
};

}  // namespace gaitway::process
