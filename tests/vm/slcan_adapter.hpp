// For tests: a serial CAN adapter (slcan) whose firmware is the test. The kernel's driver talks to it over a
// pseudo-terminal and keeps the state of a CAN controller for it, as for any hardware.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "can_station.hpp"

namespace gaitway::can::test {

class SlcanAdapter {
 public:
  // The interface is up at 1 Mb/s, with room for `queue` frames in its transmit queue.
  explicit SlcanAdapter(int queue = 10) : firmware_(posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_TRUE(firmware_ >= 0 && grantpt(firmware_) == 0 && unlockpt(firmware_) == 0);
    line_ = open(ptsname(firmware_), O_RDWR | O_NOCTTY);
    termios raw{};
    tcgetattr(line_, &raw);
    cfmakeraw(&raw);
    tcsetattr(line_, TCSANOW, &raw);
    constexpr int kSlcanDiscipline = 17;  // N_SLCAN of linux/tty.h
    const int discipline = kSlcanDiscipline;
    EXPECT_EQ(ioctl(line_, TIOCSETD, &discipline), 0);
    char interface[IFNAMSIZ] = {};
    EXPECT_EQ(ioctl(line_, SIOCGIFNAME, interface), 0);
    name = interface;
    shell("ip link set " + name + " txqueuelen " + std::to_string(queue) + " type can bitrate 1000000");
    EXPECT_EQ(up(), "C\rS8\rO\r") << "close, 1 Mb/s, open";
  }
  ~SlcanAdapter() {
    close(line_);
    close(firmware_);
  }
  SlcanAdapter(const SlcanAdapter&) = delete;
  SlcanAdapter& operator=(const SlcanAdapter&) = delete;

  // They return what the driver said meanwhile.
  std::string up() { return hear_during("ip link set " + name + " up"); }
  std::string down() { return hear_during("ip link set " + name + " down"); }

  // What the adapter reports to the driver.
  void report(const std::string& line) const {
    ASSERT_EQ(write(firmware_, line.data(), line.size()), static_cast<ssize_t>(line.size()));
  }
  // The controller's state (a: active, w: warning, p: passive, b: bus-off) and its two counters.
  void report_state(char state, int transmit, int receive) const {
    char line[16];
    std::snprintf(line, sizeof line, "s%c%03d%03d\r", state, receive, transmit);
    report(line);
  }
  // Everything that the driver has said, up to the first `end` or as far as it goes.
  std::string heard_until(const std::string& end) {
    std::string text;
    pollfd wake{firmware_, POLLIN, 0};
    char byte = 0;
    while (!text.ends_with(end) && poll(&wake, 1, kPatience_ms) > 0 && read(firmware_, &byte, 1) == 1) {
      text += byte;
    }
    return text;
  }
  [[nodiscard]] bool silent() const {
    pollfd wake{firmware_, POLLIN, 0};
    return poll(&wake, 1, 0) == 0;
  }

  std::string name;

 private:
  // The driver goes on to its next command when the adapter has read the one before.
  std::string hear_during(const std::string& command) {
    std::string text;
    std::atomic<bool> ended = false;
    std::thread runner([&] {
      shell(command);
      ended = true;
    });
    pollfd wake{firmware_, POLLIN, 0};
    char byte = 0;
    while (!ended || !silent()) {
      if (poll(&wake, 1, 10) > 0 && read(firmware_, &byte, 1) == 1) {
        text += byte;
      }
    }
    runner.join();
    return text;
  }

  int firmware_;
  int line_ = -1;
};

}  // namespace gaitway::can::test
