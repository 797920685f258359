// The link over a serial device: 8 data bits, no parity, one stop bit, no flow control but the link's own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "gaitway/link/carrier.hpp"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::link {

// The text names device and baud rate, what was tried and why it failed.
class SerialError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class SerialCarrier final : public Carrier {
 public:
  // Bytes that may wait in the kernel: what comes behind them is not late yet, and can be overtaken.
  static constexpr std::size_t kMostQueued = 64;

  // `baud`: 9600 to 4000000, of those that Linux knows. Throws SerialError. The device is this process's
  // alone.
  SerialCarrier(const std::filesystem::path& device, std::uint32_t baud);

  // Throws SerialError when there is no such rate, whatever the device.
  static void check(const std::filesystem::path& device, std::uint32_t baud);

  std::size_t write(Bytes bytes) noexcept override;
  std::size_t read(std::span<std::uint8_t> room) noexcept override;
  [[nodiscard]] bool connected() const noexcept override { return connected_; }
  [[nodiscard]] int wake_fd() const noexcept { return device_.get(); }

 private:
  process::FileDescriptor device_;
  bool connected_ = true;
};

}  // namespace gaitway::link
