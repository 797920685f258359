// Preloaded into the robot's programs inside user-mode Linux, for two reasons.
// - Each reading of a clock is a system call there, of 15 to 50 us, and the physics read one some 30 times a
//   millisecond: the processor's time stamp counter stands in, and is compared with the kernel's clock every
//   ten milliseconds.
// - There is one processor, each system call costs that much, and other work may take its part. Where a
//   second of the robot does not fit into a second, GAITWAY_CLOCK_DIVISOR=4 lets both clocks and the time
//   stamps of received frames run at a quarter of their rate for all programs alike, and what they wait for
//   in poll() and ppoll() takes four times as long.
#include <poll.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>
#include <x86intrin.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kFirstSpan_ns =
    20'000'000;  // until the counter's rate is known well enough to be used
constexpr std::int64_t kLongestSpan_ns = 4 * kSecond_ns;  // over which the rate is taken
constexpr std::int64_t kCompare_ns = 10'000'000;

class FastClock {
 public:
  explicit FastClock(clockid_t clock) noexcept : clock_(clock) {}

  std::int64_t now_ns() noexcept {
    if (ns_a_tick_ > 0.0) {
      const double since_ns = static_cast<double>(__rdtsc() - compared_.ticks) * ns_a_tick_;
      if (since_ns < kCompare_ns) {
        last_ns_ = std::max(last_ns_, compared_.ns + static_cast<std::int64_t>(since_ns));
        return last_ns_;
      }
    }
    compare();
    last_ns_ = std::max(last_ns_, compared_.ns);
    return last_ns_;
  }

 private:
  struct Reading {
    std::uint64_t ticks = 0;
    std::int64_t ns = 0;
  };

  // The shortest of a few readings: an interruption would tear ticks and time apart.
  [[nodiscard]] Reading read() const noexcept {
    Reading best;
    std::uint64_t shortest = UINT64_MAX;
    for (int i = 0; i < 3; ++i) {
      timespec time{};
      const std::uint64_t before = __rdtsc();
      syscall(SYS_clock_gettime, clock_, &time);
      const std::uint64_t took = __rdtsc() - before;
      if (took < shortest) {
        shortest = took;
        best = {before + took / 2, time.tv_sec * kSecond_ns + time.tv_nsec};
      }
    }
    return best;
  }

  void compare() noexcept {
    compared_ = read();
    if (first_.ticks == 0) {
      first_ = compared_;
    }
    const std::int64_t span_ns = compared_.ns - first_.ns;
    if (span_ns < 0) {  // the clock was set
      *this = FastClock(clock_);
      return;
    }
    if (span_ns >= kFirstSpan_ns) {
      ns_a_tick_ = static_cast<double>(span_ns) / static_cast<double>(compared_.ticks - first_.ticks);
    }
    if (span_ns >= kLongestSpan_ns) {
      first_ = compared_;
    }
  }

  clockid_t clock_;
  Reading first_, compared_;
  double ns_a_tick_ = 0.0;
  std::int64_t last_ns_ = 0;
};

std::int64_t read_divisor() noexcept {
  const char* const text = std::getenv("GAITWAY_CLOCK_DIVISOR");
  return text == nullptr ? 1 : std::clamp(std::atol(text), 1L, 100L);
}
const std::int64_t divisor = read_divisor();

}  // namespace

#define EXPORTED extern "C" __attribute__((visibility("default")))

EXPORTED int clock_gettime(clockid_t clock, timespec* time) noexcept {
  thread_local FastClock monotonic(CLOCK_MONOTONIC);
  thread_local FastClock real_time(CLOCK_REALTIME);
  if (clock != CLOCK_MONOTONIC && clock != CLOCK_REALTIME) {
    return static_cast<int>(syscall(SYS_clock_gettime, clock, time));
  }
  const std::int64_t now_ns = (clock == CLOCK_MONOTONIC ? monotonic : real_time).now_ns() / divisor;
  *time = {now_ns / kSecond_ns, now_ns % kSecond_ns};
  return 0;
}

EXPORTED int ppoll(pollfd* descriptors, nfds_t count, const timespec* timeout, const sigset_t* mask) {
  timespec scaled{};
  if (timeout != nullptr) {
    const std::int64_t wait_ns = (timeout->tv_sec * kSecond_ns + timeout->tv_nsec) * divisor;
    scaled = {wait_ns / kSecond_ns, wait_ns % kSecond_ns};
  }
  constexpr std::size_t kMaskBytes = 8;  // of the kernel's sigset_t
  return static_cast<int>(
      syscall(SYS_ppoll, descriptors, count, timeout == nullptr ? nullptr : &scaled, mask, kMaskBytes));
}

EXPORTED int poll(pollfd* descriptors, nfds_t count, int timeout_ms) {
  const std::int64_t scaled_ms =
      timeout_ms < 0 ? -1 : std::min<std::int64_t>(timeout_ms * divisor, 1'000'000'000);
  return static_cast<int>(syscall(SYS_poll, descriptors, count, static_cast<int>(scaled_ms)));
}

EXPORTED int recvmmsg(int socket, mmsghdr* messages, unsigned count, int flags, timespec* timeout) {
  const int received = static_cast<int>(syscall(SYS_recvmmsg, socket, messages, count, flags, timeout));
  for (int i = 0; i < received && divisor > 1; ++i) {
    msghdr& header = messages[i].msg_hdr;
    for (cmsghdr* part = CMSG_FIRSTHDR(&header); part != nullptr; part = CMSG_NXTHDR(&header, part)) {
      if (part->cmsg_level == SOL_SOCKET && part->cmsg_type == SCM_TIMESTAMPING) {
        timespec stamp{};  // the kernel's comes first; a virtual interface has no other
        std::memcpy(&stamp, CMSG_DATA(part), sizeof stamp);
        const std::int64_t scaled_ns = (stamp.tv_sec * kSecond_ns + stamp.tv_nsec) / divisor;
        stamp = {scaled_ns / kSecond_ns, scaled_ns % kSecond_ns};
        std::memcpy(CMSG_DATA(part), &stamp, sizeof stamp);
      }
    }
  }
  return received;
}
