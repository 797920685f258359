// What the processes of a robot need of the operating system to run in real time: the common clock, priority,
// locked memory, absolute deadlines and the wish to end. For binaries alone; components are told the time.
#pragma once

#include <poll.h>

#include <cstdint>
#include <span>

namespace gaitway::process {

// The clock that all processes of one robot share.
std::int64_t monotonic_ns() noexcept;

// SCHED_FIFO at this priority, and memory locked. Where the rights are missing a plain message on stderr: it
// runs then as well, with more jitter.
void ask_for_real_time(const char* program, int priority);

// From then on SIGINT and SIGTERM only ask to stop, and are seen while wait_until() waits and nowhere else,
// so that none slips in between a look at stop_requested() and the waiting.
void stop_on_signals() noexcept;
[[nodiscard]] bool stop_requested() noexcept;

// Waits until the clock has come to `deadline_ns`, a descriptor is readable or a signal came.
void wait_until(std::int64_t deadline_ns, std::span<pollfd> descriptors) noexcept;

}  // namespace gaitway::process
