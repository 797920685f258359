// Clock, priority, locked memory and signals of a real-time process, by POSIX alone: no thread of its own.
#include "gaitway/process/real_time.hpp"

#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <time.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace gaitway::process {
namespace {

volatile sig_atomic_t stop_was_requested = 0;  // a signal handler has nowhere else to write to

}  // namespace

std::int64_t monotonic_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

void ask_for_real_time(const char* program, int priority) {
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

void stop_on_signals() noexcept {
  struct sigaction action {};
  action.sa_handler = [](int) { stop_was_requested = 1; };
  sigset_t stops;
  sigemptyset(&stops);
  for (const int signal : {SIGINT, SIGTERM}) {
    sigaction(signal, &action, nullptr);
    sigaddset(&stops, signal);
  }
  sigprocmask(SIG_BLOCK, &stops, nullptr);
}

bool stop_requested() noexcept {
  return stop_was_requested != 0;
}

void wait_until(std::int64_t deadline_ns, std::span<pollfd> descriptors) noexcept {
  const std::int64_t remaining_ns = std::max<std::int64_t>(deadline_ns - monotonic_ns(), 0);
  const timespec remaining{static_cast<time_t>(remaining_ns / 1'000'000'000),
                           static_cast<long>(remaining_ns % 1'000'000'000)};
  sigset_t none;
  sigemptyset(&none);
  ppoll(descriptors.data(), static_cast<nfds_t>(descriptors.size()), &remaining, &none);
}

}  // namespace gaitway::process
