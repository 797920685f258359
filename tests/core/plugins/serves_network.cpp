// A server on 127.0.0.1, with a thread of its own: takes a word a connection, does what it says, and answers
// with a number. "here NAME" is an attempt of the thread, "step NAME" one of the next step; the rest is
// below.
#include <pthread.h>
#include <sched.h>

#include <array>
#include <atomic>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "forbidden_attempts.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/plugin/plugin.hpp"

namespace {

class ServesNetwork final : public gaitway::Plugin {
 public:
  explicit ServesNetwork(gaitway::Setup& setup)
      : door_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)),
        attempts_(setup.write_folder(), socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)),
        report_(setup.reporter()) {
    if (setup.parameter("client", false)) {
      client_ = gaitway::msgclient::Client::connect(setup.memory_socket(), "server");
      walk_ = client_->write<gaitway::WalkCommand>("walk_command");
      client_->seal();
    }
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (bind(door_, reinterpret_cast<sockaddr*>(&address), size) != 0 || listen(door_, 16) != 0 ||
        getsockname(door_, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
      throw std::runtime_error("no port");
    }
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), "port %d, memory at '%s', writes to '%s'",
                  ntohs(address.sin_port), setup.memory_socket().c_str(), setup.write_folder().c_str());
    report_(gaitway::Severity::info, text.data());
    // As network libraries do it.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    thread_ = std::thread([this] { serve(); });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }
  ~ServesNetwork() override {
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
        std::snprintf(text.data(), text.size(), "error %d", attempts_(*name));
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
    if (what == "nice") {
      return getpriority(PRIO_PROCESS, 0);
    }
    if (what == "policy") {
      return sched_getscheduler(0);
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
  ForbiddenAttempts attempts_;
  std::atomic<std::string*> asked_{nullptr};
  std::atomic<bool> waits_{false};
  gaitway::Reporter report_;
  std::optional<gaitway::msgclient::Client> client_;
  std::optional<gaitway::msgclient::Writer<gaitway::WalkCommand>> walk_;
  std::thread thread_;
};

}  // namespace

GAITWAY_PLUGIN(ServesNetwork, "serves_network", "1.0.0", "Does over TCP what it should not")
