// What the configuration says about the process of a plug-in with `isolation: process`, and how the manager
// deals with such processes.
#pragma once

#include <cstdint>
#include <filesystem>

namespace gaitway::input {
class YamlValue;
}

namespace gaitway::core {

// How long the manager waits for a plug-in in a process of its own, how often it replaces that process, and
// what the process may use. A step's own budget is the plug-in's, wherever it runs.
struct IsolationOptions {
  // Virtual time: the step waits for its process, and wall time decides nothing but when a child hangs.
  // False, real time: a step that has no answer within its budget is late.
  bool lock_step = true;
  std::int64_t hang_ns = 100'000'000;            // real time: no answer for so long ends the child
  std::int64_t watchdog_ns = 2'000'000'000;      // lock-step: the same, by the wall clock
  std::int64_t start_limit_ns = 30'000'000'000;  // of a start, by the wall clock
  // From a child's end to its replacement, by the robot's clock: the same in each run of one seed.
  std::int64_t restart_delay_ns = 40'000'000;
  std::uint32_t replacements = 3;  // at most so many (0..8) within the window; then out of service
  std::int64_t replacement_window_ns = 10'000'000'000;
  // Address space of the child. 0: it has no bounds at all; for a plug-in's trial before it runs in-process.
  std::uint64_t memory_limit_bytes = std::uint64_t{512} << 20U;
  std::uint32_t descriptor_limit = 64;  // open files of the child
};

// Under a plug-in's entry:
//   network: serve          # it may open sockets while it is constructed, and accept connections ever after
//   writes: recordings      # the only folder in which it may create files; from the configuration's folder
//   descriptors: 512        # open files, 16..4096
//   memory: 1 GiB           # address space, 64 MiB..64 GiB
struct ChildSettings {
  bool serves_network = false;
  std::filesystem::path writes;          // absolute; empty: none
  std::uint32_t descriptor_limit = 0;    // 0: that of IsolationOptions
  std::uint64_t memory_limit_bytes = 0;  // 0: the same
};

// The manager's options as these settings have them.
[[nodiscard]] IsolationOptions options_for(const ChildSettings& settings, IsolationOptions options) noexcept;

// Reads these keys of a plug-in's entry. Throws input::InputError.
ChildSettings read_child_settings(const input::YamlValue& plugin, bool isolated);

}  // namespace gaitway::core
