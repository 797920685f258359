// What a child may not do, set before any of the plug-in's code runs.
#pragma once

#include <cstdint>
#include <string>

namespace gaitway::core {

struct ChildBounds {
  std::uint64_t memory_limit_bytes =
      0;  // 0: of all this only the descriptors, the core file and the priority
  std::uint64_t descriptor_limit = 0;
  // Opens sockets and files until network_bounds.hpp says otherwise, has no priority and few privileges.
  bool serves_network = false;
};

// For a process's main thread, once: closes all descriptors from `first_closed` on, sets limits on memory and
// descriptors, no core file, no new rights, a priority below that of the manager, and refuses system calls
// that start or trace processes, signal others, reach the network, or lift these bounds. A refused call
// answers EPERM and, unless the process serves the network, is remembered. Where the kernel has no such
// filter, RLIMIT_NPROC 0 stands for it.
void enter_child_bounds(const ChildBounds& bounds, int first_closed) noexcept;

// Of a process that serves the network, whose other threads are to get an error and nothing else: from now on
// the calling thread, which steps, has what it is refused remembered. Connections that were accepted it may
// use.
[[nodiscard]] bool remember_refused_calls() noexcept;

// The first refused call since the last question, for people; empty: none.
[[nodiscard]] std::string take_refused_call();

}  // namespace gaitway::core
