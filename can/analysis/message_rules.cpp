// What messages must fulfil to be analysed (each value within its range, each identifier once), and the order
// in which the bus serves them.
#include "transmit_queues.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "gaitway/can/frame.hpp"

namespace gaitway::can {
namespace {

constexpr std::int64_t kLongest_ns = 1'000'000'000'000'000;  // sums of these do not overflow
constexpr std::int64_t kMostBits = 10'000;
constexpr int kMostHits = 1'000'000;

struct Range {
  const char* field;
  std::int64_t value, lowest, highest;
};

void check_range(const std::string& whose, const Range& range) {
  if (range.value < range.lowest || range.value > range.highest) {
    throw std::invalid_argument(whose + range.field + " = " + std::to_string(range.value) + ": must be " +
                                std::to_string(range.lowest) + ".." + std::to_string(range.highest));
  }
}

std::uint32_t key_of(const AnalysedMessage& message) noexcept {
  return arbitration_key({.id = message.id, .extended = message.extended});
}

}  // namespace

void check_messages(std::span<const AnalysedMessage> messages, const AnalysisOptions& options) {
  check_range("", {"bit_time_ns", options.bit_time_ns, 1, 1'000'000'000});
  for (const ErrorSource& source : options.errors) {
    check_range("errors: ", {"burst", source.burst, 0, kMostHits});
    check_range("errors: ", {"interval_ns", source.interval_ns, 0, kLongest_ns});
    check_range("errors: ", {"duration_ns", source.duration_ns, 0, 1'000'000'000'000});
  }
  for (const AnalysedMessage& message : messages) {
    const std::string whose = "message '" + message.name + "': ";
    check_range(whose, {"id", message.id, 0, message.extended ? kLargestExtendedId : kLargestId});
    check_range(whose, {"bytes", message.bytes, 0, 8});
    check_range(whose, {"period_ns", message.period_ns, 1, kLongest_ns});
    check_range(whose, {"jitter_ns", message.jitter_ns, 0, kLongest_ns});
    check_range(whose, {"deadline_ns", message.deadline_ns, 1, kLongest_ns});
    check_range(whose, {"length_bits", length_bits(message), 1, kMostBits});
  }
  const std::vector<std::size_t> order = by_priority(messages);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const AnalysedMessage& before = messages[order[i - 1]];
    const AnalysedMessage& message = messages[order[i]];
    if (key_of(before) == key_of(message)) {
      throw std::invalid_argument("message '" + message.name + "': id = " + std::to_string(message.id) +
                                  ": message '" + before.name +
                                  "' has it already. Every message needs an identifier of its own");
    }
  }
}

std::vector<std::size_t> by_priority(std::span<const AnalysedMessage> messages) {
  std::vector<std::size_t> order(messages.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, [messages](std::size_t a, std::size_t b) { return key_of(messages[a]) < key_of(messages[b]); });
  return order;
}

}  // namespace gaitway::can
