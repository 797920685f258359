#include "tools/wireless/link_emulator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace gaitway::tools {
namespace {

constexpr std::size_t kLeastQueue_bytes = 2000;  // a whole packet fits
// One stream for each thing that is drawn: changing one setting leaves what the others draw.
enum Stream : std::uint64_t { kLossStream = 1, kJitterStream, kReorderStream, kDuplicateStream, kStreams };

facts::RandomStream stream(std::uint64_t seed, LinkEnd from, Stream name) {
  return {seed, static_cast<std::uint64_t>(from) * kStreams + name};
}

void require(bool holds, const char* rule) {
  if (!holds) throw std::invalid_argument(rule);
}

bool is_share(double value) {
  return value >= 0.0 && value <= 1.0;
}

void check(const DirectionSettings& settings) {
  require(settings.rate_bit_s == 0.0 || (settings.rate_bit_s >= 1e3 && settings.rate_bit_s <= 1e12),
          "the rate must lie between 1kbit and 1000Gbit, or be left out");
  require(settings.queue_bytes >= kLeastQueue_bytes, "the queue must hold 2000 bytes or more");
  require(settings.delay_ns >= 0, "the delay must not be negative");
  require(settings.jitter_ns >= 0 && settings.jitter_ns <= settings.delay_ns,
          "the jitter must be no larger than the delay: nothing arrives before it was sent");
  require(is_share(settings.loss), "the loss must lie between 0% and 100%");
  require(is_share(settings.reordered), "the share of reordered packets must lie between 0% and 100%");
  require(is_share(settings.duplicated), "the share of duplicates must lie between 0% and 100%");
  require(settings.held_back_ns >= 0, "a reordered packet must be held back by 0 or more");
  require(!settings.mean_burst || settings.loss == 1.0 ||
              *settings.mean_burst >= std::max(1.0, settings.loss / (1.0 - settings.loss)),
          "the mean burst must be 1 packet or more, and for a loss P above 50% P / (100% - P) or more");
  require(!settings.mean_fade_ns || !settings.mean_burst,
          "losses last by the packet or by the clock, not both: give a burst or a fade");
  require(!settings.mean_fade_ns || *settings.mean_fade_ns >= 1'000, "the mean fade must be 1us or more");
}

const DirectionSettings& checked(const DirectionSettings& settings) {
  check(settings);
  return settings;
}

}  // namespace

AirLoss::AirLoss(const DirectionSettings& settings, facts::RandomStream random)
    : random_(random), by_time_(settings.mean_fade_ns && settings.loss > 0.0 && settings.loss < 1.0) {
  const double loss = settings.loss;
  if (loss >= 1.0) {
    to_bad_ = 1.0;
    to_good_ = 0.0;
  } else {
    // A burst lasts 1 / to_good packets, and the share of bad ones is to_bad / (to_bad + to_good).
    to_good_ = settings.mean_burst ? 1.0 / *settings.mean_burst : 1.0 - loss;
    to_bad_ = to_good_ * loss / (1.0 - loss);
  }
  if (by_time_) {
    mean_bad_ns_ = static_cast<double>(*settings.mean_fade_ns);
    mean_good_ns_ = mean_bad_ns_ * (1.0 - loss) / loss;
  }
  bad_ = random_.uniform() < loss;
}

bool AirLoss::loses(std::int64_t at_ns) noexcept {
  if (!by_time_) {
    return loses_next();
  }
  if (!changes_ns_) {
    changes_ns_ = at_ns + lasts_ns();
  }
  while (at_ns >= *changes_ns_) {
    bad_ = !bad_;
    *changes_ns_ += lasts_ns();
  }
  return bad_;
}

bool AirLoss::loses_next() noexcept {
  const double changes = random_.uniform();
  bad_ = bad_ ? changes >= to_good_ : changes < to_bad_;
  return bad_;
}

std::int64_t AirLoss::lasts_ns() noexcept {
  const double mean_ns = bad_ ? mean_bad_ns_ : mean_good_ns_;
  return 1 + static_cast<std::int64_t>(-mean_ns * std::log1p(-random_.uniform()));
}

LinkEmulator::Direction::Direction(LinkEnd from, const LinkSettings& settings, const OutageSchedule& outages,
                                   std::uint64_t seed)
    : to_(other_end(from)),
      settings_(checked(settings.from[static_cast<std::size_t>(from)])),
      outages_hold_(settings.outages_hold),
      outages_(outages),
      loss_(settings_, stream(seed, from, kLossStream)),
      jitter_(stream(seed, from, kJitterStream)),
      reordering_(stream(seed, from, kReorderStream)),
      duplication_(stream(seed, from, kDuplicateStream)) {}

void LinkEmulator::Direction::send(std::int64_t now_ns, Packet packet) {
  ++statistics.sent;
  statistics.sent_bytes += packet.size();
  if (waiting_bytes_ + packet.size() > settings_.queue_bytes) {
    ++statistics.lost_in_queue;
    return;
  }
  waiting_bytes_ += packet.size();
  waiting_.push_back({std::move(packet), now_ns});
  if (waiting_.size() == 1) begin_transmission(now_ns);
}

void LinkEmulator::Direction::run(std::int64_t until_ns) {
  for (;;) {
    const std::int64_t exit = exit_ns();
    if (std::min(ends_ns_, exit) > until_ns) return;
    if (ends_ns_ <= exit) {
      end_transmission();
    } else {
      leave_air();
    }
  }
}

std::int64_t LinkEmulator::Direction::next_ns() const {
  if (!arrived.empty()) return arrived.front().at_ns;
  return std::min(ends_ns_, exit_ns());
}

std::int64_t LinkEmulator::Direction::transmission_ns(const Packet& packet) const {
  if (settings_.rate_bit_s == 0.0) return 0;
  return static_cast<std::int64_t>(
      std::ceil(static_cast<double>(packet.size()) * 8.0 * 1e9 / settings_.rate_bit_s));
}

std::int64_t LinkEmulator::Direction::exit_ns() const {
  if (air_.empty()) return kNever_ns;
  return std::max({air_.front().due_ns, last_exit_ns_ + transmission_ns(air_.front().packet), exit_from_ns_});
}

void LinkEmulator::Direction::begin_transmission(std::int64_t at_ns) {
  const auto outage = outages_hold_ ? outages_.covering(at_ns) : std::nullopt;
  begun_ns_ = outage ? outage->end_ns : at_ns;
  ends_ns_ = begun_ns_ + transmission_ns(waiting_.front().packet);
}

void LinkEmulator::Direction::end_transmission() {
  Waiting& first = waiting_.front();
  const std::int64_t at_ns = ends_ns_;
  const auto outage = outages_.overlapping(begun_ns_, at_ns);
  if (outage && outages_hold_) {  // it began meanwhile: once more when it is over
    begin_transmission(outage->end_ns);
    return;
  }
  if (!first.copy) statistics.queue_delay.add(begun_ns_ - first.sent_ns);
  const bool twice = !first.copy && duplication_.uniform() < settings_.duplicated;
  Packet packet = twice ? first.packet : std::move(first.packet);
  const std::int64_t sent_ns = first.sent_ns;
  const std::size_t size = packet.size();
  if (outage) {
    ++statistics.lost_in_outages;
  } else if (loss_.loses(at_ns)) {
    ++statistics.lost_on_air;
  } else {
    enter_air(std::move(packet), sent_ns, at_ns);
  }
  if (twice) {
    ++statistics.duplicated;
    first.copy = true;
    begin_transmission(at_ns);
    return;
  }
  waiting_bytes_ -= size;
  leave_queue(at_ns);
}

void LinkEmulator::Direction::leave_queue(std::int64_t at_ns) {
  waiting_.pop_front();
  ends_ns_ = kNever_ns;
  if (!waiting_.empty()) begin_transmission(at_ns);
}

void LinkEmulator::Direction::enter_air(Packet packet, std::int64_t sent_ns, std::int64_t at_ns) {
  const auto jitter_ns =
      static_cast<std::int64_t>((2.0 * jitter_.uniform() - 1.0) * static_cast<double>(settings_.jitter_ns));
  std::int64_t due_ns = at_ns + settings_.delay_ns + jitter_ns;
  if (reordering_.uniform() < settings_.reordered) {
    ++statistics.held_back;
    due_ns += settings_.held_back_ns;
  } else {
    due_ns = last_due_ns_ = std::max(due_ns, last_due_ns_);  // jitter alone reorders nothing
  }
  push_air({due_ns, flights_++, sent_ns, std::move(packet)});
}

void LinkEmulator::Direction::leave_air() {
  const std::int64_t at_ns = exit_ns();
  Flying first = pop_air();
  if (const auto outage = outages_.covering(at_ns)) {
    exit_from_ns_ = at_ns;  // what waited behind it does not come before
    if (outages_hold_) {
      first.due_ns = outage->end_ns;
      push_air(std::move(first));
    } else {
      ++statistics.lost_in_outages;
    }
    return;
  }
  last_exit_ns_ = at_ns;
  ++statistics.delivered;
  statistics.delivered_bytes += first.packet.size();
  arrived.push_back({to_, at_ns, first.sent_ns, std::move(first.packet)});
}

void LinkEmulator::Direction::push_air(Flying flying) {
  air_.push_back(std::move(flying));
  std::ranges::push_heap(air_, std::ranges::greater{},
                         [](const Flying& one) { return std::pair(one.due_ns, one.number); });
}

LinkEmulator::Flying LinkEmulator::Direction::pop_air() {
  std::ranges::pop_heap(air_, std::ranges::greater{},
                        [](const Flying& one) { return std::pair(one.due_ns, one.number); });
  Flying first = std::move(air_.back());
  air_.pop_back();
  return first;
}

LinkEmulator::LinkEmulator(const LinkSettings& settings, std::uint64_t seed)
    : directions_{Direction(LinkEnd::robot, settings, outages_, seed),
                  Direction(LinkEnd::client, settings, outages_, seed)} {}

void LinkEmulator::send(LinkEnd from, std::int64_t now_ns, Packet packet) {
  run(now_ns);
  directions_[static_cast<std::size_t>(from)].send(now_ns_, std::move(packet));
}

std::optional<Delivery> LinkEmulator::receive(std::int64_t now_ns) {
  run(now_ns);
  Direction* first = nullptr;
  for (Direction& each : directions_) {
    if (!each.arrived.empty() &&
        (first == nullptr || each.arrived.front().at_ns < first->arrived.front().at_ns)) {
      first = &each;
    }
  }
  if (first == nullptr) return std::nullopt;
  Delivery delivery = std::move(first->arrived.front());
  first->arrived.pop_front();
  return delivery;
}

std::optional<std::int64_t> LinkEmulator::next_ns() const {
  const std::int64_t next_ns = std::min(directions_[0].next_ns(), directions_[1].next_ns());
  return next_ns == kNever_ns ? std::nullopt : std::optional(next_ns);
}

void LinkEmulator::add_outage(std::int64_t now_ns, Outage outage) {
  run(now_ns);
  outage.begin_ns = std::max(outage.begin_ns, now_ns_ + 1);  // what came by now has come
  outages_.add(outage);
}

std::size_t LinkEmulator::under_way(LinkEnd from) const {
  return directions_[static_cast<std::size_t>(from)].under_way();
}

void LinkEmulator::run(std::int64_t now_ns) {
  now_ns_ = std::max(now_ns_, now_ns);
  for (Direction& each : directions_) each.run(now_ns_);
}

}  // namespace gaitway::tools
