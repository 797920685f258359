// A bad wireless link in virtual time: what is sent at one end comes out at the other late, out of order,
// twice or not at all. It is told the time, and the same seed and packets give the same deliveries.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

#include "gaitway/facts/random_stream.hpp"
#include "gaitway/process/duration_histogram.hpp"
#include "tools/wireless/outage_schedule.hpp"

namespace gaitway::tools {

using Packet = std::vector<std::uint8_t>;

enum class LinkEnd : std::size_t { robot, client };
[[nodiscard]] constexpr LinkEnd other_end(LinkEnd end) {
  return end == LinkEnd::robot ? LinkEnd::client : LinkEnd::robot;
}

// What happens to the packets of one direction. Shares are 0..1 of all packets.
struct DirectionSettings {
  double rate_bit_s = 0.0;           // 0: unlimited
  std::size_t queue_bytes = 65'536;  // waiting and in transmission; what does not fit is lost
  std::int64_t delay_ns = 0;         // from the end of the transmission to the arrival
  std::int64_t jitter_ns = 0;        // the delay differs by up to so much either way, every value as likely
  double loss = 0.0;
  // Losses come together, by the packet or by the clock; without either each is lost independently.
  std::optional<double> mean_burst{};          // of consecutive losses
  std::optional<std::int64_t> mean_fade_ns{};  // of a time in which all is lost
  double reordered = 0.0;                      // arrive late, while later ones overtake them
  std::int64_t held_back_ns = 10'000'000;      // by so much
  double duplicated = 0.0;                     // are transmitted twice, which takes the time of two
};

struct LinkSettings {
  std::array<DirectionSettings, 2> from;  // by LinkEnd
  // During an outage packets wait for its end, as a radio's queue may have it; otherwise they are lost.
  bool outages_hold = false;
};

struct Delivery {
  LinkEnd to = LinkEnd::robot;
  std::int64_t at_ns = 0;
  std::int64_t sent_ns = 0;
  Packet packet;
};

// Of the packets that one end sent.
struct DirectionStatistics {
  std::uint64_t sent = 0, sent_bytes = 0;
  std::uint64_t delivered = 0, delivered_bytes = 0;                       // with duplicates
  std::uint64_t lost_on_air = 0, lost_in_queue = 0, lost_in_outages = 0;  // of duplicates, too
  std::uint64_t duplicated = 0, held_back = 0;
  process::DurationHistogram queue_delay;  // until the transmission begins
};

// Losses as in Gilbert's model: a good state that loses nothing and a bad one that loses all. The states last
// so many packets, or so long, whether or not packets come meanwhile: exponentially distributed times.
class AirLoss {
 public:
  AirLoss(const DirectionSettings& settings, facts::RandomStream random);
  // Of the next packet, whose transmission ends then. Times never go back.
  [[nodiscard]] bool loses(std::int64_t at_ns) noexcept;

 private:
  [[nodiscard]] bool loses_next() noexcept;
  [[nodiscard]] std::int64_t lasts_ns() noexcept;  // the present state

  facts::RandomStream random_;
  double to_bad_ = 0.0, to_good_ = 1.0;
  double mean_good_ns_ = 0.0, mean_bad_ns_ = 0.0;  // of fades
  std::optional<std::int64_t> changes_ns_;
  bool by_time_ = false, bad_ = false;
};

class LinkEmulator {
 public:
  // Throws std::invalid_argument with the rule that the settings break.
  LinkEmulator(const LinkSettings& settings, std::uint64_t seed);
  LinkEmulator(const LinkEmulator&) = delete;
  LinkEmulator& operator=(const LinkEmulator&) = delete;

  // Times of all calls never go back; one that does counts as the latest before.
  void send(LinkEnd from, std::int64_t now_ns, Packet packet);
  // What has arrived by now, in the order of arrival; nothing: no more.
  [[nodiscard]] std::optional<Delivery> receive(std::int64_t now_ns);
  // When receive() may have something again, as far as is known now.
  [[nodiscard]] std::optional<std::int64_t> next_ns() const;
  // From now on, or later. The past stays as it was.
  void add_outage(std::int64_t now_ns, Outage outage);

  [[nodiscard]] const OutageSchedule& outages() const { return outages_; }
  [[nodiscard]] const DirectionStatistics& statistics(LinkEnd from) const {
    return directions_[static_cast<std::size_t>(from)].statistics;
  }
  [[nodiscard]] std::size_t under_way(LinkEnd from) const;  // packets and duplicates neither arrived nor lost

 private:
  static constexpr std::int64_t kNever_ns = std::numeric_limits<std::int64_t>::max();

  struct Waiting {
    Packet packet;
    std::int64_t sent_ns = 0;
    bool copy = false;  // it was transmitted before
  };
  struct Flying {
    std::int64_t due_ns = 0;
    std::uint64_t number = 0;  // among those due at the same instant, the first one comes first
    std::int64_t sent_ns = 0;
    Packet packet;
  };

  // Queue → transmission at the rate → air → exit, which is never faster than the rate either.
  class Direction {
   public:
    Direction(LinkEnd from, const LinkSettings& settings, const OutageSchedule& outages, std::uint64_t seed);

    void send(std::int64_t now_ns, Packet packet);
    void run(std::int64_t until_ns);
    [[nodiscard]] std::int64_t next_ns() const;

    DirectionStatistics statistics;
    std::deque<Delivery> arrived;
    [[nodiscard]] std::size_t under_way() const { return waiting_.size() + air_.size() + arrived.size(); }

   private:
    [[nodiscard]] std::int64_t transmission_ns(const Packet& packet) const;
    [[nodiscard]] std::int64_t exit_ns() const;
    void begin_transmission(std::int64_t at_ns);
    void end_transmission();
    void leave_queue(std::int64_t at_ns);
    void enter_air(Packet packet, std::int64_t sent_ns, std::int64_t at_ns);
    void leave_air();
    void push_air(Flying flying);
    Flying pop_air();

    LinkEnd to_;
    DirectionSettings settings_;
    bool outages_hold_;
    const OutageSchedule& outages_;
    AirLoss loss_;
    facts::RandomStream jitter_, reordering_, duplication_;

    std::deque<Waiting> waiting_;  // the first one is in transmission
    std::size_t waiting_bytes_ = 0;
    std::int64_t begun_ns_ = 0, ends_ns_ = kNever_ns;  // of that transmission
    std::vector<Flying> air_;                          // a heap
    std::uint64_t flights_ = 0;
    std::int64_t last_due_ns_ = 0, last_exit_ns_ = 0, exit_from_ns_ = 0;
  };

  void run(std::int64_t now_ns);

  OutageSchedule outages_;
  std::int64_t now_ns_ = std::numeric_limits<std::int64_t>::min();
  std::array<Direction, 2> directions_;
};

}  // namespace gaitway::tools
