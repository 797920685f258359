// How long the manager waits for a plug-in in a process of its own, how often it replaces that process, and
// what the process may use. A step's own budget is the plug-in's, wherever it runs.
#pragma once

#include <cstdint>

namespace gaitway::core {

struct IsolationOptions {
  // Virtual time: the step waits for its host, and wall time decides nothing but when a host hangs. False,
  // real time: a step that has no answer within its budget is late.
  bool lock_step = true;
  std::int64_t hang_ns = 100'000'000;            // real time: no answer for so long ends the host
  std::int64_t watchdog_ns = 2'000'000'000;      // lock-step: the same, by the wall clock
  std::int64_t start_limit_ns = 30'000'000'000;  // of a start, by the wall clock
  // From a host's end to its replacement, by the robot's clock: the same in each run of one seed.
  std::int64_t restart_delay_ns = 40'000'000;
  std::uint32_t replacements = 3;  // at most so many (0..8) within the window; then out of service
  std::int64_t replacement_window_ns = 10'000'000'000;
  // Address space of the host. 0: it has no bounds at all; for a plug-in's trial before it runs in-process.
  std::uint64_t memory_limit_bytes = std::uint64_t{512} << 20U;
  std::uint32_t descriptor_limit = 64;  // open files of the host
};

}  // namespace gaitway::core
