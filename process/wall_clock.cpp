// The difference between both clocks, now.
#include "gaitway/process/wall_clock.hpp"

#include <array>
#include <cstdio>
#include <ctime>

#include "gaitway/process/real_time.hpp"

namespace gaitway::process {

std::string date_and_time_of(std::int64_t monotonic_ns) {
  constexpr std::int64_t kSecond_ns = 1'000'000'000, kMillisecond_ns = 1'000'000;
  timespec wall{};
  clock_gettime(CLOCK_REALTIME, &wall);
  const std::int64_t time_ns =
      wall.tv_sec * kSecond_ns + wall.tv_nsec + monotonic_ns - process::monotonic_ns();
  const std::time_t seconds = time_ns / kSecond_ns;
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  std::array<char, 32> date{}, text{};
  const std::size_t length = std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%S", &parts);
  std::snprintf(text.data(), text.size(), "%.*s.%03dZ", static_cast<int>(length), date.data(),
                static_cast<int>(time_ns % kSecond_ns / kMillisecond_ns));
  return text.data();
}

}  // namespace gaitway::process
