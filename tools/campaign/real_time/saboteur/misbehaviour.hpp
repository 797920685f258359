// Ways to take a process down, to hang it or to use it up, by name. Only for a process of its own.
#pragma once

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

class Misbehaviour {
 public:
  explicit Misbehaviour(std::string how) : how_(std::move(how)) {}

  void begin() {
    if (how_ == "segfault") {
      *static_cast<volatile int*>(nullptr_) = 1;
    } else if (how_ == "abort") {
      std::abort();
    } else if (how_ == "exit") {
      std::exit(7);
    } else if (how_ == "throw") {
      throw std::runtime_error("it throws as it was told");
    } else if (how_ == "loop") {
      for (volatile bool on = true; on;) {
      }
    } else if (how_ == "memory") {
      for (;;) {
        leaked_ = new char[1U << 20U];
      }
    } else if (how_ == "descriptors") {
      while (open("/dev/null", O_RDONLY) >= 0) {
      }
      throw std::runtime_error(std::string("cannot open the camera: ") + std::strerror(errno));
    } else if (how_ == "fork") {
      if (fork() == 0) {
        _exit(0);
      }
    } else if (how_ == "socketpair") {
      int ends[2];
      if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0) {
        throw std::runtime_error("nobody refused the sockets");
      }
    } else if (how_ == "garbage") {
      overwrite_exchange();
    }
  }

 private:
  static void overwrite_exchange() {
    std::FILE* const maps = std::fopen("/proc/self/maps", "r");
    char line[512];
    while (maps != nullptr && std::fgets(line, sizeof line, maps) != nullptr) {
      unsigned long begin = 0, end = 0;
      if (std::strstr(line, "exchange") != nullptr && std::sscanf(line, "%lx-%lx", &begin, &end) == 2) {
        std::memset(reinterpret_cast<void*>(begin), 0xa5, end - begin);
      }
    }
  }

  std::string how_;
  void* volatile nullptr_ = nullptr;
  char* volatile leaked_ = nullptr;  // volatile: or the compiler leaves the leak out
};
