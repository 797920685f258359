// A piece of shared memory: a sealed memfd and its mapping.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::msgclient {

enum class Access : std::uint32_t { read_only = 0, read_write = 1 };

// A mapping of shared memory; whoever made it keeps the descriptor behind it. Cannot be truncated or grown by
// anybody: the size is sealed. A segment has exactly one writing side; all others get a descriptor opened
// read-only, which the kernel refuses to map writable, and which is closed once it is mapped. The file may be
// opened by its owner's user alone, and by nobody for writing (mode 0400), so that what is still open cannot
// be reopened for writing through /proc either; of one user's processes only one that changes the mode, or is
// root, can.
class Segment {
 public:
  // Makes zeroed memory. Throws std::system_error.
  static Segment create(const std::string& name, std::size_t bytes);
  // Maps received memory; checks the seals and the size. Throws TopicError or std::system_error.
  static Segment map(process::FileDescriptor fd, std::size_t bytes, Access access);

  Segment(Segment&& other) noexcept;
  Segment& operator=(Segment&& other) noexcept;
  ~Segment();

  // In a copy of the process that fork() made: the memory stays where it is, but from now on what the copy
  // writes there is seen by nobody else. Of memory that is mapped writable. Throws std::system_error.
  void keep_to_this_process();
  // What is there moves into a new piece of shared memory behind the same addresses. Throws
  // std::system_error.
  void share_anew(const std::string& name);

  [[nodiscard]] void* data() const noexcept { return data_; }
  [[nodiscard]] std::size_t size() const noexcept { return bytes_; }
  // Of one that was made here.
  [[nodiscard]] int fd() const noexcept { return fd_.get(); }
  // A further descriptor of the same memory through which it can only be read.
  [[nodiscard]] process::FileDescriptor reopen_read_only() const;

 private:
  Segment(process::FileDescriptor fd, void* data, std::size_t bytes) noexcept;

  process::FileDescriptor fd_;
  void* data_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace gaitway::msgclient
