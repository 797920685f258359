// Response times of a whole bus: every queue in turn, and again as long as FIFO queues delay each other more;
// and, by bisection over the bit time, how slow the bus may be.
#include "gaitway/can/analysis/response_time.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/can/frame.hpp"
#include "transmit_queues.hpp"

namespace gaitway::can {
namespace {

// Delays of FIFO queues that still grow after so many rounds are taken for unbounded.
constexpr int kMostRounds = 1000;

}  // namespace

int length_bits(const AnalysedMessage& message) noexcept {
  return message.length_bits.value_or(worst_case_bits(message.bytes, message.extended));
}

std::vector<MessageResponse> response_times(std::span<const AnalysedMessage> messages,
                                            const AnalysisOptions& options) {
  TransmitQueues queues(messages, options);
  std::vector<MessageResponse> all(messages.size());
  bool settled = false;
  for (int round = 0; !settled; ++round) {
    settled = true;
    for (std::size_t queue = 0; queue < queues.count(); ++queue) {
      const std::vector<MessageResponse> responses = queues.responses(queue);
      for (std::size_t k = 0; k < responses.size(); ++k) {
        all[queues.members(queue)[k]] = responses[k];
      }
      settled = !queues.update_holdups(queue, responses, round >= kMostRounds) && settled;
    }
  }
  return all;
}

bool all_schedulable(std::span<const AnalysedMessage> messages, const AnalysisOptions& options) {
  const std::vector<MessageResponse> responses = response_times(messages, options);
  return std::all_of(responses.begin(), responses.end(),
                     [](const MessageResponse& response) { return response.schedulable(); });
}

double bus_load(std::span<const AnalysedMessage> messages, std::int64_t bit_time_ns) {
  double load = 0.0;
  for (const AnalysedMessage& message : messages) {
    load += static_cast<double>(length_bits(message)) * static_cast<double>(bit_time_ns) /
            static_cast<double>(message.period_ns);
  }
  return load;
}

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
