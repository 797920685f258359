// What a process that was taken over would try: each attempt by name, and the error number that it ends with.
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/openat2.h>
#include <netinet/in.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <thread>

class ForbiddenAttempts {
 public:
  // `inside` may be written to. `spare`: a socket that is neither bound nor connected.
  ForbiddenAttempts(std::filesystem::path inside, int spare)
      : inside_(std::move(inside)), outside_(inside_.parent_path()), spare_(spare) {}

  // 0: it succeeded; -1: there is no such attempt.
  int operator()(const std::string& name) {
    const auto found = attempts_.find(name);
    errno = 0;
    return found == attempts_.end() ? -1 : found->second() < 0 ? errno : 0;
  }

 private:
  static sockaddr_in address(std::uint16_t port) {
    sockaddr_in result{};
    result.sin_family = AF_INET;
    result.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    result.sin_port = htons(port);
    return result;
  }
  template <class Call>
  long on_address(const Call& call) {
    const sockaddr_in to = address(9);
    return call(spare_, reinterpret_cast<const sockaddr*>(&to), socklen_t{sizeof to});
  }
  static long opened(const std::filesystem::path& file, int flags) {
    const int descriptor = open(file.c_str(), flags | O_CLOEXEC, 0600);
    close_if_open(descriptor);
    return descriptor;
  }
  static void close_if_open(int descriptor) {
    const int error = errno;
    if (descriptor >= 0) {
      close(descriptor);
    }
    errno = error;
  }
  static long new_process() {
    const pid_t child = fork();
    if (child == 0) {
      _exit(0);
    }
    return child < 0 ? child : waitpid(child, nullptr, 0);
  }
  long write_inside() {
    const int descriptor =
        open((inside_ / "recording").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    const long written = descriptor < 0 ? -1 : write(descriptor, "data", 4);
    close_if_open(descriptor);
    return written;
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
      const int again = open(("/proc/self/fd/" + std::to_string(number)).c_str(), O_WRONLY | O_CREAT, 0600);
      const long written = again < 0 ? -1 : pwrite(again, "x", 1, 0);
      close_if_open(again);
      if (written == 1) {
        return written;
      }
    }
    errno = EACCES;
    return -1;
  }
  long own_by_another() { return fcntl(spare_, F_SETOWN, getppid()); }
  static long limit_of_another() {
    // A pointer whose lower word is zero.
    auto* const at = reinterpret_cast<rlimit*>(0x1'0000'0000L);
    return syscall(SYS_prlimit64, getppid(), RLIMIT_CPU, at, nullptr);
  }

  std::filesystem::path inside_, outside_;
  int spare_;
  std::map<std::string, std::function<long()>> attempts_{
      {"socket", [] { return long{socket(AF_INET, SOCK_STREAM, 0)}; }},
      {"socketpair",
       [] {
         int ends[2];
         return long{socketpair(AF_UNIX, SOCK_STREAM, 0, ends)};
       }},
      {"connect", [this] { return on_address([](auto... it) { return long{connect(it...)}; }); }},
      {"fast open",
       [this] {
         return on_address(
             [](int s, const sockaddr* to, socklen_t n) { return sendto(s, "x", 1, MSG_FASTOPEN, to, n); });
       }},
      {"bind", [this] { return on_address([](auto... it) { return long{bind(it...)}; }); }},
      {"listen", [this] { return long{listen(spare_, 1)}; }},
      {"read", [] { return opened("/etc/passwd", O_RDONLY); }},
      {"read and write", [this] { return opened(inside_ / "recording", O_RDWR | O_CREAT); }},
      {"path", [] { return opened("/etc", O_PATH | O_WRONLY | O_CREAT); }},
      {"write inside", [this] { return write_inside(); }},
      {"write outside", [this] { return opened(outside_ / "taken", O_WRONLY | O_CREAT); }},
      {"write beside", [this] { return opened(inside_ / ".." / "taken", O_WRONLY | O_CREAT); }},
      {"write to memory", [] { return opened("/proc/self/mem", O_WRONLY | O_CREAT); }},
      {"reopen", [] { return reopened(); }},
      {"openat2",
       [] {
         open_how how{};
         return syscall(SYS_openat2, AT_FDCWD, "/etc/passwd", &how, sizeof how);
       }},
      {"unlink", [this] { return long{unlink((inside_ / "kept").c_str())}; }},
      {"rename", [this] { return long{rename((inside_ / "kept").c_str(), (inside_ / "b").c_str())}; }},
      {"mkdir", [this] { return long{mkdir((inside_ / "folder").c_str(), 0700)}; }},
      {"link", [this] { return long{link("/etc/passwd", (inside_ / "passwd").c_str())}; }},
      {"symlink", [this] { return long{symlink("/etc", (inside_ / "etc").c_str())}; }},
      {"chmod", [this] { return long{chmod((inside_ / "kept").c_str(), 0777)}; }},
      {"chown", [this] { return long{chown((inside_ / "kept").c_str(), getuid(), getgid())}; }},
      {"truncate", [this] { return long{truncate((inside_ / "kept").c_str(), 0)}; }},
      {"mount", [] { return long{mount("none", "/mnt", "tmpfs", 0, nullptr)}; }},
      {"kill", [] { return long{kill(getppid(), 0)}; }},
      {"own", [this] { return own_by_another(); }},
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
