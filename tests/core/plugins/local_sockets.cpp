// A server on a Unix socket, with a thread of its own: takes a word a connection, does what it says, and
// answers with a number. "here NAME" is an attempt of the thread, "step NAME" one of the next step; the rest
// is below.
#include <sched.h>
#include <sys/un.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "forbidden_attempts.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/plugin/plugin.hpp"

namespace {

class LocalSockets final : public gaitway::Plugin {
 public:
  explicit LocalSockets(gaitway::Setup& setup)
      : path_(setup.parameter("door", std::string(), "where it listens")),
        door_(required("socket", new_socket())),
        attempts_(door_),
        report_(setup.reporter()),
        level_(setup.live_parameter("level", 0.0)) {
    if (setup.parameter("every_batch", false)) {
      setup.period(gaitway::Period::batch);
    }
    unlink(path_.c_str());  // of the process before
    const sockaddr_un address = door_address();
    required("bind", bind(door_, reinterpret_cast<const sockaddr*>(&address), sizeof address));
    required("listen", listen(door_, 16));
    greet_itself();
    if (setup.parameter("client", false)) {
      client_ = gaitway::msgclient::Client::connect(setup.memory_socket(), "server");
      walk_ = client_->write<gaitway::WalkCommand>("walk_command");
      client_->seal();
    }
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), "listens, memory at '%s'", setup.memory_socket().c_str());
    report_(gaitway::Severity::info, text.data());
    if (const std::string first = setup.parameter("attempt", std::string(), "of the constructor");
        !first.empty()) {
      report_error(first);
    }
    thread_ = std::thread([this] { serve(); });
  }
  ~LocalSockets() override {
    shutdown(door_, SHUT_RDWR);
    thread_.join();
    close(door_);
  }
  void step(const gaitway::Tick&) override {
    if (std::unique_ptr<std::string> name{asked_.exchange(nullptr)}) {
      if (*name == "wait") {
        waits_ = true;
        waits_.wait(true);
      } else if (*name == "greet") {
        greet_itself();
      } else {
        report_error(*name);
      }
    }
  }

 private:
  static int required(const char* call, int result) {
    if (result < 0) {
      throw std::runtime_error(std::string(call) + ": " + strerror(errno));
    }
    return result;
  }
  static int new_socket() { return socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0); }
  [[nodiscard]] sockaddr_un door_address() const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path_.copy(address.sun_path, sizeof address.sun_path - 1);
    return address;
  }
  // Connects to its own door; before there is the thread that accepts, that is done here, too.
  void greet_itself() {
    const int caller = required("socket", new_socket());
    const sockaddr_un address = door_address();
    required("connect", connect(caller, reinterpret_cast<const sockaddr*>(&address), sizeof address));
    if (!thread_.joinable()) {
      close(required("accept", accept(door_, nullptr, nullptr)));
    }
    close(caller);
    report_(gaitway::Severity::info, "reached its own door");
  }
  void report_error(const std::string& name) {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%s: error %d", name.c_str(), attempts_(name));
    report_(gaitway::Severity::info, text.data());
  }
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
      return attempts_(std::string(what.substr(5)));
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
    if (what == "process") {
      return getpid();
    }
    if (what == "policy") {
      return sched_getscheduler(0);
    }
    if (what == "priority") {
      sched_param parameter{};
      sched_getparam(0, &parameter);
      return parameter.sched_priority;
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

  std::string path_;
  int door_;
  ForbiddenAttempts attempts_;
  std::atomic<std::string*> asked_{nullptr};
  std::atomic<bool> waits_{false};
  gaitway::Reporter report_;
  gaitway::Live<double> level_;
  std::optional<gaitway::msgclient::Client> client_;
  std::optional<gaitway::msgclient::Writer<gaitway::WalkCommand>> walk_;
  std::thread thread_;
};

}  // namespace

GAITWAY_PLUGIN(LocalSockets, "local_sockets", "1.0.0", "Does over a Unix socket what it is told")
