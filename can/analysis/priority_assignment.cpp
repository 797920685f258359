// The search for an order of priorities: Audsley's algorithm over transmit queues.
#include "gaitway/can/analysis/response_time.hpp"

#include <algorithm>
#include <numeric>

#include "transmit_queues.hpp"

namespace gaitway::can {
namespace {

constexpr std::uint32_t kOpen = 0;

// The open queues, by deadline minus jitter, longest first; among equals the less urgent first.
std::vector<std::size_t> candidates(std::span<const AnalysedMessage> messages, const TransmitQueues& queues) {
  const std::vector<std::size_t> order = by_priority(messages);
  std::vector<std::size_t> place(messages.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    place[order[i]] = i;
  }
  // Of a FIFO queue, the most pressing message counts.
  const auto urgency = [&](std::size_t queue) {
    std::pair<std::int64_t, std::size_t> least{std::numeric_limits<std::int64_t>::max(), messages.size()};
    for (const std::size_t i : queues.members(queue)) {
      least = std::min(least, {messages[i].deadline_ns - messages[i].jitter_ns, place[i]});
    }
    return least;
  };
  std::vector<std::size_t> all(queues.count());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::sort(all.begin(), all.end(), [&](std::size_t a, std::size_t b) { return urgency(a) > urgency(b); });
  return all;
}

bool fits(const TransmitQueues& queues, std::size_t queue) {
  const std::vector<MessageResponse> responses = queues.responses(queue);
  return std::all_of(responses.begin(), responses.end(),
                     [](const MessageResponse& response) { return response.schedulable(); });
}

}  // namespace

std::optional<std::vector<std::size_t>> best_priority_order(std::span<const AnalysedMessage> messages,
                                                            const AnalysisOptions& options) {
  TransmitQueues queues(messages, options);
  std::vector<std::size_t> open = candidates(messages, queues);
  for (const std::size_t queue : open) {
    queues.set_rank(queue, kOpen);
  }
  std::vector<std::size_t> upwards;
  auto rank = static_cast<std::uint32_t>(open.size());
  while (!open.empty()) {
    const auto found = std::find_if(open.begin(), open.end(), [&](std::size_t queue) {
      queues.set_rank(queue, rank);
      const bool serves = fits(queues, queue);
      queues.set_rank(queue, serves ? rank : kOpen);
      return serves;
    });
    if (found == open.end()) {
      return std::nullopt;
    }
    const auto members = queues.members(*found);
    upwards.insert(upwards.end(), members.rbegin(), members.rend());
    open.erase(found);
    --rank;
  }
  std::reverse(upwards.begin(), upwards.end());
  return upwards;
}

}  // namespace gaitway::can
