// What a child may not do, set before any of the plug-in's code runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace gaitway::core {

struct ChildBounds {
  std::uint64_t memory_limit_bytes =
      0;  // 0: of all this only the descriptors, the core file and the priority
  std::uint64_t descriptor_limit = 0;
  // Opens sockets and files until end_set_up(), has no priority and few privileges.
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

// --- The tighter bounds of one that serves the network: what reaches it from there must not reach further.
// In two parts, since a thread that the plug-in starts while it is constructed must be bound, too.

// Before the plug-in is constructed, by the only thread there is: files are created and written beneath
// `folder` alone (empty: nowhere), by this thread and all that it starts. True: the kernel sees to it
// (Landlock). False: it cannot; then no file may be opened once set-up is over. Throws PluginError if there
// is no such folder.
[[nodiscard]] bool confine_writes(const std::filesystem::path& folder);

// When set-up is over, for all threads that there are and will be: no new sockets but those that are
// accepted, no connections, no change of files or folders, no file opened but for writing, and that only if
// `may_write`. What is refused answers EPERM, an open EACCES. Throws PluginError where the kernel cannot do
// that: then nothing must be served.
void end_set_up(bool may_write);

}  // namespace gaitway::core
