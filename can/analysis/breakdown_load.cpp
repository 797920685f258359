// Bisection over the bit time: the responses grow with it.
#include "gaitway/can/analysis/breakdown_load.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::can {

std::optional<Breakdown> breakdown(std::span<const AnalysedMessage> messages,
                                   const AnalysisOptions& options) {
  AnalysisOptions tried = options;
  const auto meets_all = [&](std::int64_t bit_time_ns) {
    tried.bit_time_ns = bit_time_ns;
    return all_schedulable(messages, tried);
  };
  if (messages.empty() || !meets_all(1)) {
    return std::nullopt;
  }
  // No bus carries more than it has time for.
  const double full_ns = 1.0 / bus_load(messages, 1);
  std::int64_t good_ns = 1;
  std::int64_t bad_ns = std::max<std::int64_t>(2, std::llround(std::min(full_ns * 1.001, 1e9)) + 1);
  while (bad_ns - good_ns > 1) {
    const std::int64_t middle_ns = good_ns + (bad_ns - good_ns) / 2;
    (meets_all(middle_ns) ? good_ns : bad_ns) = middle_ns;
  }
  return Breakdown{good_ns, bus_load(messages, good_ns)};
}

}  // namespace gaitway::can
