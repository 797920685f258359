// The worst case of one transmit queue: its busy periods and the queueing delays within them.
#include "transmit_queues.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace gaitway::can {
namespace {

using Time = std::optional<std::int64_t>;

constexpr int kMostSteps = 200'000;
constexpr std::int64_t kMostInstances = 1'000'000;
// Of the sum of shares; a bus this close to full needs more steps than there are.
constexpr double kRounding = 1e-9;

constexpr std::int64_t ceil_div(std::int64_t value, std::int64_t divisor) noexcept {
  return (value + divisor - 1) / divisor;
}

// The least x >= from with x = next(x), for a next() that never falls and next(from) >= from.
template <class Next>
Time least_fixed_point(std::int64_t from, Next next) {
  for (int step = 0; step < kMostSteps; ++step) {
    const std::int64_t value = next(from);
    if (value == from) {
      return value;
    }
    from = value;
  }
  return std::nullopt;
}

Time later(Time a, Time b) noexcept {
  return a && b ? Time(std::max(*a, *b)) : std::nullopt;
}

}  // namespace

TransmitQueues::TransmitQueues(std::span<const AnalysedMessage> messages, const AnalysisOptions& options)
    : options_(options) {
  check_messages(messages, options);
  const std::vector<std::size_t> order = by_priority(messages);
  messages_.resize(messages.size());
  known_.resize(messages.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const AnalysedMessage& given = messages[order[rank]];
    const int bits = length_bits(given);
    messages_[order[rank]] = {.rank = static_cast<std::uint32_t>(rank),
                              .queue = 0,
                              .period_ns = given.period_ns,
                              .jitter_ns = given.jitter_ns,
                              .length_ns = bits * options.bit_time_ns,
                              .arbitration_jitter_ns = given.jitter_ns};
    known_[order[rank]] = {.length_bits = bits,
                           .blocking_ns = 0,
                           .worst_response_ns = std::nullopt,
                           .deadline_ns = given.deadline_ns,
                           .instances = 0};
  }
  group(messages);
  by_period_.resize(messages.size());
  std::iota(by_period_.begin(), by_period_.end(), std::size_t{0});
  std::sort(by_period_.begin(), by_period_.end(), [this](std::size_t a, std::size_t b) {
    return std::pair(messages_[a].period_ns, messages_[a].jitter_ns) <
           std::pair(messages_[b].period_ns, messages_[b].jitter_ns);
  });
}

void TransmitQueues::group(std::span<const AnalysedMessage> messages) {
  std::map<int, std::size_t> fifos;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    std::size_t queue = queues_.size();
    if (messages[i].fifo) {
      queue = fifos.try_emplace(*messages[i].fifo, queue).first->second;
    }
    if (queue == queues_.size()) {
      queues_.emplace_back();
    }
    queues_[queue].push_back(i);
    messages_[i].queue = queue;
  }
}

void TransmitQueues::set_rank(std::size_t queue, std::uint32_t rank) noexcept {
  for (const std::size_t message : queues_[queue]) {
    messages_[message].rank = rank;
  }
}

// Whether frames of that rank and above can be stuck in the queue behind less urgent ones. Where all of a
// queue is more urgent, it does not matter which of its frames is at its head.
bool TransmitQueues::holds_back(std::size_t queue, std::uint32_t rank) const noexcept {
  return std::any_of(queues_[queue].begin(), queues_[queue].end(),
                     [&](std::size_t message) { return messages_[message].rank > rank; });
}

TransmitQueues::Level TransmitQueues::level_of(std::size_t queue) const {
  // A FIFO queue gets through to the bus no faster than its least urgent message.
  std::uint32_t rank = 0;
  std::int64_t longest_ns = 0;
  for (const std::size_t message : queues_[queue]) {
    rank = std::max(rank, messages_[message].rank);
    longest_ns = std::max(longest_ns, messages_[message].length_ns);
  }
  Level level;
  for (const std::size_t i : by_period_) {
    const Message& message = messages_[i];
    if (message.queue == queue) {
      continue;
    }
    if (message.rank > rank) {
      level.blocking_ns = std::max(level.blocking_ns, message.length_ns);
      continue;
    }
    longest_ns = std::max(longest_ns, message.length_ns);
    Time jitter_ns = message.jitter_ns;
    if (queues_[message.queue].size() > 1 && holds_back(message.queue, rank)) {
      jitter_ns = message.arbitration_jitter_ns;
    }
    if (!jitter_ns) {
      level.bounded = false;
      continue;
    }
    if (!level.above.empty() && level.above.back().period_ns == message.period_ns &&
        level.above.back().jitter_ns == *jitter_ns) {
      level.above.back().length_ns += message.length_ns;
    } else {
      level.above.push_back({message.period_ns, *jitter_ns, message.length_ns});
    }
  }
  level.error_ns = kErrorBits * options_.bit_time_ns + longest_ns;
  level.bounded = level.bounded && utilisation(queue, level) <= 1.0 + kRounding;
  return level;
}

double TransmitQueues::utilisation(std::size_t queue, const Level& level) const noexcept {
  const auto share = [](std::int64_t part, std::int64_t whole) {
    return static_cast<double>(part) / static_cast<double>(whole);
  };
  double sum = 0.0;
  for (const Interference& other : level.above) {
    sum += share(other.length_ns, other.period_ns);
  }
  for (const std::size_t i : queues_[queue]) {
    sum += share(messages_[i].length_ns, messages_[i].period_ns);
  }
  for (const ErrorSource& source : options_.errors) {
    if (source.burst > 0 && source.interval_ns > 0) {
      sum += share(source.duration_ns + level.error_ns, source.interval_ns);
    }
  }
  return sum;
}

std::int64_t TransmitQueues::demand_ns(const Level& level, std::int64_t window_ns) const noexcept {
  std::int64_t sum_ns = 0;
  for (const Interference& other : level.above) {
    sum_ns += ceil_div(window_ns + other.jitter_ns, other.period_ns) * other.length_ns;
  }
  return sum_ns;
}

std::int64_t TransmitQueues::error_delay_ns(const Level& level, std::int64_t window_ns) const noexcept {
  std::int64_t sum_ns = 0;
  for (const ErrorSource& source : options_.errors) {
    sum_ns += source.hits(window_ns) * (source.duration_ns + level.error_ns);
  }
  return sum_ns;
}

// The longest time for which the bus carries nothing but the blocking frame, this queue and what is more
// urgent: the smallest t > 0 with t = B + E(t) + sum over all of them of ceil((t + J) / T) C.
Time TransmitQueues::busy_period_ns(std::size_t queue, const Level& level) const {
  const std::vector<std::size_t>& own = queues_[queue];
  const std::int64_t once_ns =
      std::accumulate(own.begin(), own.end(), std::int64_t{0},
                      [this](std::int64_t sum, std::size_t i) { return sum + messages_[i].length_ns; });
  return least_fixed_point(once_ns, [&](std::int64_t t_ns) {
    std::int64_t sum_ns = level.blocking_ns + error_delay_ns(level, t_ns) + demand_ns(level, t_ns);
    for (const std::size_t i : own) {
      const Message& message = messages_[i];
      sum_ns += ceil_div(t_ns + message.jitter_ns, message.period_ns) * message.length_ns;
    }
    return sum_ns;
  });
}

// When a frame starts that has `ahead` of it in its queue: the smallest w with
// w = B + E(w + C) + ahead + sum over the more urgent ones of ceil((w + J + tau_bit) / T) C.
Time TransmitQueues::start_ns(const Level& level, std::int64_t ahead_ns, std::int64_t length_ns,
                              std::int64_t from_ns) const {
  return least_fixed_point(std::max(from_ns, level.blocking_ns + ahead_ns), [&](std::int64_t w_ns) {
    return level.blocking_ns + error_delay_ns(level, w_ns + length_ns) + ahead_ns +
           demand_ns(level, w_ns + options_.bit_time_ns);
  });
}

// What is sent of the queue before instance `instance` of a message that arrives in it at `arrival`: the
// earlier instances, and everything else that may have come up to the same instant.
std::int64_t TransmitQueues::ahead_ns(std::size_t message, std::int64_t arrival_ns,
                                      std::int64_t instance) const noexcept {
  std::int64_t sum_ns = instance * messages_[message].length_ns;
  for (const std::size_t i : queues_[messages_[message].queue]) {
    if (i != message) {
      const Message& other = messages_[i];
      sum_ns += ((arrival_ns + other.jitter_ns) / other.period_ns + 1) * other.length_ns;
    }
  }
  return sum_ns;
}

// Instances q = 0, 1, ... of the message, the first of which arrives with its whole jitter at the start of
// the busy period, the others at qT or, where that lies past its end, as late as the busy period lasts.
Time TransmitQueues::worst_own_instance_ns(std::size_t message, const Level& level,
                                           std::int64_t busy_ns) const {
  const Message& own = messages_[message];
  const std::int64_t instances = ceil_div(busy_ns + own.jitter_ns, own.period_ns);
  std::int64_t worst_ns = 0, from_ns = 0;
  for (std::int64_t q = 0; q < instances; ++q) {
    const std::int64_t at_ns = std::min(q * own.period_ns, busy_ns - 1);
    const Time start = start_ns(level, ahead_ns(message, at_ns, q), own.length_ns, from_ns);
    if (!start) {
      return std::nullopt;
    }
    worst_ns = std::max(worst_ns, own.jitter_ns + *start - q * own.period_ns + own.length_ns);
    from_ns = *start + own.length_ns;
  }
  return worst_ns;
}

// The message arrives, with its whole jitter, just behind any one of the other messages of its FIFO queue.
Time TransmitQueues::worst_behind_others_ns(std::size_t message, const Level& level,
                                            std::int64_t busy_ns) const {
  const Message& own = messages_[message];
  std::int64_t worst_ns = 0;
  for (const std::size_t i : queues_[own.queue]) {
    const Message& other = messages_[i];
    for (std::int64_t n = i == message ? kMostInstances : ceil_div(other.jitter_ns, other.period_ns);
         n < kMostInstances && n * other.period_ns - other.jitter_ns < busy_ns; ++n) {
      const std::int64_t at_ns = n * other.period_ns - other.jitter_ns;
      const Time start = start_ns(level, ahead_ns(message, at_ns, at_ns / own.period_ns), own.length_ns, 0);
      if (!start) {
        return std::nullopt;
      }
      worst_ns = std::max(worst_ns, *start - at_ns + own.jitter_ns + own.length_ns);
    }
  }
  return worst_ns;
}

std::vector<MessageResponse> TransmitQueues::responses(std::size_t queue) const {
  const Level level = level_of(queue);
  // 0: it does not end.
  const std::int64_t busy_ns = level.bounded ? busy_period_ns(queue, level).value_or(0) : 0;
  std::vector<MessageResponse> all;
  for (const std::size_t i : queues_[queue]) {
    MessageResponse& response = all.emplace_back(known_[i]);
    response.blocking_ns = level.blocking_ns;
    if (busy_ns == 0) {
      continue;
    }
    response.instances = ceil_div(busy_ns + messages_[i].jitter_ns, messages_[i].period_ns);
    if (response.instances <= kMostInstances) {
      response.worst_response_ns =
          later(worst_own_instance_ns(i, level, busy_ns), worst_behind_others_ns(i, level, busy_ns));
    }
  }
  return all;
}

bool TransmitQueues::update_holdups(std::size_t queue, std::span<const MessageResponse> responses,
                                    bool give_up) noexcept {
  bool news = false;
  for (std::size_t k = 0; k < responses.size() && queues_[queue].size() > 1; ++k) {
    Message& message = messages_[queues_[queue][k]];
    Time jitter_ns = std::nullopt;
    if (responses[k].worst_response_ns) {
      jitter_ns = *responses[k].worst_response_ns - message.length_ns;
    }
    if (jitter_ns != message.arbitration_jitter_ns) {
      message.arbitration_jitter_ns = give_up ? std::nullopt : jitter_ns;
      news = true;
    }
  }
  return news;
}

}  // namespace gaitway::can
