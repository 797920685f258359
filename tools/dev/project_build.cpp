// One shell-free process: cmake configures and builds in a single script call.
#include "tools/dev/project_build.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/inotify.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "gaitway/isolation/plugin_probe.hpp"
#include "gaitway/process/installation.hpp"

namespace gaitway::tools {
namespace {

// Configure, then build; the paths are arguments, so that no shell takes them apart.
constexpr const char* kScript =
    "cmake -S \"$1\" -B \"$2\" -DCMAKE_BUILD_TYPE=Release -Dgaitway_DIR=\"$3\" && cmake --build \"$2\"";

}  // namespace

ProjectBuild::ProjectBuild(std::filesystem::path project, std::filesystem::path build)
    : project_(std::move(project)), build_(std::move(build)), log_(build_ / "gaitway_dev.log") {
  std::filesystem::create_directories(build_);
}

ProjectBuild::~ProjectBuild() {
  stop();
}

void ProjectBuild::stop() noexcept {
  if (process_ > 0) {
    kill(-process_, SIGTERM);
    waitpid(process_, nullptr, 0);
    process_ = 0;
  }
}

void ProjectBuild::start() {
  stop();
  std::vector<std::string> arguments{"sh",
                                     "-c",
                                     kScript,
                                     "gaitway-dev",
                                     project_.string(),
                                     build_.string(),
                                     process::package_directory().string()};
  std::vector<char*> argv;
  for (std::string& argument : arguments) {
    argv.push_back(argument.data());
  }
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, log_.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);  // ours blocks what ends the build
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);  // ended as one group
  const int error = posix_spawn(&process_, "/bin/sh", &actions, &attributes, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) {
    process_ = 0;
    throw std::runtime_error(std::string("cannot start cmake: ") + std::strerror(error));
  }
  ended_ = process::FileDescriptor(static_cast<int>(syscall(SYS_pidfd_open, process_, 0)));
}

std::optional<bool> ProjectBuild::take_result(bool wait) {
  int status = 0;
  if (process_ <= 0 || waitpid(process_, &status, wait ? 0 : WNOHANG) != process_) {
    return std::nullopt;
  }
  process_ = 0;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string ProjectBuild::output() const {
  std::ifstream in(log_);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::filesystem::path ProjectBuild::library() const {
  std::filesystem::path newest;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(build_)) {
    const bool is_newer =
        entry.is_regular_file() && entry.path().extension() == ".so" &&
        core::is_plugin_library(entry.path()) &&
        (newest.empty() || entry.last_write_time() > std::filesystem::last_write_time(newest));
    if (is_newer) {
      newest = entry.path();
    }
  }
  return newest;
}

namespace {

bool is_source(std::string_view name) {
  constexpr std::array<std::string_view, 7> kEndings{".cpp",   ".cc",           ".c", ".hpp", ".h",
                                                     ".cmake", "CMakeLists.txt"};
  return !name.starts_with('.') &&
         std::ranges::any_of(kEndings, [name](std::string_view ending) { return name.ends_with(ending); });
}

}  // namespace

SourceWatch::SourceWatch(const std::filesystem::path& project, const std::filesystem::path& build)
    : inotify_(inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
  watch(project);
  for (auto entry = std::filesystem::recursive_directory_iterator(project);
       entry != std::filesystem::recursive_directory_iterator(); ++entry) {
    if (!entry->is_directory()) {
      continue;
    }
    const bool skipped =
        entry->path().filename().string().starts_with('.') ||
        (std::filesystem::exists(build) && std::filesystem::equivalent(entry->path(), build));
    if (skipped) {
      entry.disable_recursion_pending();
    } else {
      watch(entry->path());
    }
  }
}

void SourceWatch::watch(const std::filesystem::path& folder) const {
  if (!inotify_ || inotify_add_watch(inotify_.get(), folder.c_str(), IN_CLOSE_WRITE | IN_MOVED_TO) < 0) {
    throw std::runtime_error(folder.string() + ": cannot be watched: " + std::strerror(errno));
  }
}

bool SourceWatch::take_change() const {
  alignas(inotify_event) std::array<char, 4096> buffer{};
  bool changed = false;
  while (true) {
    const ssize_t bytes = read(inotify_.get(), buffer.data(), buffer.size());
    if (bytes <= 0) {
      return changed;
    }
    for (ssize_t at = 0; at < bytes;) {
      inotify_event event{};
      std::memcpy(&event, buffer.data() + at, sizeof event);
      const char* const name = buffer.data() + at + static_cast<ssize_t>(sizeof event);
      changed = changed || (event.len > 0 && is_source({name, strnlen(name, event.len)}));
      at += static_cast<ssize_t>(sizeof event) + event.len;
    }
  }
}

}  // namespace gaitway::tools
