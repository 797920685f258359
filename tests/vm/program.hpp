// For tests: a program that runs beside the test, with its output in a file; killed with this object at the
// latest.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace gaitway::test {

inline std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

inline bool until(std::chrono::seconds at_most, const std::function<bool()>& done) {
  const auto end = std::chrono::steady_clock::now() + at_most;
  while (!done()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return true;
}

class Program {
 public:
  // `environment`: what it has beside this process's own.
  Program(std::filesystem::path folder, const std::string& name, std::vector<std::string> arguments,
          std::vector<std::string> environment = {})
      : output_(folder / (name + ".txt")) {
    std::vector<char*> argv, envp;
    for (std::string& argument : arguments) {
      argv.push_back(argument.data());
    }
    for (std::string& variable : environment) {
      envp.push_back(variable.data());
    }
    for (char** variable = environ; *variable != nullptr; ++variable) {
      envp.push_back(*variable);
    }
    argv.push_back(nullptr);
    envp.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn_file_actions_addopen(&actions, 1, output_.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    EXPECT_EQ(posix_spawnp(&process_, argv[0], &actions, nullptr, argv.data(), envp.data()), 0) << argv[0];
    posix_spawn_file_actions_destroy(&actions);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() {
    if (process_ > 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
  }

  [[nodiscard]] bool running() {
    if (process_ > 0 && waitpid(process_, &status_, WNOHANG) == process_) {
      process_ = 0;
    }
    return process_ > 0;
  }
  // Its exit code; 1000 and more: a signal ended it; -1: it did not end.
  int wait(std::chrono::seconds at_most) {
    if (!until(at_most, [this] { return !running(); })) {
      return -1;
    }
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 1000 + WTERMSIG(status_);
  }
  int stop() {
    if (running()) {
      kill(process_, SIGTERM);
    }
    return wait(std::chrono::seconds(30));
  }
  [[nodiscard]] std::string output() const { return text_of(output_); }

 private:
  std::filesystem::path output_;
  pid_t process_ = 0;
  int status_ = 0;
};

}  // namespace gaitway::test
