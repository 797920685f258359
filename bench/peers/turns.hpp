// Rivals that take turns in one thread, and the median of what each turn took.
#pragma once

#include <time.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace gaitway::peers {

// Of the processor, for this thread: what others take from it meanwhile does not count.
inline double processor_time_ns() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

// Each of `turns` times everybody once, another one first each time. The median of each, in ns.
inline std::vector<double> median_turn_ns(std::size_t turns,
                                          const std::vector<std::function<void()>>& rivals) {
  std::vector<std::vector<double>> taken_ns(rivals.size());
  for (std::size_t turn = 0; turn < turns; ++turn) {
    for (std::size_t i = 0; i < rivals.size(); ++i) {
      const std::size_t rival = (turn + i) % rivals.size();
      const double began_ns = processor_time_ns();
      rivals[rival]();
      taken_ns[rival].push_back(processor_time_ns() - began_ns);
    }
  }
  std::vector<double> medians;
  for (std::vector<double>& samples : taken_ns) {
    std::ranges::nth_element(samples, samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2));
    medians.push_back(samples[samples.size() / 2]);
  }
  return medians;
}

}  // namespace gaitway::peers
