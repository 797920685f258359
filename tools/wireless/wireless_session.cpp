#include "tools/wireless/wireless_session.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/epoll.h>
#include <sys/signalfd.h>
#include <sys/stat.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "gaitway/input/number.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/real_time.hpp"
#include "tools/command_line.hpp"
#include "tools/wireless/link_side.hpp"

namespace gaitway::tools {
namespace {

constexpr const char* kRobotAddress = "10.77.0.1";
constexpr const char* kClientAddress = "10.77.0.2";
constexpr std::int64_t kGrace_ns = 5'000'000'000;  // from SIGTERM to SIGKILL
constexpr std::int64_t kForever_ns = std::numeric_limits<std::int64_t>::max();
constexpr int kPacketsATurn = 64;  // from one end, so that the other has its turn
constexpr int kPriority = 10;

// A FIFO that others write lines to; made where there is none, and then removed at the end.
class ControlPipe {
 public:
  explicit ControlPipe(const std::optional<std::filesystem::path>& path) {
    if (!path) return;
    struct stat there {};
    if (stat(path->c_str(), &there) == 0) {
      if (!S_ISFIFO(there.st_mode)) refuse(*path, "is there and no FIFO");
    } else if (mkfifo(path->c_str(), 0600) == 0) {
      made_ = *path;
    } else {
      refuse(*path, std::strerror(errno));
    }
    fifo_ = process::FileDescriptor(open(path->c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC));
    if (!fifo_) refuse(*path, std::strerror(errno));
    setenv("GAITWAY_WIRELESS_CONTROL", std::filesystem::absolute(*path).c_str(), 1);
  }
  ControlPipe(const ControlPipe&) = delete;
  ControlPipe& operator=(const ControlPipe&) = delete;
  ~ControlPipe() {
    if (!made_.empty()) unlink(made_.c_str());
  }
  [[nodiscard]] int get() const { return fifo_.get(); }

 private:
  [[noreturn]] static void refuse(const std::filesystem::path& path, const std::string& why) {
    throw std::invalid_argument(fmt::format("--control {}: {}. Name a new file", path.string(), why));
  }
  process::FileDescriptor fifo_;
  std::filesystem::path made_;
};

process::FileDescriptor ended_or_signalled() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int number : {SIGCHLD, SIGINT, SIGTERM}) sigaddset(&signals, number);
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  return process::FileDescriptor(signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC));
}

// The terminal's keys go to the client while it runs.
class Foreground {
 public:
  explicit Foreground(pid_t group) {
    if (tcgetpgrp(STDIN_FILENO) != getpgrp()) return;
    std::signal(SIGTTOU, SIG_IGN);
    taken_ = tcsetpgrp(STDIN_FILENO, group) == 0;
  }
  Foreground(const Foreground&) = delete;
  Foreground& operator=(const Foreground&) = delete;
  ~Foreground() {
    if (taken_) tcsetpgrp(STDIN_FILENO, getpgrp());
  }

 private:
  bool taken_ = false;
};

class Session {
 public:
  explicit Session(const WirelessSettings& settings)
      : settings_(settings), link_(settings.link, settings.seed), control_(settings.control) {
    if (settings.robot_ready) ready_ = std::regex(*settings.robot_ready);
    if (settings.outage_log) {
      log_.open(*settings.outage_log);
      if (!log_) {
        throw std::invalid_argument(fmt::format("--outage-log {}: cannot be written. Name another file",
                                                settings.outage_log->string()));
      }
    }
    std::array<int, 2> pipe{};
    if (pipe2(pipe.data(), O_CLOEXEC) != 0) throw std::runtime_error("a pipe cannot be made");
    robot_output_ = process::FileDescriptor(pipe[0]);
    fcntl(pipe[0], F_SETFL, O_NONBLOCK);
    const process::FileDescriptor write_end(pipe[1]);
    robot_.emplace(SideSettings{kRobotAddress, kClientAddress, settings.robot, pipe[1], false});
    client_.emplace(SideSettings{kClientAddress, kRobotAddress, settings.client, -1, true});
    signals_ = ended_or_signalled();
    timer_ = process::FileDescriptor(timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC));
    poll_ = process::FileDescriptor(epoll_create1(EPOLL_CLOEXEC));
    for (const int each :
         {robot_->tun(), client_->tun(), signals_.get(), timer_.get(), robot_output_.get(), control_.get()}) {
      watch(each);
    }
    const sched_param priority{kPriority};  // where the rights are missing it runs as well, later under load
    sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &priority);
  }

  WirelessResult run() {
    robot_->start();
    if (!settings_.robot.empty() && settings_.robot_ready) wait_for_robot();
    const std::int64_t start_ns = process::monotonic_ns();
    reported_ns_ = result_.client_started_ns = start_ns;
    for (const Outage& each : settings_.outages) {
      link_.add_outage(start_ns, {start_ns + each.begin_ns, start_ns + each.end_ns});
    }
    client_running_ = true;
    const Foreground foreground(client_->group());
    client_->start();
    std::int64_t kill_ns = kForever_ns;
    while (!client_->reap()) {
      if (stopped_ && kill_ns == kForever_ns) {
        client_->signal(SIGTERM);
        kill_ns = process::monotonic_ns() + kGrace_ns;
      }
      if (process::monotonic_ns() >= kill_ns) client_->signal(SIGKILL);
      turn(kill_ns);
    }
    report_edges(process::monotonic_ns());
    result_.client_ended_ns = process::monotonic_ns();
    if (!settings_.robot.empty() && robot_->reap()) result_.robot_code = robot_->code();
    end_robot();
    return finish();
  }

 private:
  void watch(int descriptor) {
    if (descriptor < 0) return;
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.fd = descriptor;
    if (epoll_ctl(poll_.get(), EPOLL_CTL_ADD, descriptor, &event) != 0) {
      throw std::runtime_error("a descriptor cannot be watched");
    }
  }

  void wait_for_robot() {
    const std::int64_t deadline_ns = process::monotonic_ns() + settings_.robot_ready_within_ns;
    while (!robot_is_ready_) {
      if (robot_->reap()) {
        throw NotDone(
            fmt::format("the robot's program ended with {} before it was ready: no line of it matched '{}'",
                        robot_->code(), *settings_.robot_ready));
      }
      if (stopped_) throw NotDone("it was stopped before the robot's program was ready");
      if (process::monotonic_ns() >= deadline_ns) {
        throw NotDone(
            fmt::format("the robot's program was not ready in time: no line of it matched '{}'. Change "
                        "--robot-ready, or wait longer with --robot-ready-within",
                        *settings_.robot_ready));
      }
      turn(deadline_ns);
    }
  }

  void end_robot() {
    if (settings_.robot.empty()) return;
    robot_->signal(SIGTERM);
    const std::int64_t kill_ns = process::monotonic_ns() + kGrace_ns;
    while (!robot_->reap()) {
      if (process::monotonic_ns() >= kill_ns) robot_->signal(SIGKILL);
      turn(kill_ns);
    }
    forward_robot_output();
  }

  WirelessResult finish() {
    result_.client_code = client_->code();
    for (const LinkEnd end : {LinkEnd::robot, LinkEnd::client}) {
      result_.from[static_cast<std::size_t>(end)] = link_.statistics(end);
      result_.under_way[static_cast<std::size_t>(end)] = link_.under_way(end);
    }
    for (Outage each : link_.outages().all()) {
      if (each.begin_ns >= result_.client_ended_ns) break;
      each.end_ns = std::min(each.end_ns, result_.client_ended_ns);
      result_.outages.push_back(each);
    }
    return std::move(result_);
  }

  // Waits until something comes or is due, and does it.
  void turn(std::int64_t deadline_ns) {
    arm(deadline_ns);
    std::array<epoll_event, 8> events{};
    const int count = epoll_wait(poll_.get(), events.data(), events.size(), -1);
    for (int i = 0; i < count; ++i) {
      const int ready = events[static_cast<std::size_t>(i)].data.fd;
      if (ready == robot_->tun()) take_packets(LinkEnd::robot);
      if (ready == client_->tun()) take_packets(LinkEnd::client);
      if (ready == robot_output_.get()) forward_robot_output();
      if (ready == control_.get()) take_orders();
      if (ready == signals_.get()) take_signals();
      if (ready == timer_.get()) {
        std::uint64_t times = 0;
        static_cast<void>(!read(timer_.get(), &times, sizeof times));
      }
    }
    release();
    if (client_running_) report_edges(process::monotonic_ns());
  }

  void arm(std::int64_t deadline_ns) {
    std::int64_t next_ns = std::min(deadline_ns, link_.next_ns().value_or(kForever_ns));
    if (client_running_) {
      if (const auto edge = link_.outages().edge_after(reported_ns_))
        next_ns = std::min(next_ns, edge->at_ns);
    }
    itimerspec when{};
    if (next_ns != kForever_ns) {
      when.it_value.tv_sec = next_ns / 1'000'000'000;
      when.it_value.tv_nsec = next_ns % 1'000'000'000;
    }
    timerfd_settime(timer_.get(), TFD_TIMER_ABSTIME, &when, nullptr);
  }

  void take_packets(LinkEnd from) {
    const int tun = from == LinkEnd::robot ? robot_->tun() : client_->tun();
    for (int i = 0; i < kPacketsATurn; ++i) {
      const ssize_t size = read(tun, packet_.data(), packet_.size());
      if (size <= 0) return;
      if (packet_[0] >> 4U != 4) continue;  // the kernel's own talk of IPv6
      link_.send(from, process::monotonic_ns(), Packet(packet_.begin(), packet_.begin() + size));
    }
  }

  void release() {
    while (const auto delivery = link_.receive(process::monotonic_ns())) {
      const int tun = delivery->to == LinkEnd::robot ? robot_->tun() : client_->tun();
      static_cast<void>(!write(tun, delivery->packet.data(), delivery->packet.size()));
      result_.lateness.add(process::monotonic_ns() - delivery->at_ns);
    }
  }

  void report_edges(std::int64_t now_ns) {
    for (auto edge = link_.outages().edge_after(reported_ns_); edge && edge->at_ns <= now_ns;
         edge = link_.outages().edge_after(reported_ns_)) {
      outages_begun_ += edge->down ? 1 : 0;
      if (log_.is_open()) {
        log_ << fmt::format("{{\"outage\": {}, \"{}\": {}}}\n", outages_begun_,
                            edge->down ? "began_ns" : "ended_ns", edge->at_ns)
             << std::flush;
      }
      reported_ns_ = edge->at_ns;
    }
  }

  void take_orders() {
    std::array<char, 4096> text{};
    const ssize_t size = read(control_.get(), text.data(), text.size());
    orders_.append(text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    for (std::size_t end = orders_.find('\n'); end != std::string::npos; end = orders_.find('\n')) {
      obey(input::trimmed(std::string_view(orders_).substr(0, end)));
      orders_.erase(0, end + 1);
    }
  }

  void obey(std::string_view order) {
    constexpr std::string_view kOutage = "outage ";
    try {
      if (!order.starts_with(kOutage)) {
        throw std::invalid_argument("there is no such order. Write it like 'outage 0.5s'");
      }
      const std::int64_t length_ns =
          input::number_with_unit(order.substr(kOutage.size()), input::kTimeUnits_ns, 1, 3'600'000'000'000);
      const std::int64_t now_ns = process::monotonic_ns();
      release();
      link_.add_outage(now_ns, {now_ns, now_ns + length_ns});
    } catch (const std::exception& error) {
      fmt::print(stderr, "gaitway: '{}': {}\n", input::terminal_text(order), error.what());
    }
  }

  void forward_robot_output() {
    std::array<char, 4096> text{};
    ssize_t size = 0;
    while ((size = read(robot_output_.get(), text.data(), text.size())) > 0) {
      const std::string_view part(text.data(), static_cast<std::size_t>(size));
      std::fwrite(part.data(), 1, part.size(), stderr);
      if (!robot_is_ready_ && ready_) look_for_readiness(part);
    }
    if (size == 0) epoll_ctl(poll_.get(), EPOLL_CTL_DEL, robot_output_.get(), nullptr);
  }

  void look_for_readiness(std::string_view part) {
    line_ += part;
    for (std::size_t end = line_.find('\n'); end != std::string::npos; end = line_.find('\n')) {
      robot_is_ready_ = robot_is_ready_ || std::regex_search(line_.substr(0, end), *ready_);
      line_.erase(0, end + 1);
    }
  }

  void take_signals() {
    signalfd_siginfo signal{};
    while (read(signals_.get(), &signal, sizeof signal) == sizeof signal) {
      stopped_ = stopped_ || signal.ssi_signo != SIGCHLD;
    }
  }

  const WirelessSettings& settings_;
  LinkEmulator link_;
  ControlPipe control_;
  std::optional<std::regex> ready_;
  std::ofstream log_;
  process::FileDescriptor robot_output_, signals_, timer_, poll_;
  std::optional<LinkSide> robot_, client_;
  std::array<std::uint8_t, 65'536> packet_{};
  std::string orders_, line_;
  bool robot_is_ready_ = false, client_running_ = false, stopped_ = false;
  std::int64_t reported_ns_ = 0;
  int outages_begun_ = 0;
  WirelessResult result_;
};

}  // namespace

WirelessResult run_wireless(const WirelessSettings& settings) {
  return Session(settings).run();
}

}  // namespace gaitway::tools
