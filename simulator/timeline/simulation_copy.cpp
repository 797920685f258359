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
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

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
        if (told.value("what_is_due", false)) run_->apply_due();
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

namespace {

process::FileDescriptor hold(pid_t process) {
  return process::FileDescriptor(static_cast<int>(syscall(SYS_pidfd_open, process, 0)));
}

void kill_and_wait(const process::FileDescriptor& process) noexcept {
  syscall(SYS_pidfd_send_signal, process.get(), SIGKILL, nullptr, 0);
  pollfd ended{process.get(), POLLIN, 0};
  while (poll(&ended, 1, CopyChannel::kForEver) < 0 && errno == EINTR) {
  }
}

// Held before it ends, so that each number means the process that it means now.
std::vector<process::FileDescriptor> children_of(pid_t process) {
  std::vector<process::FileDescriptor> children;
  std::error_code none;
  const std::filesystem::path tasks = fmt::format("/proc/{}/task", process);
  for (const auto& task : std::filesystem::directory_iterator(tasks, none)) {
    std::ifstream list(task.path() / "children");
    for (pid_t child = 0; list >> child;) {
      if (auto held = hold(child)) children.push_back(std::move(held));
    }
  }
  return children;
}

}  // namespace

void CopyHandle::end_with_children() noexcept {
  if (!process_) return;
  try {
    const auto children = children_of(id_);
    end();
    for (const process::FileDescriptor& child : children) kill_and_wait(child);
  } catch (const std::exception&) {
    end();  // no memory, or no descriptors: the children end a little later, with their parent
  }
}

void CopyHandle::end() noexcept {
  if (!process_) return;
  kill_and_wait(process_);
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
