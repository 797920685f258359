// One child at a time, watched by its pidfd.
#include "tools/serve/module_keeper.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "gaitway/process/bound_program.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::tools {
namespace {

constexpr const char* kProgram = "user_interface";
constexpr std::int64_t kShortLife_ns = 2'000'000'000;
constexpr std::int64_t kFirstPause_ns = 20'000'000, kLongestPause_ns = 640'000'000;
constexpr int kEndPatience_ms = 5'000;

std::filesystem::path find_program() {
  std::error_code unknown;
  const std::filesystem::path beside = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const std::filesystem::path& folder : {beside, process::installation_root() / "bin"}) {
    if (access((folder / kProgram).c_str(), X_OK) == 0) {
      return folder / kProgram;
    }
  }
  throw std::runtime_error(fmt::format("the program {} is neither in {} nor in {}: build or install it",
                                       kProgram, beside.string(),
                                       (process::installation_root() / "bin").string()));
}

bool readable(int descriptor, int patience_ms) {
  pollfd one{descriptor, POLLIN, 0};
  return poll(&one, 1, patience_ms) > 0;
}

}  // namespace

ModuleKeeper::ModuleKeeper(std::vector<std::string> arguments)
    : arguments_(std::move(arguments)), ending_(eventfd(0, EFD_CLOEXEC)) {
  arguments_.insert(arguments_.begin(), find_program().string());
  thread_ = std::thread([this] { keep(); });
  first_state_.wait(0);
  if (first_state_ != 1) {
    thread_.join();
    throw std::runtime_error(
        "the user interface module has not started, for the reason above; nothing moved");
  }
}

ModuleKeeper::~ModuleKeeper() {
  eventfd_write(ending_.get(), 1);
  thread_.join();
}

void ModuleKeeper::keep() {
  std::int64_t pause_ns = kFirstPause_ns;
  while (true) {
    const std::int64_t born_ns = process::monotonic_ns();
    const bool started = start();
    const bool serves = started && comes_to_serve();
    if (first_state_ == 0) {
      first_state_ = serves ? 1 : 2;
      first_state_.notify_all();
    }
    const int status = started ? wait_for_end() : 0;
    if (first_state_ == 2 || readable(ending_.get(), 0)) {
      return;
    }
    if (started) {
      report(status);
    }
    pause_ns = process::monotonic_ns() - born_ns > kShortLife_ns ? kFirstPause_ns
                                                                 : std::min(2 * pause_ns, kLongestPause_ns);
    if (readable(ending_.get(), static_cast<int>(pause_ns / 1'000'000))) {
      return;
    }
  }
}

bool ModuleKeeper::start() {
  const auto fail = [](const char* what) {
    fmt::print(stderr, "gaitway serve: the user interface module cannot be started: {}: {}\n", what,
               std::strerror(errno));
    return false;
  };
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    return fail("no pipe");
  }
  ready_ = process::FileDescriptor(ends[0]);
  const process::FileDescriptor says(ends[1]);
  std::vector<std::string> words = arguments_;
  words.insert(words.end(), {"--ready-descriptor", std::to_string(says.get())});
  const pid_t child =
      process::start({.words = std::move(words), .kept = says.get(), .output = -1, .niceness = 0});
  if (child < 0) {
    return fail("no process");
  }
  pidfd_ = process::FileDescriptor(static_cast<int>(syscall(SYS_pidfd_open, child, 0)));
  if (!pidfd_) {
    const bool failed = fail("it cannot be watched");
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    return failed;
  }
  process_ = child;
  return true;
}

bool ModuleKeeper::comes_to_serve() const {
  std::array<pollfd, 2> wakes{pollfd{ready_.get(), POLLIN, 0}, pollfd{ending_.get(), POLLIN, 0}};
  while (poll(wakes.data(), wakes.size(), -1) < 0 && errno == EINTR) {
  }
  std::array<char, 1> byte{};
  return (wakes[0].revents & POLLIN) != 0 && read(ready_.get(), byte.data(), byte.size()) == 1;
}

int ModuleKeeper::wait_for_end() {
  std::array<pollfd, 2> wakes{pollfd{pidfd_.get(), POLLIN, 0}, pollfd{ending_.get(), POLLIN, 0}};
  while (poll(wakes.data(), wakes.size(), -1) < 0 && errno == EINTR) {
  }
  if ((wakes[0].revents & POLLIN) == 0) {
    kill(process_, SIGTERM);
    if (!readable(pidfd_.get(), kEndPatience_ms)) {
      kill(process_, SIGKILL);
    }
  }
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = 0;
  return status;
}

void ModuleKeeper::report(int status) const {
  const std::string how = WIFSIGNALED(status) ? fmt::format("was ended by signal {} ({})", WTERMSIG(status),
                                                            strsignal(WTERMSIG(status)))
                                              : fmt::format("ended with code {}", WEXITSTATUS(status));
  fmt::print(stderr, "gaitway serve: the user interface module {}: started again\n", how);
}

}  // namespace gaitway::tools
