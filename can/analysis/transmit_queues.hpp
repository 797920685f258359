// The worst case of each transmit queue of a bus, given which messages are more urgent: what the analysis of
// response times and the choice of priorities share. A message that waits in no FIFO queue is the only one of
// a queue of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gaitway/can/analysis/response_time.hpp"

namespace gaitway::can {

// Throws std::invalid_argument, see response_times.
void check_messages(std::span<const AnalysedMessage> messages, const AnalysisOptions& options);

// Indices, the most urgent first.
[[nodiscard]] std::vector<std::size_t> by_priority(std::span<const AnalysedMessage> messages);

class TransmitQueues {
 public:
  // Ranks are those of the identifiers. Throws std::invalid_argument, see response_times.
  TransmitQueues(std::span<const AnalysedMessage> messages, const AnalysisOptions& options);

  [[nodiscard]] std::size_t count() const noexcept { return queues_.size(); }
  // Indices of messages.
  [[nodiscard]] std::span<const std::size_t> members(std::size_t queue) const noexcept {
    return queues_[queue];
  }
  // The lower, the more urgent. Queues whose messages all have one rank are neighbours in priority.
  void set_rank(std::size_t queue, std::uint32_t rank) noexcept;

  // In the order of members(). How long other stations' FIFO queues hold frames back is as update_holdups()
  // left it.
  [[nodiscard]] std::vector<MessageResponse> responses(std::size_t queue) const;
  // Takes over how long the frames of a queue with those responses may be held back behind one another.
  // Returns whether that is news; `give_up` makes any news an unbounded time.
  bool update_holdups(std::size_t queue, std::span<const MessageResponse> responses, bool give_up) noexcept;

 private:
  struct Message {
    std::uint32_t rank = 0;
    std::size_t queue = 0;
    std::int64_t period_ns = 0, jitter_ns = 0, length_ns = 0;
    // From the nominal release until it takes part in arbitration; nothing: without bound.
    std::optional<std::int64_t> arbitration_jitter_ns;
  };
  struct Interference {  // messages of one period and jitter
    std::int64_t period_ns = 0, jitter_ns = 0, length_ns = 0;
  };
  // What a queue meets on the bus.
  struct Level {
    std::int64_t blocking_ns = 0;
    std::int64_t error_ns = 0;        // one hit, without its duration
    std::vector<Interference> above;  // more urgent messages of other queues
    bool bounded = true;              // all of them take a bounded part of the bus
  };
  void group(std::span<const AnalysedMessage> messages);
  [[nodiscard]] Level level_of(std::size_t queue) const;
  [[nodiscard]] bool holds_back(std::size_t queue, std::uint32_t rank) const noexcept;
  [[nodiscard]] double utilisation(std::size_t queue, const Level& level) const noexcept;
  [[nodiscard]] std::int64_t demand_ns(const Level& level, std::int64_t window_ns) const noexcept;
  [[nodiscard]] std::int64_t error_delay_ns(const Level& level, std::int64_t window_ns) const noexcept;
  [[nodiscard]] std::optional<std::int64_t> busy_period_ns(std::size_t queue, const Level& level) const;
  [[nodiscard]] std::optional<std::int64_t> start_ns(const Level& level, std::int64_t ahead_ns,
                                                     std::int64_t length_ns, std::int64_t from_ns) const;
  [[nodiscard]] std::int64_t ahead_ns(std::size_t message, std::int64_t arrival_ns,
                                      std::int64_t instance) const noexcept;
  [[nodiscard]] std::optional<std::int64_t> worst_own_instance_ns(std::size_t message, const Level& level,
                                                                  std::int64_t busy_ns) const;
  [[nodiscard]] std::optional<std::int64_t> worst_behind_others_ns(std::size_t message, const Level& level,
                                                                   std::int64_t busy_ns) const;

  AnalysisOptions options_;
  std::vector<Message> messages_;
  std::vector<MessageResponse> known_;            // length and deadline of each message
  std::vector<std::vector<std::size_t>> queues_;  // indices of messages
  std::vector<std::size_t> by_period_;            // indices of messages, by period and jitter
};

}  // namespace gaitway::can
