// Which order of the messages' priorities meets every deadline, if any does.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "gaitway/can/analysis/response_time.hpp"

namespace gaitway::can {

// Audsley's optimal priority assignment: priorities are given from the lowest up, each to a message that
// meets its deadline there whatever the order of those above; if any order meets all deadlines, this finds
// one. Candidates are tried by deadline minus jitter, longest first, then in their present order, so the
// answer is the deadline-minus-jitter-monotonic order wherever that one serves. Messages of one FIFO queue
// get neighbouring priorities.
//
// Indices into `messages`, the most urgent first; identifiers are ignored but for their length. Nothing when
// no order meets all deadlines. Throws as response_times does.
[[nodiscard]] std::optional<std::vector<std::size_t>> best_priority_order(
    std::span<const AnalysedMessage> messages, const AnalysisOptions& options = {});

}  // namespace gaitway::can
