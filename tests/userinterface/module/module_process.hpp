// The program `user_interface` itself, without a robot at its link, until the test ends.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <memory>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

namespace gaitway::api {

class ModuleProcess {
 public:
  // Waits until it serves. Throws std::runtime_error with what it said when it ends before.
  explicit ModuleProcess(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(),
                     {GAITWAY_USER_INTERFACE, "--robot", GAITWAY_SOURCE_DIR "/urdf/humanoid22", "--link",
                      "unix:/nowhere/link.sock", "--port", "0", "--stop-port", "0"});
    std::vector<char*> argv;
    for (std::string& argument : arguments) {
      argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    std::array<int, 2> pipe{};
    if (pipe2(pipe.data(), O_CLOEXEC) != 0) {
      throw std::runtime_error("no pipe");
    }
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, pipe[1], STDERR_FILENO);
    const int error = posix_spawn(&id_, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(pipe[1]);
    said_.reset(fdopen(pipe[0], "r"));
    if (error != 0) {
      throw std::runtime_error("no process");
    }
    await_port();
  }
  ~ModuleProcess() {
    kill(id_, SIGTERM);
    waitpid(id_, nullptr, 0);
  }
  ModuleProcess(const ModuleProcess&) = delete;
  ModuleProcess& operator=(const ModuleProcess&) = delete;

  [[nodiscard]] std::uint16_t port() const noexcept { return port_; }
  // Until it served.
  [[nodiscard]] const std::string& said() const noexcept { return all_; }
  [[nodiscard]] bool runs() const {
    siginfo_t ended{};
    return waitid(P_PID, static_cast<id_t>(id_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           ended.si_pid == 0;
  }
  // Of its memory that counts for RLIMIT_DATA.
  [[nodiscard]] std::size_t data_bytes() const {
    constexpr std::size_t kKiB = 1024;
    return number_in("status", std::regex(R"(VmData:\s+(\d+) kB)")) * kKiB;
  }
  // RLIMIT_DATA as the kernel applies it.
  [[nodiscard]] std::size_t most_data_bytes() const {
    return number_in("limits", std::regex(R"(Max data size\s+(\d+) )"));
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  void await_port() {
    const std::regex serves("serves wss?://.*:(\\d+), ");
    std::array<char, 512> line{};
    while (std::fgets(line.data(), line.size(), said_.get()) != nullptr) {
      all_ += line.data();
      std::smatch found;
      if (std::regex_search(all_, found, serves)) {
        port_ = static_cast<std::uint16_t>(std::stoul(found[1]));
        return;
      }
    }
    waitpid(id_, nullptr, 0);
    throw std::runtime_error("it ended:\n" + all_);
  }
  [[nodiscard]] std::size_t number_in(const std::string& file, const std::regex& pattern) const {
    std::ifstream stream("/proc/" + std::to_string(id_) + "/" + file);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    std::smatch found;
    return std::regex_search(text, found, pattern) ? std::stoull(found[1]) : 0;
  }

  pid_t id_ = 0;
  std::uint16_t port_ = 0;
  std::string all_;
  std::unique_ptr<std::FILE, Close> said_;  // open to the end, so that it may go on to say something
};

}  // namespace gaitway::api
