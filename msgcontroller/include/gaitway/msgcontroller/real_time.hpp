// What the processes of a robot need of the operating system to run in real time: the common clock, priority,
// locked memory, absolute deadlines and the wish to end. For binaries alone; components are told the time.
#pragma once

#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <time.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <vector>

namespace gaitway::real_time {

// The clock that all processes of one robot share.
inline std::int64_t monotonic_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

// Where the rights are missing a plain message: it runs then as well, with more jitter.
inline void ask_for_real_time(const char* program, int priority) {
  sched_param parameter{};
  parameter.sched_priority = priority;
  if (sched_setscheduler(0, SCHED_FIFO, &parameter) != 0) {
    std::fprintf(stderr, "%s: no SCHED_FIFO (%s): it may wake late under load\n", program,
                 std::strerror(errno));
  }
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    std::fprintf(stderr, "%s: memory is not locked (%s): a page fault may delay it\n", program,
                 std::strerror(errno));
  }
}

inline volatile sig_atomic_t stop_requested = 0;

// From then on SIGINT and SIGTERM only ask to stop, and are seen while wait_until() waits and nowhere else,
// so that none slips in between a look at stop_requested and the waiting.
inline void stop_on_signals() noexcept {
  struct sigaction action {};
  action.sa_handler = [](int) { stop_requested = 1; };
  sigset_t stops;
  sigemptyset(&stops);
  for (const int signal : {SIGINT, SIGTERM}) {
    sigaction(signal, &action, nullptr);
    sigaddset(&stops, signal);
  }
  sigprocmask(SIG_BLOCK, &stops, nullptr);
}

// Waits until the clock has come to `deadline_ns`, a descriptor is readable or a signal asks to stop.
inline void wait_until(std::int64_t deadline_ns, std::span<pollfd> descriptors) noexcept {
  const std::int64_t left_ns = std::max<std::int64_t>(deadline_ns - monotonic_ns(), 0);
  const timespec left{static_cast<time_t>(left_ns / 1'000'000'000),
                      static_cast<long>(left_ns % 1'000'000'000)};
  sigset_t none;
  sigemptyset(&none);
  ppoll(descriptors.data(), static_cast<nfds_t>(descriptors.size()), &left, &none);
}

// How late wake-ups were, to the microsecond; what is later than kLongest_us counts as that much, but for the
// maximum.
class LatenessRecord {
 public:
  void add(std::int64_t late_ns) noexcept {
    const std::int64_t late_us = std::max<std::int64_t>(late_ns, 0) / 1000;
    ++buckets_[static_cast<std::size_t>(std::min(late_us, kLongest_us))];
    ++count_;
    max_us_ = std::max(max_us_, late_us);
  }
  // The smallest lateness that this part (0..1) of all did not exceed; 0 when there was none.
  [[nodiscard]] std::int64_t quantile_us(double part) const noexcept {
    const double wanted = part * static_cast<double>(count_);
    std::uint64_t passed = 0;
    for (std::size_t us = 0; us < buckets_.size(); ++us) {
      passed += buckets_[us];
      if (passed > 0 && static_cast<double>(passed) >= wanted) {
        return static_cast<std::int64_t>(us);
      }
    }
    return 0;
  }
  [[nodiscard]] std::int64_t max_us() const noexcept { return max_us_; }
  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }

 private:
  static constexpr std::int64_t kLongest_us = 100'000;
  std::vector<std::uint32_t> buckets_ = std::vector<std::uint32_t>(kLongest_us + 1);
  std::uint64_t count_ = 0;
  std::int64_t max_us_ = 0;
};

}  // namespace gaitway::real_time
