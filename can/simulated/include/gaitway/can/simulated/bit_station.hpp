// One CAN controller at the level of bits (ISO 11898-1, medium access control): what it drives onto the bus
// in each bit, and how it follows what it sees there. Error flags, delimiters, intermission, overload frames,
// passive flags and the way back from bus-off come out of these rules; nothing above has to plan them.
#pragma once

#include <cstdint>

#include "gaitway/can/simulated/fault_confinement.hpp"
#include "gaitway/can/simulated/wire_frame.hpp"

namespace gaitway::can {

// How a station detects that a frame is broken.
enum class ErrorKind : std::uint8_t {
  bit,         // a transmitter sees another level than it sends
  stuff,       // six equal bits in a row
  crc,         // the check sum does not fit
  form,        // a dominant bit where the frame's form has none
  acknowledge  // no receiver acknowledges
};

class BitStation {
 public:
  enum class Event : std::uint8_t {
    none,
    error,     // it goes on with an error flag or is bus-off; error_kind() says what it saw
    valid,     // it has received the frame; one more bit follows
    sent,      // it has sent its frame
    suspend,   // its intermission is over and, passive, it waits eight more bits before it sends again
    recovered  // it is back from bus-off
  };

  // The frame to send; the next bit is its start of frame. Only while idle().
  void start_sending(const Frame& frame) noexcept;
  // It has sent `bits` bits, undisturbed. Only while sending.
  void skip_sending(int bits) noexcept { position_ = bits; }
  // It follows a frame of another station, as far as `reader` has come.
  void follow(const FrameReader& reader) noexcept;
  [[nodiscard]] const WireFrame& wire() const noexcept { return wire_; }
  // What it does in the bit that comes.
  [[nodiscard]] bool drives_dominant() const noexcept;
  // The bit as it sees it.
  Event sample(bool dominant) noexcept;

  // Counters to zero; part of the bus after 11 recessive bits.
  void power_on() noexcept;
  // Begins to count 128 times 11 recessive bits. Only while bus-off.
  void recover() noexcept;
  // Noise drowns the bus from the next bit on: a frame that is sent or received breaks, and the station then
  // waits for 11 recessive bits. True: there was a frame.
  bool drown() noexcept;
  // An idle station is `bits` into the intermission behind a frame, which was its own or not.
  void enter_intermission(int bits, bool own) noexcept;
  // A frame went by while nothing was wrong.
  void count_sent() noexcept { confinement_.sent(); }
  void count_received() noexcept { confinement_.received(); }

  [[nodiscard]] const FaultConfinement& confinement() const noexcept { return confinement_; }
  [[nodiscard]] bool idle() const noexcept { return phase_ == Phase::idle; }
  [[nodiscard]] bool sending() const noexcept { return phase_ == Phase::sending; }
  [[nodiscard]] bool in_frame() const noexcept { return sending() || phase_ == Phase::receiving; }
  [[nodiscard]] bool recovering() const noexcept { return phase_ == Phase::recovering; }
  // It only listens for recessive bits: the bus is not busy on its account.
  [[nodiscard]] bool waits_for_silence() const noexcept {
    return phase_ == Phase::integrating || phase_ == Phase::recovering;
  }
  // Between a detected error, or an overload condition, and the end of its delimiter.
  [[nodiscard]] bool signals_error() const noexcept {
    return phase_ == Phase::active_flag || phase_ == Phase::passive_flag || phase_ == Phase::flag_over ||
           phase_ == Phase::delimiter;
  }
  [[nodiscard]] const Frame& frame() const noexcept { return frame_; }
  [[nodiscard]] ErrorKind error_kind() const noexcept { return error_kind_; }

 private:
  enum class Phase : std::uint8_t {
    idle,
    sending,
    receiving,
    active_flag,   // six dominant bits; also those of an overload flag
    passive_flag,  // recessive, until six equal bits have been seen
    flag_over,     // waits for the first recessive bit, which begins the delimiter
    delimiter,
    intermission,
    integrating,  // waits for 11 recessive bits before it takes part
    bus_off,
    recovering
  };

  Event sample_sending(bool dominant) noexcept;
  Event sample_receiving(bool dominant) noexcept;
  Event sample_delimiter(bool dominant) noexcept;
  Event sample_intermission(bool dominant) noexcept;
  Event sample_silence(bool dominant) noexcept;
  void sample_passive_flag(bool dominant) noexcept;
  void sample_flag_over(bool dominant) noexcept;
  void read_from_start() noexcept;
  Event fail(ErrorKind kind, bool counts = true) noexcept;
  void signal_overload() noexcept;
  void enter(Phase phase) noexcept;
  // Bus-off follows at once from the transmit error counter.
  void heed_bus_off() noexcept;

  Phase phase_ = Phase::idle;
  bool transmitter_ = false;     // sent the frame that this is about (error counting differs)
  bool overload_ = false;        // the flag is one of overload, not of error
  bool last_dominant_ = false;   // passive flag: the bit before
  bool unacknowledged_ = false;  // passive flag after an ACK error, not counted so far
  ErrorKind error_kind_ = ErrorKind::bit;
  int count_ = 0;      // bits in this phase; what counts differs
  int sequences_ = 0;  // recovering: how often 11 recessive bits have been seen
  int position_ = 0;   // sending: the bit that comes
  FrameReader reader_;
  FaultConfinement confinement_;
  WireFrame wire_;
  Frame frame_;
};

}  // namespace gaitway::can
