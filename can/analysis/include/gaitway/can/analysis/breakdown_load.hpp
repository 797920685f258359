// How much slower a bus could be before the first message misses its deadline.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "gaitway/can/analysis/response_time.hpp"

namespace gaitway::can {

struct Breakdown {
  std::int64_t bit_time_ns = 0;  // the slowest bus, to the nanosecond, on which every deadline is met
  double load = 0.0;             // of the bus at that speed: the breakdown load
};

// All frames grow by the same factor; periods, jitters, deadlines and the durations of jams stay. Below
// options.bit_time_ns where the messages miss a deadline as they are. Nothing where no speed helps.
[[nodiscard]] std::optional<Breakdown> breakdown(std::span<const AnalysedMessage> messages,
                                                 const AnalysisOptions& options = {});

}  // namespace gaitway::can
