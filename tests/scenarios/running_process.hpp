// Programs of a robot as tests meet them: started with their output in a file, sent signals, waited for.
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

namespace gaitway::scenarios {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

inline std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

inline bool until(Clock::duration at_most, const std::function<bool()>& done) {
  const auto end = Clock::now() + at_most;
  while (!done()) {
    if (Clock::now() > end) {
      return false;
    }
    std::this_thread::sleep_for(5ms);
  }
  return true;
}

// A program with its output in a file; killed with this object at the latest.
class Process {
 public:
  Process(std::string program, std::filesystem::path output, std::vector<std::string> arguments)
      : output_(std::move(output)) {
    arguments.insert(arguments.begin(), std::move(program));
    std::vector<char*> argv;
    for (std::string& argument : arguments) {
      argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 1, output_.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    EXPECT_EQ(posix_spawn(&process_, argv[0], &actions, nullptr, argv.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() {
    if (process_ > 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
  }

  void send(int signal) const { kill(process_, signal); }
  [[nodiscard]] pid_t id() const noexcept { return process_; }
  // Its exit code; 1000 and more: a signal ended it; -1: it did not end.
  int wait() {
    int status = 0;
    if (!until(10s, [&] { return waitpid(process_, &status, WNOHANG) == process_; })) {
      return -1;
    }
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
  int stop() {
    send(SIGTERM);
    return wait();
  }
  [[nodiscard]] std::string output() const { return text_of(output_); }

 private:
  std::filesystem::path output_;
  pid_t process_ = 0;
};

}  // namespace gaitway::scenarios
