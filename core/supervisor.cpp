// Watches one worker at a time by its pidfd, and by the ticks that it counts in shared memory.
#include "gaitway/core/supervisor.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <system_error>
#include <utility>

#include "gaitway/input/text.hpp"
#include "gaitway/manager/step_watch.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/process/wall_clock.hpp"

namespace gaitway::core {
namespace {

constexpr std::int64_t kBetweenLooks_ns = 20'000'000;    // between two looks at the ticks
constexpr std::int64_t kBetweenStarts_ns = 200'000'000;  // of those that fail
constexpr std::int64_t kBetweenKills_ns =
    1'000'000'000;  // from one start to the next, of those killed from outside
// Between two attempts to reach the message controller, each of which may wait so long for an answer.
constexpr std::int64_t kBetweenTries_ns = 20'000'000;
constexpr std::chrono::milliseconds kLongestAnswer{200};
// A look that comes later than that: this process was stopped itself, and the worker's silence says nothing.
constexpr std::int64_t kAway_ns = 500'000'000;
constexpr int kExitSignal = 128;                        // and the signal's number
constexpr std::int64_t kLongestEnd_ns = 5'000'000'000;  // from SIGTERM to the end

struct Death {
  int exit_code = 0;
  int signal = 0;            // 0: it ended by itself
  std::string stillborn;     // why it could not be started; empty: it was
  std::int64_t hung_ns = 0;  // it made no progress for so long and was ended; 0: it did not hang
  bool was_stopped = false;  // by SIGSTOP, as whoever hung
  std::int64_t at_ns = 0;
  // That was being stepped; empty: none, or SIGKILL came from outside (no step raises it), at whatever
  // instant.
  std::string plugin;
  std::string changed;  // or beside the ticks, where its code may have been at fault; empty: none

  [[nodiscard]] bool is_lost() const {
    return signal == 0 && hung_ns == 0 && stillborn.empty() && exit_code == kExitLost;
  }
  [[nodiscard]] bool came_from_outside() const { return was_stopped || (signal == SIGKILL && hung_ns == 0); }
};

// Ended with this object at the latest.
class Worker {
 public:
  // Delegates, so that the process is ended also where something throws after its start.
  Worker(const SupervisorOptions& options, const std::vector<std::string>& stopped)
      : Worker(StepWatch::make()) {
    std::vector<std::string> arguments{options.program};
    arguments.insert(arguments.end(), options.arguments.begin(), options.arguments.end());
    arguments.insert(arguments.end(), {"--step-watch", std::to_string(watch_.descriptor()), "--supervisor",
                                       std::to_string(getpid())});
    for (const std::string& name : stopped) {
      arguments.insert(arguments.end(), {"--culprit", name});
    }
    spawn(arguments);
    pidfd_ = process::FileDescriptor(static_cast<int>(syscall(SYS_pidfd_open, process_, 0)));
    if (!pidfd_) {
      throw std::system_error(errno, std::generic_category(), "watching the main controller's process");
    }
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() {
    if (process_ > 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
  }

  // Waits for its end, until `deadline_ns` or a signal.
  bool has_ended(std::int64_t deadline_ns) {
    pollfd ready{pidfd_.get(), POLLIN, 0};
    process::wait_until(deadline_ns, {&ready, 1});
    return (ready.revents & POLLIN) != 0;
  }
  Death take_death() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    Death death;
    death.at_ns = process::monotonic_ns();
    death.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    death.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    if (death.signal != SIGKILL) {
      death.changed = watch_.changed();
      death.plugin = death.changed.empty() ? watch_.current() : "";
    }
    return death;
  }
  void send(int signal) const { kill(process_, signal); }
  // By SIGSTOP or the like, and not continued.
  [[nodiscard]] bool is_stopped() const {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(process_), &info, WSTOPPED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == process_;
  }
  [[nodiscard]] std::uint64_t ticks() const noexcept { return watch_.ticks(); }
  [[nodiscard]] std::string current() const { return watch_.current(); }
  [[nodiscard]] bool is_ending() const noexcept { return watch_.is_ending(); }

 private:
  explicit Worker(StepWatch watch) : watch_(std::move(watch)) {}

  void spawn(std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) {
      argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    sigset_t none;
    sigemptyset(&none);
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    // Onto itself: the worker inherits it.
    posix_spawn_file_actions_adddup2(&actions, watch_.descriptor(), watch_.descriptor());
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    const int error = posix_spawn(&process_, argv[0], &actions, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
      process_ = 0;
      throw std::system_error(error, std::generic_category(), "starting the main controller's process");
    }
  }

  StepWatch watch_;
  pid_t process_ = 0;
  process::FileDescriptor pidfd_;
};

class Supervisor {
 public:
  explicit Supervisor(const SupervisorOptions& options) : options_(options) {}

  int run() {
    while (true) {
      const Death death = live();
      const bool lost = death.is_lost() && !options_.memory_socket.empty();
      if (death.signal == 0 && death.stillborn.empty() && !lost) {
        return death.exit_code;
      }
      if (process::stop_requested()) {
        return death.signal == 0 ? 0 : kExitSignal + death.signal;
      }
      died_ns_ = death.at_ns;
      if (lost ? !outlast_loss() : !may_restart(death)) {
        return lost ? 0 : kExitGivenUp;
      }
    }
  }

 private:
  // One worker from its start to its end. That it cannot be started again is a death like another.
  Death live() {
    started_ns_ = process::monotonic_ns();
    try {
      Worker worker(options_, stopped_);
      return watch(worker);
    } catch (const std::system_error& error) {
      if (died_ns_ == 0) {
        throw;
      }
      process::wait_until(process::monotonic_ns() + kBetweenStarts_ns, {});
      Death death;
      death.stillborn = error.what();
      death.at_ns = process::monotonic_ns();
      return death;
    }
  }

  // Progress is a tick; before the first one, that another plug-in is being set up, or none.
  Death watch(Worker& worker) {
    std::uint64_t ticks = 0;
    std::string plugin;
    std::int64_t progress_ns = process::monotonic_ns(), looked_ns = progress_ns;
    while (true) {
      const std::int64_t now_ns = process::monotonic_ns();
      progress_ns = now_ns - looked_ns > kAway_ns ? now_ns : progress_ns;
      looked_ns = now_ns;
      if (worker.has_ended(now_ns + kBetweenLooks_ns)) {
        return worker.take_death();
      }
      if (process::stop_requested()) {
        return end(worker);
      }
      const std::int64_t limit_ns = ticks > 0 ? kHang_ns : kStartHang_ns;
      if (worker.ticks() != ticks) {
        report_return(ticks);
        ticks = worker.ticks();
        progress_ns = now_ns;
      } else if (ticks == 0 && (worker.current().empty() || worker.current() != plugin)) {
        plugin = worker.current();
        progress_ns = now_ns;
      } else if (!worker.is_ending() && now_ns - progress_ns > limit_ns) {
        return end_hung(worker, limit_ns);
      }
    }
  }

  static Death end_hung(Worker& worker, std::int64_t limit_ns) {
    const bool was_stopped = worker.is_stopped();
    worker.send(SIGKILL);
    Death death = worker.take_death();
    death.hung_ns = limit_ns;
    death.was_stopped = was_stopped;
    death.plugin = was_stopped ? "" : worker.current();
    return death;
  }

  // Until somebody answers at the memory block's socket. False: told to end meanwhile.
  bool outlast_loss() {
    fmt::print(stderr, "main_controller: waiting for the message controller on {}\n",
               options_.memory_socket.string());
    while (!process::stop_requested()) {
      try {
        static_cast<void>(msgclient::Client::connect(options_.memory_socket, "supervisor", kLongestAnswer));
        fmt::print(stderr, "main_controller: there is a message controller after {} ms: started again\n",
                   (process::monotonic_ns() - died_ns_) / 1'000'000);
        return true;
      } catch (const msgclient::TopicError&) {  // nobody yet, or one that hangs
        process::wait_until(process::monotonic_ns() + kBetweenTries_ns, {});
      }
    }
    return false;
  }

  static Death end(Worker& worker) {
    worker.send(SIGTERM);
    const std::int64_t deadline_ns = process::monotonic_ns() + kLongestEnd_ns;
    while (!worker.has_ended(deadline_ns)) {
      if (process::monotonic_ns() >= deadline_ns) {
        worker.send(SIGKILL);
        break;
      }
    }
    return worker.take_death();
  }

  void report_return(std::uint64_t ticks_before) {
    if (ticks_before == 0 && died_ns_ != 0 && !options_.quiet) {
      fmt::print(stderr, "main_controller: back after {} ms\n",
                 (process::monotonic_ns() - died_ns_) / 1'000'000);
    }
  }

  static std::string how(const Death& death) {
    if (!death.stillborn.empty()) {
      return fmt::format("could not be started: {}", death.stillborn);
    }
    if (death.was_stopped) {
      return fmt::format("was stopped for {} ms and was ended", death.hung_ns / 1'000'000);
    }
    return death.hung_ns > 0
               ? fmt::format("made no tick for {} ms and was ended", death.hung_ns / 1'000'000)
               : fmt::format("was ended by signal {} ({})", death.signal, strsignal(death.signal));
  }
  static std::string where(const Death& death) {
    return !death.plugin.empty() ? fmt::format("in plug-in '{}'", input::terminal_text(death.plugin))
           : !death.changed.empty()
               ? fmt::format("while plug-in '{}' was changed", input::terminal_text(death.changed))
           : death.came_from_outside() ? "from outside"
                                       : "outside of any plug-in";
  }
  // With this one, those of the last minute.
  std::size_t count(std::int64_t at_ns) {
    deaths_ns_.push_back(at_ns);
    std::erase_if(deaths_ns_, [&](std::int64_t death_ns) { return at_ns - death_ns > kRestartWindow_ns; });
    return deaths_ns_.size();
  }

  // Says what happened.
  bool may_restart(const Death& death) {
    fmt::print(stderr, "main_controller: {}: {}, the process {}\n", process::date_and_time_of(death.at_ns),
               where(death), how(death));
    if (death.came_from_outside()) {
      process::wait_until(started_ns_ + kBetweenKills_ns, {});
    } else if (const std::size_t deaths = count(death.at_ns); deaths > std::size_t{kMostRestarts}) {
      fmt::print(
          stderr,
          "main_controller: {} deaths within {} s: not started again. The message controller's safe tail "
          "keeps the robot standing\n",
          deaths, kRestartWindow_ns / 1'000'000'000);
      return false;
    }
    const bool known = std::ranges::find(stopped_, death.plugin) != stopped_.end();
    if (!death.plugin.empty() && !known) {
      stopped_.push_back(death.plugin);
    }
    fmt::print(stderr, "main_controller: started again{}\n",
               stopped_.empty()
                   ? ""
                   : input::terminal_text(fmt::format(", without '{}'", fmt::join(stopped_, "', '"))));
    return true;
  }

  const SupervisorOptions& options_;
  std::vector<std::string> stopped_;
  std::vector<std::int64_t> deaths_ns_;  // of the last minute, without those from outside
  std::int64_t started_ns_ = 0;          // the last worker
  std::int64_t died_ns_ = 0;
};

}  // namespace

int supervise(const SupervisorOptions& options) {
  return Supervisor(options).run();
}

}  // namespace gaitway::core
