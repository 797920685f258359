// Rivals that take turns in one run, so that a drift of the machine hits all of them, and what their samples
// say about a claim.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "gaitway/manager/manager_options.hpp"

namespace gaitway::core {

class Rivals {
 public:
  explicit Rivals(std::size_t count) : samples_us_(count) {}

  // Runs it once; how long that took goes to the rival's samples.
  template <class Function>
  void time(std::size_t rival, const Function& function) {
    const std::int64_t begin_ns = steady_clock_ns();
    function();
    add(rival, steady_clock_ns() - begin_ns);
  }
  void add(std::size_t rival, std::int64_t duration_ns) {
    samples_us_[rival].push_back(static_cast<double>(duration_ns) * 1e-3);
  }
  // 0 <= share <= 1; 0.5: the median. 0 without samples.
  [[nodiscard]] double percentile_us(std::size_t rival, double share = 0.5) const {
    std::vector<double> sorted = samples_us_[rival];
    if (sorted.empty()) {
      return 0.0;
    }
    const auto rank = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(rank), sorted.end());
    return sorted[rank];
  }

 private:
  std::vector<std::vector<double>> samples_us_;
};

// Ends the benchmark's line: "holds" or "DOES NOT HOLD", and the claim.
inline void judge(benchmark::State& state, bool holds, const std::string& claim) {
  state.SetLabel((holds ? "holds: " : "DOES NOT HOLD: ") + claim);
}

}  // namespace gaitway::core
