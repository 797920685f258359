// Random sets of messages with the stations that send them, frames that realise them, and releases that do
// their worst or anything. Same seed, same everything.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <span>
#include <vector>

#include "bus_traffic.hpp"
#include "gaitway/can/analysis/response_time.hpp"
#include "gaitway/can/frame.hpp"

namespace gaitway::can::test {

class RandomMessages {
 public:
  explicit RandomMessages(std::uint32_t seed) : random_(seed) {
    bit_time_ns = std::array{1000, 1250, 2000, 8000}[below(4)];
    on_raster = chance(0.7);
    const bool some_extended = chance(0.2);
    const std::size_t count = 2 + below(29);
    make_messages(count, some_extended);
    make_frames(chance(0.5));
    make_periods(0.2 + 0.95 * uniform());
    make_stations();
  }

  std::vector<AnalysedMessage> messages;
  std::vector<int> station;    // of each message
  std::vector<Frame> longest;  // the longest frame found for each message
  std::int64_t bit_time_ns = 1000;
  bool on_raster = false;  // all releases at whole bit times

  // Messages that matter to `target` come together, as late as they may, with it; a bit before them the
  // longest one that cannot be stopped starts. From then on everything comes as early as it may. A message in
  // a FIFO queue may come later, just behind another one.
  std::vector<Release> worst_releases(std::size_t target, int frames) {
    const std::uint32_t level = level_of(target);
    std::vector<std::int64_t> first_ns(messages.size(), kStart_ns);
    std::vector<std::int64_t> delay_ns(messages.size(), 0);
    std::size_t blocker = messages.size();
    for (std::size_t i = 0; i < messages.size(); ++i) {
      if (key_of(i) <= level) {
        delay_ns[i] = messages[i].jitter_ns;
      } else if (blocker == messages.size() || frame_bits(longest[i]) > frame_bits(longest[blocker])) {
        blocker = i;
      }
    }
    if (blocker < messages.size()) {
      first_ns[blocker] -= bit_time_ns;
    }
    if (messages[target].fifo && chance(0.7)) {
      first_ns[target] += arrival_behind_another(target);
    }
    std::vector<Release> all;
    const std::int64_t until_ns = kStart_ns + span_ns(frames);
    for (std::size_t i = 0; i < messages.size(); ++i) {
      const std::int64_t nominal_ns = first_ns[i] - delay_ns[i];
      for (std::int64_t k = 0; nominal_ns + k * messages[i].period_ns < until_ns; ++k) {
        const std::int64_t at_ns = nominal_ns + k * messages[i].period_ns;
        all.push_back({std::max(at_ns, first_ns[i]), at_ns, i, longest[i]});
      }
    }
    return in_order(std::move(all), target);
  }

  // Any phase and any jitter, mostly its extremes; payloads at random, or the longest.
  std::vector<Release> random_releases(int frames) {
    const bool random_payloads = chance(0.5);
    std::vector<Release> all;
    const std::int64_t until_ns = kStart_ns + span_ns(frames);
    for (std::size_t i = 0; i < messages.size(); ++i) {
      std::int64_t last_ns = 0;
      for (std::int64_t at_ns = kStart_ns + time(messages[i].period_ns); at_ns < until_ns;
           at_ns += messages[i].period_ns) {
        const std::int64_t delay_ns = chance(0.3)   ? messages[i].jitter_ns
                                      : chance(0.4) ? 0
                                                    : time(messages[i].jitter_ns + 1);
        last_ns = std::max(last_ns, at_ns + std::min(delay_ns, messages[i].jitter_ns));
        Frame frame = longest[i];
        if (random_payloads) {
          fill(frame);
        }
        all.push_back({last_ns, at_ns, i, frame});
      }
    }
    return in_order(std::move(all), messages.size());
  }

  // Errors that leave the stations error-active: a burst, alone or with more to follow, a jam, or both. From
  // when on they come: anywhere in what worst_releases() begins with.
  ErrorModel random_errors() {
    ErrorModel model;
    const double kind = uniform();
    if (kind < 0.7) {
      const auto interval_ns = static_cast<std::int64_t>(10 + below(60)) * kLongestFrame_bits * bit_time_ns;
      model = burst_errors(1 + static_cast<int>(below(4)), chance(0.5) ? interval_ns : 0);
    }
    if (kind > 0.5) {
      const auto duration_ns = static_cast<std::int64_t>(1 + below(2000)) * bit_time_ns;
      model.push_back(jam(duration_ns, chance(0.5) ? 20 * duration_ns : 0).front());
    }
    return model;
  }
  std::int64_t error_start_ns() {
    return kStart_ns + static_cast<std::int64_t>(below(10 * kLongestFrame_bits)) * bit_time_ns;
  }

  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(random_()) % limit; }
  bool chance(double probability) { return uniform() < probability; }
  double uniform() { return static_cast<double>(random_()) / 4294967296.0; }

  [[nodiscard]] std::size_t least_urgent() const {
    std::size_t least = 0;
    for (std::size_t i = 1; i < messages.size(); ++i) {
      least = key_of(i) > key_of(least) ? i : least;
    }
    return least;
  }
  [[nodiscard]] std::uint32_t key_of(std::size_t i) const {
    return arbitration_key({.id = messages[i].id, .extended = messages[i].extended});
  }

 private:
  static constexpr std::int64_t kStart_ns = 100'000'000'000;
  static constexpr int kLongestFrame_bits = 160;

  void make_messages(std::size_t count, bool some_extended) {
    const bool full_size = chance(0.4);
    std::set<std::uint32_t> keys;
    while (messages.size() < count) {
      AnalysedMessage made;
      made.extended = some_extended && chance(0.5);
      made.id = static_cast<std::uint32_t>(random_()) & (made.extended ? kLargestExtendedId : kLargestId);
      made.bytes = full_size ? 8 : static_cast<int>(below(9));
      if (keys.insert(arbitration_key({.id = made.id, .extended = made.extended})).second) {
        messages.push_back(made);
      }
    }
  }

  void make_frames(bool exact_lengths) {
    constexpr int kTries = 24;
    for (AnalysedMessage& message : messages) {
      Frame best{.id = message.id, .size = static_cast<std::uint8_t>(message.bytes), .data = {}};
      best.extended = message.extended;
      for (int i = 0; i < kTries; ++i) {
        Frame frame = best;
        fill(frame);
        best = frame_bits(frame) > frame_bits(best) ? frame : best;
      }
      longest.push_back(best);
      if (exact_lengths) {
        message.length_bits = frame_bits(best) + kInterframeBits;
      }
    }
  }

  // Anything, or a pattern that invites stuff bits.
  void fill(Frame& frame) {
    constexpr std::array<std::uint8_t, 6> kPatterns{0x00, 0xFF, 0x0F, 0xF0, 0x83, 0x1F};
    const bool pattern = chance(0.5);
    for (std::size_t i = 0; i < frame.size; ++i) {
      frame.data[i] = pattern ? kPatterns[below(kPatterns.size())] : static_cast<std::uint8_t>(random_());
    }
  }

  // Shares of `load` at random; periods of a common base in a third of the sets, so that much comes together.
  void make_periods(double load) {
    const bool harmonic = chance(0.33);
    const double jitter = std::array{0.0, 0.5, 2.0}[below(3)];
    double sum = 0.0;
    std::vector<double> shares(messages.size());
    for (double& share : shares) {
      sum += share = 0.05 + uniform();
    }
    for (std::size_t i = 0; i < messages.size(); ++i) {
      AnalysedMessage& message = messages[i];
      const auto length_ns = static_cast<double>(length_bits(message) * bit_time_ns);
      double period_ns = length_ns * sum / (load * shares[i]);
      if (harmonic) {
        const double base_ns = 500.0 * static_cast<double>(bit_time_ns);
        period_ns = base_ns * std::exp2(std::round(std::log2(period_ns / base_ns)));
      }
      message.period_ns = rastered(static_cast<std::int64_t>(period_ns));
      message.jitter_ns = rastered(static_cast<std::int64_t>(jitter * uniform() * period_ns));
      message.deadline_ns = static_cast<std::int64_t>((0.3 + 1.5 * uniform()) * period_ns);
    }
  }

  // When one of the others in its queue comes for the second time or later, since the start.
  std::int64_t arrival_behind_another(std::size_t target) {
    const AnalysedMessage& other = messages[below(messages.size())];
    const auto again = static_cast<std::int64_t>(1 + below(3)) + other.jitter_ns / other.period_ns;
    return other.fifo == messages[target].fifo ? again * other.period_ns - other.jitter_ns : 0;
  }

  // One a message, or a few with several each, some of them with a FIFO queue.
  void make_stations() {
    const bool few = chance(0.5);
    const std::size_t stations = 1 + below(6);
    const double fifos = chance(0.5) ? 0.5 : 0.0;
    std::vector<bool> is_fifo(stations);
    for (std::size_t i = 0; i < stations; ++i) {
      is_fifo[i] = chance(fifos);
    }
    for (std::size_t i = 0; i < messages.size(); ++i) {
      station.push_back(static_cast<int>(few ? below(stations) : i));
      if (few && is_fifo[static_cast<std::size_t>(station[i])]) {
        messages[i].fifo = station[i];
      }
    }
  }

  [[nodiscard]] std::int64_t rastered(std::int64_t time_ns) const {
    return on_raster ? std::max<std::int64_t>(time_ns / bit_time_ns, 0) * bit_time_ns : time_ns;
  }
  std::int64_t time(std::int64_t limit_ns) {
    return rastered(static_cast<std::int64_t>(uniform() * static_cast<double>(limit_ns)));
  }
  // In which about so many frames are released.
  [[nodiscard]] std::int64_t span_ns(int frames) const {
    double per_ns = 0.0;
    for (const AnalysedMessage& message : messages) {
      per_ns += 1.0 / static_cast<double>(message.period_ns);
    }
    return static_cast<std::int64_t>(frames / per_ns);
  }
  [[nodiscard]] std::uint32_t level_of(std::size_t target) const {
    std::uint32_t level = key_of(target);
    for (std::size_t i = 0; i < messages.size(); ++i) {
      if (messages[target].fifo && messages[i].fifo == messages[target].fifo) {
        level = std::max(level, key_of(i));
      }
    }
    return level;
  }
  static std::vector<Release> in_order(std::vector<Release> all, std::size_t last) {
    std::stable_sort(all.begin(), all.end(), [last](const Release& a, const Release& b) {
      return std::pair(a.at_ns, a.message == last) < std::pair(b.at_ns, b.message == last);
    });
    return all;
  }

  std::mt19937 random_;
};

}  // namespace gaitway::can::test
