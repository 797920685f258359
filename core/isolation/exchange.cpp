// Layout of the shared memory; how both sides wait: they look for a while, then sleep on a futex.
//
// No wake-up is lost. Ringing: A1 number = n, A2 read asleep. Sleeping: B1 asleep = 1, B2 read number (the
// kernel reads it again under its own lock before it sleeps). All four are sequentially consistent, so in
// their one order either A1 comes before B2, and B2 sees the change, or B1 comes before A2, and A2 wakes.
// What was written before A1 is visible after a read that saw n, since the store releases and the load
// acquires.
#include "exchange.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include "gaitway/process/real_time.hpp"

namespace gaitway::core {
namespace {

constexpr std::int64_t kSpin_ns = 20'000;
constexpr std::uint32_t kVainLooks = 4;        // so many in a row, and looking stops
constexpr std::uint32_t kLookAgainEvery = 32;  // but for one try in so many

std::size_t rounded_up(std::size_t bytes) noexcept {
  return (bytes + alignof(PortArea) - 1) / alignof(PortArea) * alignof(PortArea);
}

void pause_processor() noexcept {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

void futex(std::atomic<std::uint32_t>& word, int operation, std::uint32_t value,
           const timespec* timeout) noexcept {
  syscall(SYS_futex, &word, operation, value, timeout, nullptr, 0);
}

}  // namespace

ExchangeLayout::ExchangeLayout(const std::vector<std::uint32_t>& port_sizes) {
  bytes = rounded_up(sizeof(ExchangeHeader));
  for (const std::uint32_t size : port_sizes) {
    port_offset.push_back(bytes);
    bytes += sizeof(PortArea) + rounded_up(size);
  }
}

Spin::Spin() noexcept : several_processors_(sysconf(_SC_NPROCESSORS_ONLN) > 1) {}

bool Spin::sees_change(const Doorbell& bell, std::uint32_t old) noexcept {
  if (bell.number.load() != old) {
    return true;
  }
  if (!several_processors_ || (vain_ >= kVainLooks && ++vain_ % kLookAgainEvery != 0)) {
    return false;
  }
  const std::int64_t end_ns = process::monotonic_ns() + kSpin_ns;
  do {
    for (int i = 0; i < 16; ++i) {
      if (bell.number.load() != old) {
        vain_ = 0;
        return true;
      }
      pause_processor();
    }
  } while (process::monotonic_ns() < end_ns);
  ++vain_;
  return false;
}

void ring(Doorbell& bell, std::uint32_t number) noexcept {
  bell.number.store(number);
  if (bell.asleep.load() != 0) {
    futex(bell.number, FUTEX_WAKE, 1, nullptr);
  }
}

void sleep_on(Doorbell& bell, std::uint32_t old, std::int64_t timeout_ns) noexcept {
  bell.asleep.store(1);
  if (bell.number.load() == old) {
    const timespec timeout{static_cast<time_t>(timeout_ns / 1'000'000'000),
                           static_cast<long>(timeout_ns % 1'000'000'000)};
    futex(bell.number, FUTEX_WAIT, old, timeout_ns < 0 ? nullptr : &timeout);
  }
  bell.asleep.store(0);
}

}  // namespace gaitway::core
