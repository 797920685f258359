// A disk that takes what a pipe holds, and then nothing until the test reads it.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <string>
#include <thread>

#include "gaitway/api/recording_folder.hpp"

namespace gaitway::api {

class StalledDisk {
 public:
  StalledDisk() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
  StalledDisk(const StalledDisk&) = delete;
  StalledDisk& operator=(const StalledDisk&) = delete;
  // Writers find nobody then.
  ~StalledDisk() { ::close(ends_[0]); }

  // One recording takes over the end that is written.
  [[nodiscard]] RecordingDisk disk() const {
    RecordingDisk result = RecordingDisk::real();
    result.create = [end = ends_[1]](int, const char*) { return end; };
    return result;
  }
  // Until it takes nothing more; so much must be written to it.
  void await_stall() const {
    pollfd writable{ends_[1], POLLOUT, 0};
    while (::poll(&writable, 1, 0) != 0) std::this_thread::yield();
  }
  // All that is written, until the writer closes it.
  [[nodiscard]] std::string recover() const {
    std::string bytes;
    std::array<char, 65536> buffer{};
    for (ssize_t count = 0; (count = ::read(ends_[0], buffer.data(), buffer.size())) > 0;) {
      bytes.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return bytes;
  }

 private:
  std::array<int, 2> ends_{};
};

}  // namespace gaitway::api
