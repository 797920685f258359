// The bus in virtual time, exact to the bit: arbitration, lengths, errors, fault confinement (ISO 11898-1).
// Frames that nothing disturbs are taken whole; as soon as something is wrong, every station is followed bit
// by bit until all are idle again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "gaitway/can/bounded_queue.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/can/simulated/bit_station.hpp"
#include "gaitway/can/simulated/bus_faults.hpp"
#include "gaitway/can/simulated/station_set.hpp"

namespace gaitway::can {

// What a station does once it is bus-off.
enum class Recovery : std::uint8_t { automatic, on_request };

// How the bus gets at the same course of events.
enum class Detail : std::uint8_t {
  frames,  // undisturbed frames whole: fast
  bits     // each frame bit by bit: slow, to check the other one against
};

class SimulatedBus {
 public:
  static constexpr int kMaximumStations = StationSet::kCapacity;

  explicit SimulatedBus(std::int64_t bit_time_ns = 1000, Detail detail = Detail::frames);  // 1 Mb/s

  // A station on the bus with one transmit buffer, switched on and in step. Returns its number: one that was
  // detached, or the next from 0 on. Throws std::length_error beyond kMaximumStations.
  int attach();
  // The station goes for good, as without power; a frame of its own on the wire breaks off.
  void detach(int station) noexcept;
  // Detaches those of `leaving` that have nothing on the wire, and takes them out of it: what is on the wire
  // is sent to its end.
  void detach_sent(std::vector<int>& leaving) noexcept;

  // Offers a frame to the bus from `now_ns` on; it takes part in every arbitration until it has been sent,
  // and a destroyed one comes again. False, and nothing changes, when the station's transmit buffer is
  // occupied or its power is off. While the station is bus-off the frame waits: its owner may want to abort()
  // it.
  bool transmit(int station, const Frame& frame, std::int64_t now_ns) noexcept;
  [[nodiscard]] bool transmit_pending(int station) const noexcept;
  // Takes a waiting frame back; false when there is none or it is on the wire.
  bool abort(int station) noexcept;

  struct Delivery {
    Frame frame;
    int sender = 0;             // the lowest, if several sent the same frame at once
    std::int64_t start_ns = 0;  // start of frame
    std::int64_t end_ns = 0;    // last bit of end-of-frame: receivers have it; the bus is free 3 bits later
    int bits = 0;               // exact length with stuff bits, without the interframe space
    bool lost = false;          // a fault: no receiver has it, though its sender thinks that it was sent
    StationSet receivers;
    StationSet senders;
    // This station has the frame from the bus.
    [[nodiscard]] bool received_by(int station) const noexcept { return receivers.contains(station); }
    // What this station's owner had offered is sent, as far as the station can tell. False for all when the
    // frame will be repeated though some receivers have it, and when a babbling station sent it.
    [[nodiscard]] bool sent_by(int station) const noexcept { return senders.contains(station); }
  };
  // The next frame that completes at or before `until_ns`, in order of time; nothing when none does. The
  // caller handles the delivery (and may transmit() in answer, at end_ns or later) and calls again until
  // nothing comes.
  std::optional<Delivery> advance(std::int64_t until_ns) noexcept;

  // Errors that were signalled, in order of time: up to the last advance(). The oldest are dropped when
  // nobody fetches them.
  std::optional<ErrorFrame> next_error_frame() noexcept { return error_frames_.pop(); }
  // A station became error-active, error-passive or bus-off, or its power went (down) or came; in order of
  // time. The oldest are dropped when nobody fetches them.
  std::optional<StateChange> next_state_change() noexcept { return state_changes_.pop(); }
  [[nodiscard]] BusState state(int station) const noexcept;  // down: power is off
  [[nodiscard]] ErrorCounters error_counters(int station) const noexcept;
  [[nodiscard]] bool powered(int station) const noexcept { return at(station).powered; }
  [[nodiscard]] const BusStatistics& statistics() const noexcept { return statistics_; }

  // Automatic at first.
  void set_recovery(int station, Recovery recovery) noexcept;
  // A bus-off station begins to count 128 times 11 recessive bits. False: it is not bus-off, or already does.
  bool recover(int station) noexcept;
  // Its frames last (1 + ppm / 1e6) times as long.
  void set_clock_drift(int station, double ppm) noexcept;

  // Decides for each attempt, at its start, whether the frame gets lost if it is sent. Empty: none does.
  void set_loss(std::function<bool(const Frame&, std::int64_t start_ns)> loss) { loss_ = std::move(loss); }
  // From the next frame on; begins the random sequence anew.
  void set_random_faults(const RandomFaults& faults) noexcept;

  // The following happen when the bus comes to their time, or at once when it has passed. They allocate.
  // The bus is unusable from `from_ns` for `duration_ns`.
  void jam(JamKind kind, std::int64_t from_ns, std::int64_t duration_ns);
  // A station sends `frame` again and again, whatever its owner wants, as long as the time is before
  // `until_ns`. An arbitration that is lost, or an error, does not end it.
  void babble(int station, const Frame& frame, std::int64_t from_ns, std::int64_t until_ns);
  // Destroys each frame of the station, behind its arbitration, until it is bus-off: 32 failures from
  // counters at zero.
  void force_bus_off(int station, std::int64_t from_ns);
  // Without power a station neither sends nor receives nor acknowledges, and its transmit buffer is empty.
  // With power it begins with zero counters, and takes part after 11 recessive bits.
  void power_off(int station, std::int64_t at_ns);
  void power_on(int station, std::int64_t at_ns);

 private:
  struct Station {
    BitStation controller;
    bool powered = true;
    bool pending = false;    // its owner's frame
    bool babbling = false;   // sends `babble` instead
    bool forced = false;     // its frames are destroyed
    bool destroyed = false;  // its last attempt failed: the next is a retransmission
    bool babble_on_wire = false;
    Recovery recovery = Recovery::automatic;
    BusState told = BusState::error_active;  // what state changes have been told
    std::int64_t since_ns = 0;
    std::int64_t babble_since_ns = 0;
    std::int64_t not_before_ns = 0;  // suspended after a frame of its own
    double drift = 0.0;
    Frame frame;
    Frame babble;
  };
  // What is going to happen to one attempt to send.
  struct Plan {
    int flip_bit = -1;   // seen inverted
    StationSet flipped;  // by these
    FaultCause cause = FaultCause::corruption;
    StationSet omitted;
    bool lost = false;
  };
  struct Attempt {
    bool open = false;      // no error so far
    bool flipped = false;   // the planned bit has been inverted
    bool collides = false;  // stations started with the same arbitration field
    int sender = -1;
    Frame frame;
    std::int64_t start_ns = 0;
    Plan plan;
  };
  struct Action {
    enum class Kind : std::uint8_t { jam, babble, babble_end, force_bus_off, power_off, power_on };
    std::int64_t at_ns = 0;
    Kind kind = Kind::jam;
    int station = 0;
    JamKind jam = JamKind::noise;
    std::int64_t until_ns = 0;
    Frame frame;
  };
  struct Contest {
    int winner = -1;
    StationSet tied;  // all that send the winner's arbitration field
  };

  [[nodiscard]] Station& at(int station) noexcept { return stations_[static_cast<std::size_t>(station)]; }
  [[nodiscard]] const Station& at(int station) const noexcept {
    return stations_[static_cast<std::size_t>(station)];
  }
  [[nodiscard]] const Frame& offered(const Station& station) const noexcept {
    return station.babbling ? station.babble : station.frame;
  }
  // Whether and from when on the station takes part in arbitration, after something about it has changed.
  void refresh(int station) noexcept;
  [[nodiscard]] std::int64_t duration_ns(std::int64_t bits, double drift) const noexcept;
  // Of `stations` those whose error counters are not zero.
  [[nodiscard]] StationSet unclean(StationSet stations) const noexcept;
  [[nodiscard]] Contest contest(StationSet candidates, std::int64_t start_ns) const noexcept;
  // Tells a change of state, and does what follows from bus-off.
  void follow_state(int station, std::int64_t time_ns) noexcept;
  // The station takes its frame for sent.
  void settle_sender(int station, Delivery& delivery) noexcept;
  void count_sent(const Delivery& delivery, std::int64_t occupied_ns) noexcept;

  // Whole frames.
  std::optional<Delivery> advance_frames(std::int64_t stop_ns) noexcept;
  void start_next(std::int64_t stop_ns) noexcept;
  Delivery finish_frame() noexcept;

  // Bit by bit.
  std::optional<Delivery> advance_bits(std::int64_t stop_ns) noexcept;
  void enter_bits(std::int64_t now_ns) noexcept;
  void leave_bits(std::int64_t now_ns) noexcept;
  [[nodiscard]] bool quiet(std::int64_t start_ns) const noexcept;
  void begin_attempts(std::int64_t start_ns) noexcept;
  void begin_attempt(const Contest& contest, StationSet starters, std::int64_t start_ns,
                     const Plan& plan) noexcept;
  // Undisturbed bits of a lone sender, after its arbitration, look the same to all others.
  void skip_to_flip(std::int64_t stop_ns) noexcept;
  std::optional<Delivery> step_bit() noexcept;
  // Whether somebody drives the bus to dominant; counts the time for which it is busy.
  bool drive(std::int64_t start_ns, std::int64_t end_ns) noexcept;
  bool flip_due() noexcept;
  void note_errors(StationSet failed, StationSet senders, std::int64_t end_ns) noexcept;
  FaultCause cause_of(ErrorKind kind, StationSet senders) noexcept;
  void follow_sender() noexcept;
  Delivery deliver(StationSet sent, std::int64_t end_ns) noexcept;
  [[nodiscard]] std::int64_t edge_ns(std::int64_t bit) const noexcept {
    return anchor_ns_ + duration_ns(bit, anchor_drift_);
  }

  // Faults.
  Plan plan_attempt(const Contest& contest, std::int64_t start_ns) noexcept;
  void plan_random_fault(Plan& plan, const Frame& frame, StationSet receivers) noexcept;
  [[nodiscard]] StationSet receivers_of(StationSet senders) const noexcept;
  double draw_unit() noexcept;
  int draw_bit(int first, int last) noexcept;
  // Some of `from`, at least one, but not all of `all`; empty when there is no such choice.
  StationSet draw_some(StationSet from, StationSet all) noexcept;
  void schedule(const Action& action);
  void apply(const Action& action) noexcept;
  // What a plan keeps from receivers.
  void take_away(const Plan& plan, Delivery& delivery) noexcept;
  void begin_jam(const Action& action) noexcept;
  void remove(int station) noexcept;
  void switch_off(int station) noexcept;
  void switch_on(int station) noexcept;

  std::int64_t bit_time_ns_;
  Detail detail_;
  std::vector<Station> stations_;
  std::vector<int> detached_;
  // Beside the stations, since each arbitration reads them all.
  std::array<std::int64_t, StationSet::kCapacity> ready_ns_{};
  std::array<std::uint32_t, StationSet::kCapacity> key_{};
  StationSet contending_;          // stations with something to send that may send it
  StationSet present_;             // powered, and not bus-off unless on the way back
  StationSet counting_;            // stations with an error counter above zero
  std::int64_t time_ns_ = 0;       // how far the bus has run
  std::int64_t free_from_ns_ = 0;  // end of the last interframe space

  std::optional<Delivery> on_wire_;  // whole frames: the one that nothing has disturbed yet
  Plan on_wire_plan_;
  // The frame before the interframe space: where its bits lie.
  std::int64_t last_start_ns_ = 0;
  int last_sender_ = -1;
  int last_bits_ = 0;
  double last_drift_ = 0.0;

  bool bitwise_ = false;
  std::int64_t anchor_ns_ = 0;  // when bit 0 began
  double anchor_drift_ = 0.0;
  std::int64_t bit_ = 0;  // the bit that comes
  Attempt attempt_;
  StationSet valid_;         // stations that have received the frame, one bit before its end
  bool error_open_ = false;  // an error has been told and is still being signalled
  std::int64_t jam_until_ns_ = 0;

  std::vector<Action> actions_;  // in order of time
  RandomFaults faults_;
  std::mt19937_64 random_;
  std::function<bool(const Frame&, std::int64_t)> loss_;
  BusStatistics statistics_;
  BoundedQueue<ErrorFrame, 256> error_frames_;
  BoundedQueue<StateChange, 256> state_changes_;
};

}  // namespace gaitway::can
