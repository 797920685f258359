// I2C in virtual time, exact to the bit: the module is master, the main controller a slave with a data-ready
// line.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>

#include "gaitway/facts/facts.hpp"
#include "gaitway/link/carrier.hpp"

namespace gaitway::link {

// Fast-mode of the I2C specification (NXP UM10204, table 10).
struct I2cSettings {
  std::int64_t bit_ns = 2500;            // 400 kHz
  std::int64_t start_ns = 600;           // hold time of the start condition
  std::int64_t stop_ns = 600;            // set-up time of the stop condition
  std::int64_t bus_free_ns = 1300;       // between stop and start
  std::int64_t slave_service_ns = 2000;  // by which the slave stretches the clock of every byte
  std::int64_t stretch_limit_ns =
      25 * facts::kMillisecond_ns;  // longer, and the master gives the transfer up
  std::int64_t retry_ns = 100'000;  // pause after a transfer that was not acknowledged
  std::size_t transfer_bytes = 32;  // the longest transfer, and what either end's FIFO holds
  int writes_per_read = 4;          // so many transfers to the slave, and one from it if it is ready

  // Eight bits and the acknowledge bit.
  [[nodiscard]] constexpr std::int64_t byte_ns() const noexcept { return 9 * bit_ns + slave_service_ns; }
  // Start, address, so many bytes, stop, and the pause that belongs to it.
  [[nodiscard]] constexpr std::int64_t transfer_ns(std::size_t bytes) const noexcept {
    return start_ns + static_cast<std::int64_t>(bytes + 1) * byte_ns() + stop_ns + bus_free_ns;
  }
};

// What may go wrong, each with its probability.
struct I2cFaults {
  double address_nack = 0.0;      // a transfer: the slave does not answer
  double data_nack = 0.0;         // a byte to the slave: it does not take it
  double arbitration_loss = 0.0;  // a transfer: another master has the bus, for `other_master_ns`
  double stretch = 0.0;           // a byte: the slave holds the clock for up to `stretch_ns` more
  double stuck = 0.0;             // a byte from the slave: its clock is miscounted, and it holds SDA low
  double flipped_bit = 0.0;       // a byte
  std::int64_t other_master_ns = 500'000;
  std::int64_t stretch_ns = 300'000;
};

struct I2cCounts {
  std::uint64_t writes = 0, reads = 0;  // transfers that were begun
  std::uint64_t bytes_written = 0, bytes_read = 0;
  std::uint64_t nacks = 0;
  std::uint64_t arbitration_losses = 0;
  std::uint64_t stretches = 0;   // beyond slave_service_ns
  std::uint64_t timeouts = 0;    // stretched for too long
  std::uint64_t recoveries = 0;  // SDA was stuck: clocks, then a stop condition
  std::uint64_t recovery_clocks = 0;
};

// Bytes between a carrier's owner and the bus.
class I2cFifo {
 public:
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  void push(std::uint8_t byte) noexcept { bytes_[(first_ + size_++) % bytes_.size()] = byte; }
  [[nodiscard]] std::uint8_t front() const noexcept { return bytes_[first_]; }
  std::uint8_t pop() noexcept;
  void clear() noexcept { size_ = 0; }

 private:
  std::array<std::uint8_t, 256> bytes_{};
  std::size_t first_ = 0, size_ = 0;
};

// The master writes what it has to say; it reads when the slave's data-ready line says that there is
// something, for as long as it says so. Bytes that were not acknowledged stay where they are: the frames
// above see nothing of it.
class I2cBus {
 public:
  // Throws std::invalid_argument for a transfer of 0 bytes or more than a FIFO holds, or no writes before a
  // read.
  explicit I2cBus(const I2cSettings& settings = {}, std::uint64_t seed = 1);

  // Either end's access, for as long as the bus lives.
  [[nodiscard]] Carrier& master() noexcept { return master_; }
  [[nodiscard]] Carrier& slave() noexcept { return slave_; }

  // When the next transfer ends, if that is at `until_ns` or before: what it brought can be read then, and
  // the caller may write before it goes on. Nothing: the bus has come to `until_ns`.
  std::optional<std::int64_t> advance(std::int64_t until_ns) noexcept;

  void set_faults(const I2cFaults& faults) noexcept { faults_ = faults; }
  // A slave that is off acknowledges nothing, and what was in its FIFOs is gone.
  void power_slave(bool on) noexcept;
  // The slave holds SDA low from now until it has seen `clocks` clocks, and not before `until_ns`.
  void stick(int clocks, std::int64_t until_ns = 0) noexcept;
  [[nodiscard]] const I2cCounts& counts() const noexcept { return counts_; }

 private:
  class Port final : public Carrier {
   public:
    explicit Port(std::size_t room) noexcept : room_(room) {}
    std::size_t write(Bytes bytes) noexcept override;
    std::size_t read(std::span<std::uint8_t> room) noexcept override;
    [[nodiscard]] bool connected() const noexcept override { return true; }
    [[nodiscard]] bool has_room() const noexcept { return in.size() < room_; }
    I2cFifo out, in;

   private:
    std::size_t room_;
  };
  enum class Phase : std::uint8_t { idle, start, address, data, stop, other_master, recovery };

  void begin_phase(Phase phase, std::int64_t duration_ns) noexcept;
  void begin_byte(Phase phase) noexcept;
  void choose() noexcept;        // idle: whose turn it is
  bool finish_phase() noexcept;  // at due_ns_; true: a transfer has ended
  void finish_address() noexcept;
  void finish_written_byte() noexcept;
  void finish_read_byte() noexcept;
  void finish_recovery() noexcept;
  void give_up() noexcept;  // stop, and try again later
  [[nodiscard]] bool slave_is_ready() const noexcept;
  [[nodiscard]] std::uint8_t noisy(std::uint8_t byte) noexcept;
  [[nodiscard]] bool happens(double probability) noexcept;
  [[nodiscard]] int draw(int least, int most) noexcept;

  I2cSettings settings_;
  I2cFaults faults_;
  I2cCounts counts_;
  std::mt19937_64 random_;
  Port master_, slave_;
  Phase phase_ = Phase::idle;
  std::int64_t now_ns_ = 0, due_ns_ = 0;
  bool reading_ = false;    // the transfer goes from slave to master
  bool timed_out_ = false;  // this byte is stretched for too long
  std::size_t transferred_ = 0;
  int writes_in_turn_ = 0;
  bool slave_powered_ = true;
  int stuck_clocks_ = 0;  // until the slave lets SDA go
  std::int64_t stuck_until_ns_ = 0;
  int clocks_given_ = 0;  // of a recovery
};

}  // namespace gaitway::link
