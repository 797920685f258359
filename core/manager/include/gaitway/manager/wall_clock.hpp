// How long things take, for reports only: no decision depends on it.
#pragma once

#include <chrono>
#include <cstdint>

namespace gaitway::core {

// Given by whoever builds the main controller; nullptr: nothing is measured.
using WallClock = std::int64_t (*)() noexcept;

inline std::int64_t steady_clock_ns() noexcept {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace gaitway::core
