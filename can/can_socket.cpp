// The system calls of the SocketCAN port: options, batches of messages with their time stamps, interfaces by
// ioctl.
#include "can_socket.hpp"

#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <linux/if_arp.h>
#include <linux/net_tstamp.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace gaitway::can {
namespace {

// How far a stamp may be from the last comparison of the clocks before they are compared again. The kernel's
// stamps are CLOCK_REALTIME, which is set and slewed.
constexpr std::int64_t kCompareClocks_ns = 1'000'000;

std::int64_t nanoseconds(const timespec& time) noexcept {
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

std::int64_t clock_ns(clockid_t clock) noexcept {
  timespec now{};
  clock_gettime(clock, &now);
  return nanoseconds(now);
}

ifreq request_for(const std::string& interface) noexcept {
  ifreq request{};
  interface.copy(request.ifr_name, IFNAMSIZ - 1);
  return request;
}

canid_t wire_id(std::uint32_t id, bool extended) noexcept {
  return extended ? id | CAN_EFF_FLAG : id;
}

}  // namespace

SocketCanPort::Socket::Socket(const std::string& interface, const std::vector<IdFilter>& filters)
    : interface_(interface) {
  if (interface.empty() || interface.size() >= IFNAMSIZ) {
    throw BusError("CAN interface '" + interface + "': the name of an interface has 1 to " +
                   std::to_string(IFNAMSIZ - 1) + " characters");
  }
  fd_ = process::FileDescriptor(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
  if (!fd_) {
    fail("this kernel has no CAN sockets; try: modprobe can_raw. Some kernels are built without CAN", errno);
  }
  check_interface();
  configure(filters);
  if (!bind_to(index_)) {
    fail("cannot bind to it with these filters", errno);
  }
  for (std::size_t i = 0; i < frame_.size(); ++i) {
    vector_[i] = {&frame_[i], sizeof frame_[i]};
    header_[i].msg_hdr.msg_iov = &vector_[i];
    header_[i].msg_hdr.msg_iovlen = 1;
    header_[i].msg_hdr.msg_control = control_[i].bytes.data();
  }
}

void SocketCanPort::Socket::fail(const std::string& what, int error) const {
  throw BusError("CAN interface '" + interface_ + "': " + what + " (" + std::strerror(error) + ")");
}

void SocketCanPort::Socket::check_interface() {
  index_ = find_interface();
  if (index_ == 0) {
    fail(
        "there is no such interface. `ip link` lists those there are. For a bus without hardware: ip link "
        "add " +
            interface_ + " type vcan && ip link set " + interface_ + " up",
        errno);
  }
  ifreq request = request_for(interface_);
  if (ioctl(fd_.get(), SIOCGIFHWADDR, &request) != 0) {
    fail("cannot be asked what it is", errno);
  }
  if (request.ifr_hwaddr.sa_family != ARPHRD_CAN) {
    fail("it is no CAN interface. `ip link show type can` lists those there are", EPERM);
  }
  if (!interface_up()) {
    fail("it is down. For a real one: ip link set " + interface_ +
             " up type can bitrate 1000000; for a virtual one: "
             "ip link set " +
             interface_ + " up",
         ENETDOWN);
  }
}

void SocketCanPort::Socket::configure(const std::vector<IdFilter>& filters) {
  const auto set = [this](int level, int name, const void* value, std::size_t size, const char* what) {
    if (setsockopt(fd_.get(), level, name, value, static_cast<socklen_t>(size)) != 0) {
      fail(std::string("the kernel refuses ") + what, errno);
    }
  };
  for (const IdFilter& filter : filters) {
    filters_.push_back({wire_id(filter.id, filter.extended), filter.mask | CAN_EFF_FLAG});
  }
  if (filters_.empty()) {
    filters_.push_back({0, 0});  // everything
  }
  const int on = 1;
  const can_err_mask_t errors = CAN_ERR_MASK;
  set(SOL_CAN_RAW, CAN_RAW_ERR_FILTER, &errors, sizeof errors, "error frames");
  set(SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, &on, sizeof on, "echoes of own frames");
  set(SOL_CAN_RAW, CAN_RAW_FD_FRAMES, &on, sizeof on, "CAN FD frames, which are counted");
  set(SOL_SOCKET, SO_RXQ_OVFL, &on, sizeof on, "the counter of dropped frames");
  const int stamps = SOF_TIMESTAMPING_RX_HARDWARE | SOF_TIMESTAMPING_RAW_HARDWARE |
                     SOF_TIMESTAMPING_RX_SOFTWARE | SOF_TIMESTAMPING_SOFTWARE;
  set(SOL_SOCKET, SO_TIMESTAMPING, &stamps, sizeof stamps, "time stamps");
}

bool SocketCanPort::Socket::passes(const Frame& frame) const noexcept {
  const canid_t id = wire_id(frame.id, frame.extended);
  return std::ranges::any_of(filters_, [id](const can_filter& filter) {
    return (id & filter.can_mask) == (filter.can_id & filter.can_mask);
  });
}

int SocketCanPort::Socket::read() noexcept {
  for (std::size_t i = 0; i < header_.size(); ++i) {
    header_[i].msg_hdr.msg_controllen = sizeof(Control::bytes);
  }
  const int count = recvmmsg(fd_.get(), header_.data(), kBatch, MSG_DONTWAIT, nullptr);
  if (count < 0) {
    return -errno;
  }
  read_at_ns_ = clock_ns(CLOCK_MONOTONIC);
  return count;
}

SocketCanPort::Socket::Arrival SocketCanPort::Socket::arrival(int message) noexcept {
  msghdr& header = header_[at(message)].msg_hdr;
  std::int64_t kernel_ns = 0, hardware_ns = 0;
  for (cmsghdr* control = CMSG_FIRSTHDR(&header); control != nullptr;
       control = CMSG_NXTHDR(&header, control)) {
    if (control->cmsg_level != SOL_SOCKET) {
      continue;
    }
    if (control->cmsg_type == SCM_TIMESTAMPING) {
      std::array<timespec, 3> stamps{};  // the kernel's, an obsolete one, the controller's
      std::memcpy(stamps.data(), CMSG_DATA(control), sizeof stamps);
      kernel_ns = nanoseconds(stamps[0]);
      hardware_ns = nanoseconds(stamps[2]);
    } else if (control->cmsg_type == SO_RXQ_OVFL) {
      std::uint32_t drops = 0;  // since the socket was made; runs over
      std::memcpy(&drops, CMSG_DATA(control), sizeof drops);
      dropped_ += drops - last_drops_;
      last_drops_ = drops;
    }
  }
  const bool stamped = kernel_ns != 0;
  if (stamped) {
    if (std::abs(kernel_ns - distance_at_ns_) > kCompareClocks_ns) {
      update_distance(kernel_ns);
    }
    // CLOCK_REALTIME may have been set back since the frame came: it came before it was read all the same.
    kernel_ns = std::min(kernel_ns + distance_ns_, read_at_ns_);
  } else {
    kernel_ns = read_at_ns_;
  }
  if (hardware_ns == 0) {
    return {kernel_ns, false, stamped};
  }
  return {hardware_clock_.convert(hardware_ns, kernel_ns), true, true};
}

void SocketCanPort::Socket::update_distance(std::int64_t stamp_ns) noexcept {
  constexpr int kTries = 3;
  std::int64_t shortest_ns = INT64_MAX;
  for (int i = 0; i < kTries; ++i) {
    const std::int64_t before_ns = clock_ns(CLOCK_MONOTONIC);
    const std::int64_t real_ns = clock_ns(CLOCK_REALTIME);
    const std::int64_t took_ns = clock_ns(CLOCK_MONOTONIC) - before_ns;
    if (took_ns < shortest_ns) {  // an interruption between the readings would shift the result
      shortest_ns = took_ns;
      distance_ns_ = before_ns + took_ns / 2 - real_ns;
    }
    if (took_ns < 2'000) {
      break;
    }
  }
  distance_at_ns_ = stamp_ns;
}

int SocketCanPort::Socket::write(const Frame& frame) noexcept {
  can_frame message{};
  message.can_id = wire_id(frame.id, frame.extended) | (frame.remote ? CAN_RTR_FLAG : 0U);
  message.len = frame.size;
  if (!frame.remote) {
    std::copy_n(frame.data.begin(), frame.size, message.data);
  }
  return send(fd_.get(), &message, sizeof message, MSG_DONTWAIT | MSG_NOSIGNAL) == sizeof message ? 0 : errno;
}

bool SocketCanPort::Socket::interface_up() const noexcept {
  ifreq request = request_for(interface_);
  return ioctl(fd_.get(), SIOCGIFFLAGS, &request) == 0 && (request.ifr_flags & IFF_UP) != 0;
}

int SocketCanPort::Socket::find_interface() const noexcept {
  ifreq request = request_for(interface_);
  return ioctl(fd_.get(), SIOCGIFINDEX, &request) == 0 ? request.ifr_ifindex : 0;
}

bool SocketCanPort::Socket::bind_to(int index) noexcept {
  // The kernel forgets the filters when an interface is removed.
  if (setsockopt(fd_.get(), SOL_CAN_RAW, CAN_RAW_FILTER, filters_.data(),
                 static_cast<socklen_t>(filters_.size() * sizeof(can_filter))) != 0) {
    return false;
  }
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = index;
  if (bind(fd_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    return false;
  }
  index_ = index;
  hardware_clock_ = HardwareClock();
  return true;
}

}  // namespace gaitway::can
