// For tests: another program's station on a CAN interface, written without the port that is tested; and
// interfaces that come and go.
#pragma once

#include <gtest/gtest.h>
#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <poll.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "gaitway/can/bus_port.hpp"

namespace gaitway::can::test {

// Longer than anything here takes, however slow the machine: only what never happens ends at it.
inline constexpr int kPatience_ms = 10'000;

inline std::int64_t clock_ns(clockid_t clock = CLOCK_MONOTONIC) {
  timespec now{};
  clock_gettime(clock, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

inline void shell(const std::string& command) {
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
}

// A virtual interface of a test's own.
class Interface {
 public:
  explicit Interface(std::string interface_name = "vtest0") : name(std::move(interface_name)) { add(); }
  ~Interface() { static_cast<void>(std::system(("ip link del " + name + " 2>/dev/null").c_str())); }
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;
  void add(const std::string& more = "") const {
    shell("ip link add " + name + " " + more + " type vcan && ip link set " + name + " mtu 72 up");
  }
  void remove() const { shell("ip link del " + name); }
  void up() const { shell("ip link set " + name + " up"); }
  void down() const { shell("ip link set " + name + " down"); }
  // Frames lie in the interface's queue for a while, as on a slow bus.
  void delay(const std::string& time, int room = 1000) const {
    shell("tc qdisc replace dev " + name + " root netem delay " + time + " limit " + std::to_string(room));
  }
  std::string name;
};

class Station {
 public:
  explicit Station(const std::string& interface) : socket_(socket(PF_CAN, SOCK_RAW, CAN_RAW)) {
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(if_nametoindex(interface.c_str()));
    const int on = 1;
    EXPECT_EQ(setsockopt(socket_, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, &on, sizeof on), 0);
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0) << interface;
  }
  ~Station() { close(socket_); }
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  // `id` with the flags of linux/can.h.
  void send(canid_t id, const std::vector<std::uint8_t>& data = {}) const {
    can_frame frame{};
    frame.can_id = id;
    frame.len = static_cast<std::uint8_t>(data.size());
    std::copy(data.begin(), data.end(), frame.data);
    ASSERT_EQ(write(socket_, &frame, sizeof frame), static_cast<ssize_t>(sizeof frame)) << strerror(errno);
  }
  void send_fd(canid_t id) const {
    canfd_frame frame{};
    frame.can_id = id;
    frame.len = 12;
    ASSERT_EQ(write(socket_, &frame, sizeof frame), static_cast<ssize_t>(sizeof frame)) << strerror(errno);
  }
  // The next `count` frames, or as many as come.
  std::vector<can_frame> receive(std::size_t count) const {
    std::vector<can_frame> frames;
    pollfd wake{socket_, POLLIN, 0};
    while (frames.size() < count && poll(&wake, 1, kPatience_ms) > 0) {
      can_frame frame{};
      if (read(socket_, &frame, sizeof frame) == sizeof frame) {
        frames.push_back(frame);
      }
    }
    return frames;
  }
  std::vector<canid_t> receive_ids(std::size_t count) const {
    std::vector<canid_t> ids;
    for (const can_frame& frame : receive(count)) {
      ids.push_back(frame.can_id);
    }
    return ids;
  }
  // Whether a frame is there by now.
  bool silent() const {
    pollfd wake{socket_, POLLIN, 0};
    return poll(&wake, 1, 0) == 0;
  }

 private:
  int socket_;
};

// Lets the port work as a program's loop does, until `done`. False when that never happened.
inline bool work(BusPort& port, const std::function<bool()>& done,
                 std::vector<TimedFrame>* received = nullptr) {
  const std::int64_t end_ns = clock_ns() + std::int64_t{kPatience_ms} * 1'000'000;
  while (true) {
    port.flush(clock_ns());
    while (const auto frame = port.receive()) {
      if (received != nullptr) {
        received->push_back(*frame);
      }
    }
    if (done()) {
      return true;
    }
    if (clock_ns() > end_ns) {
      return false;
    }
    pollfd wake{port.wake_fd(), POLLIN, 0};
    poll(&wake, 1, 1);
  }
}

// The next `count` frames that the port receives, or as many as come.
inline std::vector<TimedFrame> receive(BusPort& port, std::size_t count) {
  std::vector<TimedFrame> frames;
  work(
      port, [&] { return frames.size() >= count; }, &frames);
  return frames;
}

}  // namespace gaitway::can::test
