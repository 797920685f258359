// What a child may not do, set before any of the plug-in's code runs.
#pragma once

#include <cstdint>
#include <string>

namespace gaitway::core {

struct ChildBounds {
  std::uint64_t memory_limit_bytes =
      0;  // 0: of all this only the descriptors, the core file and the priority
  std::uint64_t descriptor_limit = 0;
  // May make and use Unix sockets, and no others.
  bool local_sockets = false;
};

// For a process's main thread, once: closes all descriptors from `first_closed` on, sets limits on memory and
// descriptors, no core file, no new rights, a priority below that of the manager, and refuses system calls
// that start or trace processes, signal others, make or use sockets, or lift these bounds. A refused call
// answers EPERM and is remembered. The process of a plug-in in Python goes through it twice, before its
// interpreter (closing descriptors and stepping back) and in it, and so runs one priority lower still. Where
// the kernel has no such filter, RLIMIT_NPROC 0 stands for it.
void enter_child_bounds(const ChildBounds& bounds, int first_closed) noexcept;

// The first refused call since the last question, for people; empty: none.
[[nodiscard]] std::string take_refused_call();

}  // namespace gaitway::core
