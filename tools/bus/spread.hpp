// How a quantity is spread: how often it was seen, its mean and its extremes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

namespace gaitway::tools {

struct Spread {
  std::uint64_t count = 0;
  double sum = 0.0;
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  void add(double value) noexcept {
    ++count;
    sum += value;
    min = std::min(min, value);
    max = std::max(max, value);
  }
  // Only of a quantity that was seen.
  [[nodiscard]] double mean() const noexcept { return count == 0 ? 0.0 : sum / static_cast<double>(count); }
};

}  // namespace gaitway::tools
