// What a process that was taken over would try: each attempt by name, and the error number that it ends with.
#pragma once

#include <fcntl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <functional>
#include <map>
#include <string>
#include <thread>

class ForbiddenAttempts {
 public:
  // `descriptor`: any that is open, of which the owner is changed.
  explicit ForbiddenAttempts(int descriptor) : descriptor_(descriptor) {}

  // 0: it succeeded; -1: there is no such attempt.
  int operator()(const std::string& name) {
    const auto found = attempts_.find(name);
    errno = 0;
    return found == attempts_.end() ? -1 : found->second() < 0 ? errno : 0;
  }

 private:
  static long close_if_open(long descriptor) {
    const int error = errno;
    if (descriptor >= 0) {
      close(static_cast<int>(descriptor));
    }
    errno = error;
    return descriptor;
  }
  static long new_socket(int family, int type) {
    return close_if_open(socket(family, type | SOCK_CLOEXEC, 0));
  }
  // The kernel looks at the lower word of the family alone.
  static long new_socket_with_upper_word(int family) {
    return close_if_open(syscall(SYS_socket, 0x1'0000'0000L | family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  }
  static long new_pair(int family) {
    std::array<int, 2> ends{-1, -1};
    const int result = socketpair(family, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data());
    close_if_open(ends[0]);
    close_if_open(ends[1]);
    return result;
  }
  static long new_process() {
    const pid_t child = fork();
    if (child == 0) {
      _exit(0);
    }
    return child < 0 ? child : waitpid(child, nullptr, 0);
  }
  // Of all that it may only read, the first that it gets to write: a topic's memory.
  static long reopened() {
    for (int number = 0; number < 256; ++number) {
      struct stat status {};
      const int flags = fcntl(number, F_GETFL);
      if (flags < 0 || (flags & O_ACCMODE) != O_RDONLY || fstat(number, &status) != 0 ||
          !S_ISREG(status.st_mode) || status.st_nlink != 0) {
        continue;
      }
      const int again = open(("/proc/self/fd/" + std::to_string(number)).c_str(), O_WRONLY | O_CLOEXEC);
      const long written = again < 0 ? -1 : pwrite(again, "x", 1, 0);
      close_if_open(again);
      if (written == 1) {
        return written;
      }
    }
    errno = EACCES;
    return -1;
  }
  static long limit_of_another() {
    // A pointer whose lower word is zero.
    auto* const at = reinterpret_cast<rlimit*>(0x1'0000'0000L);
    return syscall(SYS_prlimit64, getppid(), RLIMIT_CPU, at, nullptr);
  }

  int descriptor_;
  std::map<std::string, std::function<long()>> attempts_{
      {"unix", [] { return new_socket(AF_UNIX, SOCK_STREAM); }},
      {"unix datagram", [] { return new_socket(AF_UNIX, SOCK_DGRAM); }},
      {"unix pair", [] { return new_pair(AF_UNIX); }},
      {"tcp", [] { return new_socket(AF_INET, SOCK_STREAM); }},
      {"tcp 6", [] { return new_socket(AF_INET6, SOCK_STREAM); }},
      {"udp", [] { return new_socket(AF_INET, SOCK_DGRAM); }},
      {"raw", [] { return new_socket(AF_INET, SOCK_RAW); }},
      {"netlink", [] { return new_socket(AF_NETLINK, SOCK_RAW); }},
      {"packet", [] { return new_socket(AF_PACKET, SOCK_RAW); }},
      {"can", [] { return new_socket(AF_CAN, SOCK_RAW); }},
      {"hypervisor", [] { return new_socket(AF_VSOCK, SOCK_STREAM); }},
      {"tcp with an upper word", [] { return new_socket_with_upper_word(AF_INET); }},
      {"unix with an upper word", [] { return new_socket_with_upper_word(AF_UNIX); }},
      {"tcp pair", [] { return new_pair(AF_INET); }},
      {"reopen", [] { return reopened(); }},
      {"kill", [] { return long{kill(getppid(), 0)}; }},
      {"own", [this] { return long{fcntl(descriptor_, F_SETOWN, getppid())}; }},
      {"limit", [] { return limit_of_another(); }},
      {"fork", [] { return new_process(); }},
      {"execve",
       [] {
         char* const nothing[] = {nullptr};
         return long{execve("/bin/true", nothing, nothing)};
       }},
      {"ptrace", [] { return ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr); }},
      {"real time",
       [] {
         const sched_param first{.sched_priority = 1};
         return long{sched_setscheduler(0, SCHED_FIFO, &first)};
       }},
      {"thread",
       [] {
         std::thread([] {}).join();
         return 0L;
       }},
  };
};
