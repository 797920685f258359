// The phases of a transfer, one after the other; what a phase brings counts at its end.
#include "gaitway/link/i2c_bus.hpp"

#include <algorithm>
#include <stdexcept>

namespace gaitway::link {
namespace {

constexpr int kRecoveryClocks = 9;  // enough for a slave to end its byte and see that nobody acknowledges it

}  // namespace

std::uint8_t I2cFifo::pop() noexcept {
  const std::uint8_t byte = front();
  first_ = (first_ + 1) % bytes_.size();
  --size_;
  return byte;
}

std::size_t I2cBus::Port::write(Bytes bytes) noexcept {
  const std::size_t count = std::min(bytes.size(), room_ - std::min(room_, out.size()));
  for (const std::uint8_t byte : bytes.first(count)) {
    out.push(byte);
  }
  return count;
}

std::size_t I2cBus::Port::read(std::span<std::uint8_t> room) noexcept {
  const std::size_t count = std::min(room.size(), in.size());
  std::ranges::generate(room.first(count), [this] { return in.pop(); });
  return count;
}

I2cBus::I2cBus(const I2cSettings& settings, std::uint64_t seed)
    : settings_(settings), random_(seed), master_(settings.transfer_bytes), slave_(settings.transfer_bytes) {
  if (settings.transfer_bytes < 1 || settings.transfer_bytes > 128 || settings.writes_per_read < 1) {
    throw std::invalid_argument("I2C: transfer_bytes must be 1 to 128 and writes_per_read at least 1");
  }
}

std::optional<std::int64_t> I2cBus::advance(std::int64_t until_ns) noexcept {
  for (;;) {
    if (phase_ == Phase::idle) {
      choose();
      if (phase_ == Phase::idle) {
        now_ns_ = std::max(now_ns_, until_ns);
        return std::nullopt;
      }
    }
    if (due_ns_ > until_ns) {
      return std::nullopt;
    }
    now_ns_ = due_ns_;
    if (finish_phase()) {
      return now_ns_;
    }
  }
}

void I2cBus::power_slave(bool on) noexcept {
  slave_powered_ = on;
  slave_.out.clear();
  slave_.in.clear();
  stuck_clocks_ = 0;
  stuck_until_ns_ = 0;
}

void I2cBus::stick(int clocks, std::int64_t until_ns) noexcept {
  stuck_clocks_ = clocks;
  stuck_until_ns_ = until_ns;
}

void I2cBus::begin_phase(Phase phase, std::int64_t duration_ns) noexcept {
  phase_ = phase;
  due_ns_ = now_ns_ + duration_ns;
}

void I2cBus::begin_byte(Phase phase) noexcept {
  std::int64_t duration_ns = settings_.byte_ns();
  timed_out_ = false;
  if (happens(faults_.stretch)) {
    ++counts_.stretches;
    const auto most = static_cast<int>(std::min<std::int64_t>(faults_.stretch_ns, facts::kSecond_ns));
    const std::int64_t stretch_ns = draw(1, std::max(most, 1));
    timed_out_ = stretch_ns > settings_.stretch_limit_ns;
    duration_ns += std::min(stretch_ns, settings_.stretch_limit_ns);
  }
  begin_phase(phase, duration_ns);
}

bool I2cBus::slave_is_ready() const noexcept {
  return slave_powered_ && slave_.out.size() > 0;
}

void I2cBus::choose() noexcept {
  if (stuck_clocks_ > 0 || stuck_until_ns_ > now_ns_) {
    clocks_given_ = 0;
    begin_phase(Phase::recovery, settings_.bit_ns);
    return;
  }
  const bool may_read = slave_is_ready() && master_.has_room();
  const bool may_write = master_.out.size() > 0;
  if (!may_read && !may_write) {
    return;
  }
  reading_ = may_read && (!may_write || writes_in_turn_ >= settings_.writes_per_read);
  writes_in_turn_ = reading_ ? 0 : writes_in_turn_ + 1;
  transferred_ = 0;
  ++(reading_ ? counts_.reads : counts_.writes);
  begin_phase(Phase::start, settings_.start_ns);
}

bool I2cBus::finish_phase() noexcept {
  switch (phase_) {
    case Phase::idle:
      break;
    case Phase::start:
      begin_byte(Phase::address);
      break;
    case Phase::address:
      finish_address();
      break;
    case Phase::data:
      if (timed_out_) {
        ++counts_.timeouts;
        give_up();
      } else if (reading_) {
        finish_read_byte();
      } else {
        finish_written_byte();
      }
      break;
    case Phase::stop:
    case Phase::other_master:
      phase_ = Phase::idle;
      return true;
    case Phase::recovery:
      finish_recovery();
      break;
  }
  return false;
}

void I2cBus::give_up() noexcept {
  begin_phase(Phase::stop, settings_.stop_ns + settings_.bus_free_ns + settings_.retry_ns);
}

void I2cBus::finish_address() noexcept {
  if (happens(faults_.arbitration_loss)) {
    ++counts_.arbitration_losses;
    begin_phase(Phase::other_master, faults_.other_master_ns);
  } else if (timed_out_) {
    ++counts_.timeouts;
    give_up();
  } else if (!slave_powered_ || happens(faults_.address_nack)) {
    ++counts_.nacks;
    give_up();
  } else {
    begin_byte(Phase::data);
  }
}

void I2cBus::finish_written_byte() noexcept {
  if (!slave_powered_ || !slave_.has_room() || happens(faults_.data_nack)) {
    ++counts_.nacks;
    give_up();
    return;
  }
  slave_.in.push(noisy(master_.out.pop()));
  ++counts_.bytes_written;
  if (++transferred_ < settings_.transfer_bytes && master_.out.size() > 0) {
    begin_byte(Phase::data);
  } else {
    begin_phase(Phase::stop, settings_.stop_ns + settings_.bus_free_ns);
  }
}

void I2cBus::finish_read_byte() noexcept {
  // Of a slave that has just lost its power, or that counts clocks wrongly, the master reads ones.
  const bool has_byte = slave_is_ready();
  const std::uint8_t byte = has_byte ? slave_.out.pop() : std::uint8_t{0xFF};
  if (happens(faults_.stuck)) {
    stick(draw(1, kRecoveryClocks));
    give_up();
    return;
  }
  master_.in.push(noisy(byte));
  ++counts_.bytes_read;
  if (++transferred_ < settings_.transfer_bytes && slave_is_ready() && master_.has_room()) {
    begin_byte(Phase::data);
  } else {
    begin_phase(Phase::stop, settings_.stop_ns + settings_.bus_free_ns);
  }
}

void I2cBus::finish_recovery() noexcept {
  ++counts_.recovery_clocks;
  stuck_clocks_ = std::max(0, stuck_clocks_ - 1);
  const bool released = stuck_clocks_ == 0 && stuck_until_ns_ <= now_ns_;
  if (!released && ++clocks_given_ < kRecoveryClocks) {
    begin_phase(Phase::recovery, settings_.bit_ns);
    return;
  }
  ++counts_.recoveries;
  give_up();  // ends with a stop condition; what is stuck still is clocked again after the pause
}

std::uint8_t I2cBus::noisy(std::uint8_t byte) noexcept {
  if (happens(faults_.flipped_bit)) {
    byte = static_cast<std::uint8_t>(byte ^ 1U << static_cast<unsigned>(draw(0, 7)));
  }
  return byte;
}

bool I2cBus::happens(double probability) noexcept {
  return probability > 0.0 && std::bernoulli_distribution(probability)(random_);
}

int I2cBus::draw(int least, int most) noexcept {
  return std::uniform_int_distribution<int>(least, most)(random_);
}

}  // namespace gaitway::link
