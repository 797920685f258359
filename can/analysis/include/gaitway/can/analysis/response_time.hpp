// How long each message of a CAN bus takes in the worst case, from its release to the end of its interframe
// space. The analysis is the revised one of Davis, Burns, Bril and Lukkien ("Controller Area Network (CAN)
// schedulability analysis: refuted, revisited and revised", 2007): every instance of a message within its
// busy period is looked at, because the first one need not be the worst. Messages that share a FIFO transmit
// queue are treated after Davis, Kollmann, Pollex and Slomka ("CAN schedulability analysis with FIFO queues",
// 2011). All arithmetic is in whole nanoseconds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/can/analysis/error_model.hpp"

namespace gaitway::can {

struct AnalysedMessage {
  std::string name;
  std::uint32_t id = 0;
  bool extended = false;
  int bytes = 8;                 // 0..8
  std::int64_t period_ns = 0;    // shortest time between two nominal releases
  std::int64_t jitter_ns = 0;    // how much later than nominal a release may come
  std::int64_t deadline_ns = 0;  // from the nominal release; may be longer than the period
  // Messages with the same number wait in one FIFO transmit queue of one station. Nothing: the station always
  // offers its most urgent message.
  std::optional<int> fifo;
  // Longest frame, interframe space included, where it is known better than from its size.
  std::optional<int> length_bits;
};

struct AnalysisOptions {
  std::int64_t bit_time_ns = 1000;  // 1 Mb/s
  ErrorModel errors;
};

struct MessageResponse {
  int length_bits = 0;           // interframe space included
  std::int64_t blocking_ns = 0;  // by the longest less urgent frame that is already on the wire
  // From the nominal release to the end of the interframe space; nothing where no bound exists: the bus never
  // falls idle for this priority, or it is so close to that that 200,000 steps do not find the end.
  std::optional<std::int64_t> worst_response_ns;
  std::int64_t deadline_ns = 0;
  std::int64_t instances = 0;  // of the message within its busy period: all were looked at
  [[nodiscard]] bool schedulable() const noexcept {
    return worst_response_ns && *worst_response_ns <= deadline_ns;
  }
  [[nodiscard]] std::optional<std::int64_t> slack_ns() const noexcept {
    return worst_response_ns ? std::optional(deadline_ns - *worst_response_ns) : std::nullopt;
  }
};

// In the order of `messages`. Identifiers decide on priority, as on the bus (frame.hpp, arbitration_key).
// Throws std::invalid_argument that names message, field, value and rule when one cannot be: size or
// identifier out of range, two messages with one identifier, period or deadline <= 0, jitter < 0, more than
// 1,000,000 s.
//
// The bound holds for releases at any instant, for receivers that have a frame at the last bit of its end of
// frame: what a bus that starts frames on whole bits adds (less than a bit) is less than the interframe
// space, which is counted.
[[nodiscard]] std::vector<MessageResponse> response_times(std::span<const AnalysedMessage> messages,
                                                          const AnalysisOptions& options = {});

// Whether every message meets its deadline.
[[nodiscard]] bool all_schedulable(std::span<const AnalysedMessage> messages,
                                   const AnalysisOptions& options = {});

// Longest frame of the message, interframe space included.
[[nodiscard]] int length_bits(const AnalysedMessage& message) noexcept;

// Share of the bus that the messages take when all frames are as long as they can be; errors not counted.
[[nodiscard]] double bus_load(std::span<const AnalysedMessage> messages, std::int64_t bit_time_ns = 1000);

// How much slower the bus could be before the first message misses its deadline.
struct Breakdown {
  std::int64_t bit_time_ns = 0;  // the slowest bus, to the nanosecond, on which every deadline is met
  double load = 0.0;             // of the bus at that speed: the breakdown load
};

// All frames grow by the same factor; periods, jitters, deadlines and the durations of jams stay. Below
// options.bit_time_ns where the messages miss a deadline as they are. Nothing where no speed helps.
[[nodiscard]] std::optional<Breakdown> breakdown(std::span<const AnalysedMessage> messages,
                                                 const AnalysisOptions& options = {});

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
