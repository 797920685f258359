// One simulated CAN controller, bit by bit: its phases and what leads from one to the next.
#include "gaitway/can/simulated/bit_station.hpp"

namespace gaitway::can {
namespace {

constexpr int kFlagBits = 6;
constexpr int kDelimiterBits = 8;
constexpr int kIntermissionBits = 3;
constexpr int kToleratedDominantBits = 8;  // after a flag; each further eight raise a counter
constexpr int kSilentBits = 11;
constexpr int kRecoverySequences = 128;

}  // namespace

void BitStation::enter(Phase phase) noexcept {
  phase_ = phase;
  count_ = 0;
}

void BitStation::start_sending(const Frame& frame) noexcept {
  frame_ = frame;
  wire_ = WireFrame(frame);
  position_ = 0;
  transmitter_ = true;
  reader_.start();
  enter(Phase::sending);
}

void BitStation::follow(const FrameReader& reader) noexcept {
  transmitter_ = false;
  reader_ = reader;
  enter(Phase::receiving);
}

void BitStation::power_on() noexcept {
  confinement_.reset();
  enter(Phase::integrating);
}

void BitStation::recover() noexcept {
  enter(Phase::recovering);
  sequences_ = 0;
}

void BitStation::enter_intermission(int bits, bool own) noexcept {
  transmitter_ = own;
  enter(Phase::intermission);
  count_ = bits;
}

bool BitStation::drown() noexcept {
  const bool frame = phase_ == Phase::sending || phase_ == Phase::receiving;
  if (frame) {
    fail(ErrorKind::bit);
  }
  if (phase_ == Phase::recovering) {
    count_ = 0;
  } else if (phase_ != Phase::bus_off) {
    enter(Phase::integrating);
  }
  return frame;
}

bool BitStation::drives_dominant() const noexcept {
  switch (phase_) {
    case Phase::sending:
      return wire_.dominant(position_);
    case Phase::receiving:
      return reader_.acknowledges();
    case Phase::active_flag:
      return true;
    default:
      return false;
  }
}

BitStation::Event BitStation::sample(bool dominant) noexcept {
  switch (phase_) {
    case Phase::idle:
      if (dominant) {
        read_from_start();
      }
      return Event::none;
    case Phase::sending:
      return sample_sending(dominant);
    case Phase::receiving:
      return sample_receiving(dominant);
    case Phase::active_flag:
      if (++count_ == kFlagBits) {
        enter(Phase::flag_over);
      }
      return Event::none;
    case Phase::passive_flag:
      sample_passive_flag(dominant);
      return Event::none;
    case Phase::flag_over:
      sample_flag_over(dominant);
      return Event::none;
    case Phase::delimiter:
      return sample_delimiter(dominant);
    case Phase::intermission:
      return sample_intermission(dominant);
    case Phase::integrating:
    case Phase::recovering:
      return sample_silence(dominant);
    case Phase::bus_off:
      break;
  }
  return Event::none;
}

void BitStation::read_from_start() noexcept {
  transmitter_ = false;
  reader_.start();
  reader_.take(true);
  enter(Phase::receiving);
}

BitStation::Event BitStation::sample_sending(bool dominant) noexcept {
  const bool sent_dominant = wire_.dominant(position_);
  const bool in_arbitration = position_ < wire_.arbitration_end();
  if (position_ == wire_.acknowledge_slot()) {
    if (!dominant) {
      return fail(ErrorKind::acknowledge);
    }
  } else if (dominant != sent_dominant) {
    if (!in_arbitration || !dominant) {
      return fail(ErrorKind::bit);
    }
    if (wire_.is_stuff_bit(position_)) {
      return fail(ErrorKind::stuff, false);  // rule c, exception 2: it is not this station's fault
    }
    // Arbitration is lost: from here on it receives.
    transmitter_ = false;
    phase_ = Phase::receiving;
    return sample_receiving(dominant);
  }
  if (in_arbitration) {
    reader_.take(dominant);
  }
  if (++position_ < wire_.length()) {
    return Event::none;
  }
  confinement_.sent();
  enter(Phase::intermission);
  return Event::sent;
}

BitStation::Event BitStation::sample_receiving(bool dominant) noexcept {
  if (reader_.acknowledges() && !dominant) {
    return fail(ErrorKind::bit);  // its own dominant bit does not come through
  }
  switch (reader_.take(dominant)) {
    case FrameReader::Step::more:
      return Event::none;
    case FrameReader::Step::stuff_error:
      return fail(ErrorKind::stuff);
    case FrameReader::Step::form_error:
      return fail(ErrorKind::form);
    case FrameReader::Step::crc_error:
      return fail(ErrorKind::crc);
    case FrameReader::Step::valid:
      confinement_.received();
      return Event::valid;
    case FrameReader::Step::complete:
      enter(Phase::intermission);
      return Event::none;
    case FrameReader::Step::overload:
      signal_overload();
      return Event::none;
  }
  return Event::none;
}

BitStation::Event BitStation::fail(ErrorKind kind, bool counts) noexcept {
  // An error that makes a station passive still gets an active flag.
  const bool passive = confinement_.state() == BusState::error_passive;
  error_kind_ = kind;
  overload_ = false;
  // Rule c, exception 1: a lone passive transmitter goes on for ever.
  unacknowledged_ = passive && kind == ErrorKind::acknowledge && transmitter_;
  if (!transmitter_) {
    confinement_.receiver_error();
  } else if (counts && !unacknowledged_) {
    confinement_.transmitter_error();
  }
  enter(passive ? Phase::passive_flag : Phase::active_flag);
  heed_bus_off();
  return Event::error;
}

void BitStation::signal_overload() noexcept {
  overload_ = true;
  enter(Phase::active_flag);
}

void BitStation::sample_passive_flag(bool dominant) noexcept {
  if (dominant && unacknowledged_) {
    unacknowledged_ = false;
    confinement_.transmitter_error();
    heed_bus_off();
    if (phase_ == Phase::bus_off) {
      return;
    }
  }
  count_ = count_ > 0 && dominant == last_dominant_ ? count_ + 1 : 1;
  last_dominant_ = dominant;
  if (count_ == kFlagBits) {
    enter(Phase::flag_over);
  }
}

void BitStation::sample_flag_over(bool dominant) noexcept {
  if (!dominant) {
    enter(Phase::delimiter);
    count_ = 1;
    return;
  }
  ++count_;
  if (count_ == 1 && !transmitter_ && !overload_) {
    confinement_.first_to_detect();
  }
  if (count_ % kToleratedDominantBits == 0) {
    confinement_.dominant_too_long(transmitter_);
    heed_bus_off();
  }
}

BitStation::Event BitStation::sample_delimiter(bool dominant) noexcept {
  ++count_;
  if (dominant) {
    if (count_ < kDelimiterBits) {
      return fail(ErrorKind::form);
    }
    signal_overload();
  } else if (count_ == kDelimiterBits) {
    enter(Phase::intermission);
  }
  return Event::none;
}

BitStation::Event BitStation::sample_intermission(bool dominant) noexcept {
  ++count_;
  if (dominant) {
    if (count_ < kIntermissionBits) {
      signal_overload();
    } else {
      read_from_start();  // the third bit may be a start of frame
    }
    return Event::none;
  }
  if (count_ < kIntermissionBits) {
    return Event::none;
  }
  const bool suspended = transmitter_ && confinement_.state() == BusState::error_passive;
  enter(Phase::idle);
  return suspended ? Event::suspend : Event::none;
}

BitStation::Event BitStation::sample_silence(bool dominant) noexcept {
  count_ = dominant ? 0 : count_ + 1;
  if (count_ < kSilentBits) {
    return Event::none;
  }
  if (phase_ == Phase::integrating) {
    enter(Phase::idle);
    return Event::none;
  }
  count_ = 0;
  if (++sequences_ < kRecoverySequences) {
    return Event::none;
  }
  confinement_.reset();
  enter(Phase::idle);
  return Event::recovered;
}

void BitStation::heed_bus_off() noexcept {
  if (confinement_.state() == BusState::bus_off) {
    enter(Phase::bus_off);
  }
}

}  // namespace gaitway::can
