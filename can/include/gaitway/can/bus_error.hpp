// What can go wrong between a station and its bus: the text names the path, what was tried, why it failed and
// what to do.
#pragma once

#include <stdexcept>
#include <utility>

namespace gaitway::can {

class BusError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Owns a file descriptor.
class BusDescriptor {
 public:
  BusDescriptor() = default;
  explicit BusDescriptor(int fd) noexcept : fd_(fd) {}
  BusDescriptor(BusDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  BusDescriptor& operator=(BusDescriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~BusDescriptor();
  [[nodiscard]] int get() const noexcept { return fd_; }
  [[nodiscard]] explicit operator bool() const noexcept { return fd_ >= 0; }

 private:
  int fd_ = -1;
};

}  // namespace gaitway::can
