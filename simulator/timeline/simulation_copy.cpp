// fork(), and what its copies are told.
#include "gaitway/timeline/simulation_copy.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace gaitway::timeline {
namespace {

// Who presses Ctrl-C means the program, which ends its copies itself.
void leave_signals_to_the_program() {
  signal(SIGINT, SIG_IGN);
  signal(SIGTERM, SIG_IGN);
  signal(SIGHUP, SIG_IGN);
  signal(SIGCHLD, SIG_IGN);  // a copy's copies are waited for by whoever holds them
}

class SimulationCopy {
 public:
  SimulationCopy(std::unique_ptr<ReplayedRun> run, CopyChannel channel, const Live& live)
      : run_(std::move(run)), channel_(std::move(channel)), live_(live) {}

  void serve() {
    while (true) {
      const auto packet = channel_.receive(CopyChannel::kForEver);
      if (!packet) continue;
      const nlohmann::json& told = packet->message;
      const auto what = told.at("do").get<std::string>();
      if (what == "copy") {
        copy();
      } else if (what == "events") {
        run_->expect(events_from(told.at("events")));
      } else if (what == "advance") {
        run_->advance_to(told.at("to_ns").get<std::int64_t>());
        channel_.send({{"at_ns", run_->run().now_ns()}, {"digest", run_->digest()}});
      } else if (what == "live") {
        live_(*run_, channel_, told);
        return;
      } else {
        throw std::logic_error("a copy of the simulation does not know '" + what + "'");
      }
    }
  }
  [[nodiscard]] const CopyChannel& channel() const noexcept { return channel_; }

 private:
  // Both go on from here; the copy with a channel of its own.
  void copy() {
    auto [ours, others] = CopyChannel::pair();
    const pid_t process = fork();
    if (process < 0) throw std::system_error(errno, std::generic_category(), "no copy of the simulation");
    if (process == 0) {
      channel_ = std::move(ours);
      return;
    }
    channel_.send({{"copied", process}}, others.descriptor());
  }

  std::unique_ptr<ReplayedRun> run_;
  CopyChannel channel_;
  const Live& live_;
};

// Neither destructors nor exit handlers run: what they would clean up is another process's.
[[noreturn]] void be_the_first(CopyChannel channel, const MakeRun& make, const Live& live) {
  leave_signals_to_the_program();
  // What is left of copies whose own parent has ended comes to this process, which lives as long as the
  // simulation and leaves no zombies, since it ignores SIGCHLD.
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const CopyChannel* said_to = &channel;
  std::optional<SimulationCopy> copy;
  try {
    auto run = make();
    run->run().keep_to_this_process();  // and so do all copies of this one
    channel.send({{"copied", getpid()}});
    copy.emplace(std::move(run), std::move(channel), live);
    said_to = &copy->channel();
    copy->serve();
  } catch (const ChannelEnded&) {
  } catch (const std::exception& error) {
    try {
      said_to->send({{"failed", error.what()}});
    } catch (const std::exception&) {
      _exit(1);  // nobody listens
    }
  }
  _exit(0);
}

}  // namespace

CopyHandle::CopyHandle(CopyChannel channel, pid_t process)
    : channel_(std::move(channel)),
      id_(process),
      process_(static_cast<int>(syscall(SYS_pidfd_open, process, 0))) {}

CopyHandle& CopyHandle::operator=(CopyHandle&& other) noexcept {
  end();
  channel_ = std::move(other.channel_);
  id_ = other.id_;
  process_ = std::move(other.process_);
  return *this;
}

CopyHandle::~CopyHandle() {
  end();
}

void CopyHandle::end() noexcept {
  if (!process_) return;
  syscall(SYS_pidfd_send_signal, process_.get(), SIGKILL, nullptr, 0);
  pollfd ended{process_.get(), POLLIN, 0};
  while (poll(&ended, 1, CopyChannel::kForEver) < 0 && errno == EINTR) {
  }
  waitid(P_PIDFD, static_cast<id_t>(process_.get()), nullptr,
         WEXITED);  // where it is a child of this process
  process_ = {};
}

std::optional<CopyChannel::Packet> CopyHandle::receive(int patience_ms) const {
  auto packet = channel_.receive(patience_ms);
  if (packet && packet->message.contains("failed")) {
    throw std::runtime_error(packet->message.at("failed").get<std::string>());
  }
  return packet;
}

CopyHandle CopyHandle::copy() const {
  channel_.send({{"do", "copy"}});
  auto packet = receive(CopyChannel::kForEver);
  while (!packet) packet = receive(CopyChannel::kForEver);
  return {CopyChannel(std::move(packet->passed)), packet->message.at("copied").get<pid_t>()};
}

CopyHandle start_simulation(const MakeRun& make, const Live& live) {
  auto [ours, others] = CopyChannel::pair();
  const pid_t process = fork();
  if (process < 0) throw std::system_error(errno, std::generic_category(), "no process for the simulation");
  if (process == 0) {
    { const CopyChannel not_mine = std::move(ours); }
    be_the_first(std::move(others), make, live);
  }
  { const CopyChannel not_mine = std::move(others); }
  CopyHandle handle(std::move(ours), process);
  while (!handle.receive(CopyChannel::kForEver)) {
  }
  return handle;
}

}  // namespace gaitway::timeline
