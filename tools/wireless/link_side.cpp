#include "tools/wireless/link_side.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

namespace gaitway::tools {
namespace {

constexpr const char* kDevice = "gaitway0";

[[noreturn]] void give_up(const std::string& what, const std::string& remedy) {
  throw NoIsolation(fmt::format("{}: {}. {}", what, std::strerror(errno), remedy));
}

void write_file(const char* path, const std::string& text) {
  const process::FileDescriptor file(open(path, O_WRONLY | O_CLOEXEC));
  if (!file || write(file.get(), text.data(), text.size()) < 0) {
    give_up(path, "Run it as root, or allow users to make namespaces");
  }
}

void enter_namespace() {
  if (unshare(CLONE_NEWNET) == 0) {
    return;
  }
  const uid_t user = getuid();
  const gid_t group = getgid();
  if (unshare(CLONE_NEWUSER | CLONE_NEWNET) != 0) {
    give_up("there is no network namespace for this user",
            "Run it as root, or allow users to make namespaces: 'sysctl user.max_user_namespaces=10000', on "
            "Debian "
            "and Ubuntu also 'sysctl kernel.unprivileged_userns_clone=1' or "
            "'kernel.apparmor_restrict_unprivileged_userns=0'");
  }
  write_file("/proc/self/setgroups", "deny");
  write_file("/proc/self/uid_map", fmt::format("{0} {0} 1", user));
  write_file("/proc/self/gid_map", fmt::format("{0} {0} 1", group));
}

void set_address(int socket, unsigned long request, ifreq& device, const std::string& address) {
  auto* const internet = reinterpret_cast<sockaddr_in*>(&device.ifr_addr);
  *internet = {};
  internet->sin_family = AF_INET;
  inet_pton(AF_INET, address.c_str(), &internet->sin_addr);
  if (ioctl(socket, request, &device) != 0) give_up("the address " + address, "Run it as root");
}

void bring_up(int socket, ifreq& device) {
  device.ifr_flags = IFF_UP | IFF_RUNNING;
  if (ioctl(socket, SIOCSIFFLAGS, &device) != 0) give_up(device.ifr_name, "Run it as root");
}

ifreq named(const char* name) {
  ifreq device{};
  std::strncpy(device.ifr_name, name, IFNAMSIZ - 1);
  return device;
}

process::FileDescriptor make_network(const SideSettings& settings) {
  process::FileDescriptor tun(open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC));
  if (!tun) {
    give_up("/dev/net/tun cannot be opened",
            "Load the module ('modprobe tun'), let a container have it ('--device /dev/net/tun'), or allow "
            "users to "
            "open it ('chmod 0666 /dev/net/tun')");
  }
  ifreq device = named(kDevice);
  device.ifr_flags = IFF_TUN | IFF_NO_PI;
  if (ioctl(tun.get(), TUNSETIFF, &device) != 0) {
    give_up("there is no TUN device for this user", "Run it as root");
  }
  const process::FileDescriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  ifreq loopback = named("lo");
  bring_up(socket.get(), loopback);
  device = named(kDevice);
  set_address(socket.get(), SIOCSIFADDR, device, settings.own_address);
  set_address(socket.get(), SIOCSIFDSTADDR, device, settings.other_address);
  device = named(kDevice);
  bring_up(socket.get(), device);
  return tun;
}

// With a descriptor, or with the text alone.
void send_to_parent(int socket, const std::string& text, int descriptor) {
  std::array<char, CMSG_SPACE(sizeof(int))> room{};
  iovec part{const_cast<char*>(text.data()), text.size()};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (descriptor >= 0) {
    message.msg_control = room.data();
    message.msg_controllen = room.size();
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(header), &descriptor, sizeof(int));
  }
  static_cast<void>(sendmsg(socket, &message, MSG_NOSIGNAL));
}

process::FileDescriptor receive_from_child(int socket) {
  std::array<char, CMSG_SPACE(sizeof(int))> room{};
  std::array<char, 1024> text{};
  iovec part{text.data(), text.size()};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = room.data();
  message.msg_controllen = room.size();
  const ssize_t size = recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
  const cmsghdr* const header = CMSG_FIRSTHDR(&message);
  if (header == nullptr) {
    throw NoIsolation(size > 0 ? std::string(text.data(), static_cast<std::size_t>(size))
                               : "the process of a namespace ended before it was there. Run it as root");
  }
  int descriptor = -1;
  std::memcpy(&descriptor, CMSG_DATA(header), sizeof(int));
  return process::FileDescriptor(descriptor);
}

[[noreturn]] void become(const SideSettings& settings) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  if (settings.output >= 0) {
    dup2(settings.output, STDOUT_FILENO);
    dup2(settings.output, STDERR_FILENO);
  }
  if (!settings.reads_input) {
    dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
  }
  std::vector<char*> words;
  std::ranges::transform(settings.program, std::back_inserter(words),
                         [](const std::string& word) { return const_cast<char*>(word.c_str()); });
  words.push_back(nullptr);
  execvp(words.front(), words.data());
  fmt::print(stderr, "gaitway: {}: {}\n", words.front(), std::strerror(errno));
  std::fflush(stderr);
  _exit(127);
}

[[noreturn]] void live_in_namespace(const SideSettings& settings, int socket) {
  setpgid(0, 0);
  try {
    enter_namespace();
    const process::FileDescriptor tun = make_network(settings);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    send_to_parent(socket, "there", tun.get());
  } catch (const std::exception& error) {
    send_to_parent(socket, error.what(), -1);
    _exit(1);
  }
  char go = 0;
  while (recv(socket, &go, 1, 0) == 1) {
    if (!settings.program.empty()) become(settings);
  }
  _exit(0);
}

}  // namespace

LinkSide::LinkSide(const SideSettings& settings) {
  std::array<int, 2> pair{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pair.data()) != 0) {
    throw std::runtime_error("a socket pair cannot be made");
  }
  process::FileDescriptor child_end(pair[1]);
  go_ = process::FileDescriptor(pair[0]);
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("a process cannot be made");
  if (pid_ == 0) live_in_namespace(settings, child_end.get());
  setpgid(pid_, pid_);
  child_end = process::FileDescriptor();
  try {
    tun_ = receive_from_child(go_.get());
  } catch (...) {
    waitpid(pid_, nullptr, 0);
    throw;
  }
}

LinkSide::~LinkSide() {
  signal(SIGKILL);
  if (!ended_ && pid_ > 0) waitpid(pid_, nullptr, 0);
}

void LinkSide::start() {
  send_to_parent(go_.get(), "g", -1);
}

void LinkSide::signal(int number) const {
  if (pid_ > 0) kill(-pid_, number);
}

bool LinkSide::reap() {
  int status = 0;
  if (!ended_ && waitpid(pid_, &status, WNOHANG) == pid_) {
    ended_ = true;
    code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  return ended_;
}

}  // namespace gaitway::tools
