// posix_spawn and pidfd: neither copies the manager's pages nor touches its signals.
#include "child_process.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string>
#include <vector>

#include "child_program.hpp"
#include "gaitway/instance/event_log.hpp"
#include "gaitway/process/installation.hpp"

namespace gaitway::core {
namespace {

constexpr const char* kBinary = "gaitway_plugin_child";
constexpr const char* kPythonBinary = "gaitway_python_child";
constexpr auto kPidfdType = static_cast<idtype_t>(3);  // P_PIDFD, which older headers lack

class SpawnSettings {
 public:
  explicit SpawnSettings(int socket) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", 0, 0);
    posix_spawn_file_actions_adddup2(&actions_, socket, kChildSocket);
    posix_spawnattr_init(&attributes_);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF |
                                                              POSIX_SPAWN_SETPGROUP));
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  [[nodiscard]] const posix_spawn_file_actions_t* actions() const noexcept { return &actions_; }
  [[nodiscard]] const posix_spawnattr_t* attributes() const noexcept { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

std::filesystem::path find_plugin_child(std::string_view library) {
  const bool python = is_python(library);
  const char* const given = python ? nullptr : std::getenv("GAITWAY_PLUGIN_CHILD");
  if (given != nullptr && given[0] != '\0') {
    if (access(given, X_OK) != 0) {
      throw PluginError(
          fmt::format("GAITWAY_PLUGIN_CHILD names '{}', which cannot be run: {}", given, strerror(errno)));
    }
    return given;
  }
  std::error_code unknown;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
  const std::filesystem::path root = process::installation_root();
  std::vector<std::string> tried;
  const char* const binary = python ? kPythonBinary : kBinary;
  for (const std::filesystem::path& place : {folder / binary, root / "bin" / binary}) {
    if (access(place.c_str(), X_OK) == 0) {
      return place;
    }
    tried.push_back(place.string());
  }
  if (python) {
    throw PluginError(
        fmt::format("a plug-in in Python needs the program {}; tried {}. Run it with Gaitway's "
                    "Python package (pip install gaitway-*.whl)",
                    binary, fmt::join(tried, ", ")));
  }
  throw PluginError(
      fmt::format("isolation: process needs the program {}; tried {}. Install it, or name it in "
                  "GAITWAY_PLUGIN_CHILD",
                  kBinary, fmt::join(tried, ", ")));
}

ChildProcess::ChildProcess(const std::filesystem::path& binary, const process::FileDescriptor& socket,
                           const ChildBounds& bounds) {
  const SpawnSettings settings(socket.get());
  std::array<std::string, 5> words{
      binary.string(), std::to_string(getpid()), std::to_string(bounds.memory_limit_bytes),
      std::to_string(bounds.descriptor_limit), bounds.local_sockets ? kLocalSockets : "-"};
  std::array<char*, 6> arguments{};
  std::ranges::transform(words, arguments.begin(), [](std::string& word) { return word.data(); });
  const int error = posix_spawn(&pid_, binary.c_str(), settings.actions(), settings.attributes(),
                                arguments.data(), environ);
  if (error != 0) {
    pid_ = -1;
    throw PluginError(fmt::format("its process {} cannot be started: {}", binary.string(), strerror(error)));
  }
  pidfd_ = process::FileDescriptor(static_cast<int>(syscall(SYS_pidfd_open, pid_, 0)));
  if (!pidfd_) {
    const int reason = errno;
    ::kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    throw PluginError(fmt::format(
        "its process cannot be watched (pidfd_open: {}); Linux 5.4 or newer is needed", strerror(reason)));
  }
}

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(pidfd_, other.pidfd_);
  std::swap(reaped_, other.reaped_);
  std::swap(end_, other.end_);
  return *this;
}

ChildProcess::~ChildProcess() {
  if (pidfd_) {
    kill();
    static_cast<void>(has_ended(-1));
    static_cast<void>(end());
  }
}

bool ChildProcess::has_ended(int timeout_ms) const noexcept {
  pollfd watched{pidfd_.get(), POLLIN, 0};
  int result = 0;
  do {
    result = poll(&watched, 1, timeout_ms);
  } while (result < 0 && errno == EINTR && timeout_ms < 0);
  return result > 0;
}

void ChildProcess::kill() noexcept {
  if (!reaped_) {
    syscall(SYS_pidfd_send_signal, pidfd_.get(), SIGKILL, nullptr, 0);
  }
}

std::string_view ChildProcess::end() noexcept {
  siginfo_t info{};
  if (!reaped_ && waitid(kPidfdType, static_cast<id_t>(pidfd_.get()), &info, WEXITED | WNOHANG) == 0 &&
      info.si_pid != 0) {
    const bool exited = info.si_code == CLD_EXITED;
    const char* const name = exited ? nullptr : sigabbrev_np(info.si_status);
    if (exited) {
      format_into(end_, "exited with code {}", info.si_status);
    } else {
      format_into(end_, "was ended by SIG{}", name == nullptr ? "?" : name);
    }
  } else if (end_[0] == '\0') {
    format_into(end_, "has ended");
  }
  reaped_ = true;
  return end_.data();
}

}  // namespace gaitway::core
