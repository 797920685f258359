// What a set of messages must fulfil to be analysed, and the order in which the bus serves it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "gaitway/can/analysis/response_time.hpp"

namespace gaitway::can {

// Throws std::invalid_argument, see response_times.
void check_messages(std::span<const AnalysedMessage> messages, const AnalysisOptions& options);

// Indices, the most urgent first.
[[nodiscard]] std::vector<std::size_t> by_priority(std::span<const AnalysedMessage> messages);

}  // namespace gaitway::can
