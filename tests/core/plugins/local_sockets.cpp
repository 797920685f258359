// Listens at a Unix socket (parameter `path`), with a thread of its own: takes a word a connection, does what
// it says, and answers with a number. "here NAME" is an attempt of the thread, "step NAME" one of the next
// step; the rest is below.
#include <linux/netlink.h>
#include <sched.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/plugin/plugin.hpp"

namespace {

// 0: it succeeded; else the error number; -1: there is no such attempt.
int attempt(std::string_view name, const sockaddr_un& own) {
  const auto opened = [](int descriptor) {
    const int error = descriptor < 0 ? errno : 0;
    close(descriptor);
    return error;
  };
  if (name == "unix") return opened(socket(AF_UNIX, SOCK_STREAM, 0));
  if (name == "tcp") return opened(socket(AF_INET, SOCK_STREAM, 0));
  if (name == "udp") return opened(socket(AF_INET6, SOCK_DGRAM, 0));
  if (name == "netlink") return opened(socket(AF_NETLINK, SOCK_RAW, NETLINK_ROUTE));
  if (name == "packet") return opened(socket(AF_PACKET, SOCK_DGRAM, 0));
  if (name == "connect") {
    const int connection = socket(AF_UNIX, SOCK_STREAM, 0);
    const int error =
        connect(connection, reinterpret_cast<const sockaddr*>(&own), sizeof own) == 0 ? 0 : errno;
    close(connection);
    return error;
  }
  if (name == "fork") {
    const pid_t child = fork();
    if (child == 0) _exit(0);
    return child < 0 ? errno : 0;
  }
  if (name == "execve") return execl("/bin/true", "true", nullptr) < 0 ? errno : 0;
  if (name == "ptrace") return ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) < 0 ? errno : 0;
  if (name == "kill") return kill(getppid(), 0) < 0 ? errno : 0;
  return -1;
}

class LocalSockets final : public gaitway::Plugin {
 public:
  explicit LocalSockets(gaitway::Setup& setup)
      : door_(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)), report_(setup.reporter()) {
    if (setup.parameter("client", false)) {
      client_ = gaitway::msgclient::Client::connect(setup.memory_socket(), "server");
      walk_ = client_->write<gaitway::WalkCommand>("walk_command");
      client_->seal();
    }
    const std::string path = setup.parameter("path", "");
    address_.sun_family = AF_UNIX;
    path.copy(address_.sun_path, sizeof address_.sun_path - 1);
    unlink(path.c_str());
    if (door_ < 0 || bind(door_, reinterpret_cast<sockaddr*>(&address_), sizeof address_) != 0 ||
        listen(door_, 16) != 0) {
      throw std::runtime_error("no socket");
    }
    report_(gaitway::Severity::info, ("memory at '" + setup.memory_socket().string() + "'").c_str());
    thread_ = std::thread([this] { serve(); });
  }
  ~LocalSockets() override {
    shutdown(door_, SHUT_RDWR);
    thread_.join();
  }
  void step(const gaitway::Tick&) override {
    if (std::unique_ptr<std::string> name{asked_.exchange(nullptr)}) {
      if (*name == "wait") {
        waits_ = true;
        waits_.wait(true);
      } else {
        std::array<char, 40> text{};
        std::snprintf(text.data(), text.size(), "error %d", attempt(*name, address_));
        report_(gaitway::Severity::info, text.data());
      }
    }
  }

 private:
  void serve() {
    std::array<char, 200> text{};
    for (int client = accept(door_, nullptr, nullptr); client >= 0;
         client = accept(door_, nullptr, nullptr)) {
      const ssize_t got = recv(client, text.data(), text.size(), 0);
      const std::string answer =
          std::to_string(do_it({text.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0))}));
      send(client, answer.data(), answer.size(), MSG_NOSIGNAL);
      close(client);
    }
  }
  int do_it(std::string_view what) {
    if (what.starts_with("here ")) {
      return attempt(what.substr(5), address_);
    }
    if (what.starts_with("step ")) {
      delete asked_.exchange(new std::string(what.substr(5)));
      return 0;
    }
    if (what == "waits") {
      return waits_ ? 1 : 0;
    }
    if (what == "go on") {
      waits_ = false;
      waits_.notify_all();
      return 0;
    }
    if (what == "descriptors") {
      rlimit limit{};
      getrlimit(RLIMIT_NOFILE, &limit);
      return static_cast<int>(limit.rlim_cur);
    }
    if (what == "memory") {  // MiB
      rlimit limit{};
      getrlimit(RLIMIT_AS, &limit);
      return static_cast<int>(limit.rlim_cur >> 20U);
    }
    if (what == "walk") {
      walk_->publish({.stamp_ns = 1,
                      .walk = 1,
                      .padding0 = {},
                      .velocity = {0.1, 0.0},
                      .turn_rate = 0.0,
                      .valid_until_ns = 2},
                     1);
      return 0;
    }
    if (what == "claim") {
      return claims("trim") ? 0 : 1;
    }
    if (what == "die") {
      std::abort();
    }
    return -1;
  }

  bool claims(std::string_view topic) {
    try {
      static_cast<void>(client_->write<gaitway::TrimCommand>(topic));
      return true;
    } catch (const gaitway::msgclient::TopicError&) {
      return false;
    }
  }

  int door_;
  sockaddr_un address_{};
  std::atomic<std::string*> asked_{nullptr};
  std::atomic<bool> waits_{false};
  gaitway::Reporter report_;
  std::optional<gaitway::msgclient::Client> client_;
  std::optional<gaitway::msgclient::Writer<gaitway::WalkCommand>> walk_;
  std::thread thread_;
};

}  // namespace

GAITWAY_PLUGIN(LocalSockets, "local_sockets", "1.0.0", "Does over a Unix socket what it should not")
