// A serial device as raw bytes.
#include "gaitway/link/serial_carrier.hpp"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>

namespace gaitway::link {
namespace {

struct Speed {
  std::uint32_t baud;
  speed_t code;
};
constexpr std::array kSpeeds{Speed{9600, B9600},       Speed{19200, B19200},     Speed{38400, B38400},
                             Speed{57600, B57600},     Speed{115200, B115200},   Speed{230400, B230400},
                             Speed{460800, B460800},   Speed{500000, B500000},   Speed{921600, B921600},
                             Speed{1000000, B1000000}, Speed{1500000, B1500000}, Speed{2000000, B2000000},
                             Speed{3000000, B3000000}, Speed{4000000, B4000000}};

[[noreturn]] void fail(const std::filesystem::path& device, const std::string& what) {
  throw SerialError("serial device '" + device.native() + "': " + what);
}

speed_t code_of(const std::filesystem::path& device, std::uint32_t baud) {
  const auto* const speed = std::ranges::find(kSpeeds, baud, &Speed::baud);
  if (speed == kSpeeds.end()) {
    std::string known;
    for (const Speed& each : kSpeeds) {
      known += (known.empty() ? "" : ", ") + std::to_string(each.baud);
    }
    fail(device, "baud rate " + std::to_string(baud) + " is none of " + known);
  }
  return speed->code;
}

}  // namespace

SerialCarrier::SerialCarrier(const std::filesystem::path& device, std::uint32_t baud) {
  const speed_t speed = code_of(device, baud);
  device_ = process::FileDescriptor(::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!device_) {
    fail(device, std::string("cannot open it: ") + std::strerror(errno));
  }
  termios line{};
  if (tcgetattr(device_.get(), &line) != 0) {
    fail(device, std::string("is no serial device: ") + std::strerror(errno));
  }
  if (ioctl(device_.get(), TIOCEXCL) != 0) {
    fail(device, std::string("cannot have it alone: ") + std::strerror(errno));
  }
  cfmakeraw(&line);
  line.c_cflag |= CLOCAL | CREAD;
  line.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB | PARENB);
  line.c_cc[VMIN] = 0;
  line.c_cc[VTIME] = 0;
  if (cfsetispeed(&line, speed) != 0 || cfsetospeed(&line, speed) != 0 ||
      tcsetattr(device_.get(), TCSANOW, &line) != 0) {
    fail(device, "cannot set " + std::to_string(baud) + " baud: " + std::strerror(errno));
  }
  tcflush(device_.get(), TCIOFLUSH);  // what lies there is of an earlier run
}

void SerialCarrier::check(const std::filesystem::path& device, std::uint32_t baud) {
  static_cast<void>(code_of(device, baud));
}

std::size_t SerialCarrier::write(Bytes bytes) noexcept {
  int queued = 0;
  if (ioctl(device_.get(), TIOCOUTQ, &queued) != 0) {
    connected_ = false;
    return 0;
  }
  const std::size_t waiting = static_cast<std::size_t>(std::max(queued, 0));
  const std::size_t most = kMostQueued - std::min(waiting, kMostQueued);
  const ssize_t count = ::write(device_.get(), bytes.data(), std::min(bytes.size(), most));
  if (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) {
    connected_ = false;
  }
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

std::size_t SerialCarrier::read(std::span<std::uint8_t> room) noexcept {
  const ssize_t count = ::read(device_.get(), room.data(), room.size());
  // With VMIN and VTIME 0 an empty line reads as 0 bytes; one whose other end has gone, as an error (EIO).
  if (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) {
    connected_ = false;
  }
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

}  // namespace gaitway::link
