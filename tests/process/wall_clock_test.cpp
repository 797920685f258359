// Instants of the shared clock as people read them.
#include "gaitway/process/wall_clock.hpp"

#include <gtest/gtest.h>

#include <ctime>

#include "gaitway/process/real_time.hpp"

namespace gaitway::process {
namespace {

// "2026-01-31T12:00:00.250Z", as ms since 1970.
std::int64_t milliseconds_of(const std::string& text) {
  std::tm parts{};
  const char* const rest = strptime(text.c_str(), "%Y-%m-%dT%H:%M:%S", &parts);
  EXPECT_NE(rest, nullptr) << text;
  EXPECT_EQ(text.size(), 24U) << text;
  return rest == nullptr ? 0 : timegm(&parts) * std::int64_t{1000} + std::stoi(std::string(rest + 1, 3));
}

TEST(WallClock, AnInstantOfTheSharedClockHasItsDateAndTime) {
  const std::int64_t now_ns = monotonic_ns();
  const std::int64_t now_ms = milliseconds_of(date_and_time_of(now_ns));
  EXPECT_NEAR(static_cast<double>(now_ms), static_cast<double>(std::time(nullptr)) * 1e3, 1.5e3);
  const std::int64_t before_ms = milliseconds_of(date_and_time_of(now_ns - 90'061'500'000'000));
  EXPECT_NEAR(static_cast<double>(now_ms - before_ms), 90'061'500.0, 50.0)
      << "a day, an hour, a minute, 1.5 s";
}

}  // namespace
}  // namespace gaitway::process
