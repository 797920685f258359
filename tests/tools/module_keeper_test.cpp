// The module beside `gaitway serve`: one that does not come to serve does not keep it from its end.
#include "tools/serve/module_keeper.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>
#include <string>
#include <string_view>
#include <thread>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/private_folder.hpp"

namespace gaitway::tools {
namespace {

using namespace std::chrono_literals;

// This process's child, when it is one; 0: none.
pid_t child() {
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream children(thread.path() / "children");
    if (pid_t pid = 0; children >> pid) {
      return pid;
    }
  }
  return 0;
}

TEST(ModuleKeeper, EndsAModuleThatHangsBeforeItServes) {
  const process::PrivateFolder folder("gaitway_keeper");
  const std::filesystem::path robot = folder.path() / "robot", description = robot / "robot.urdf";
  std::filesystem::copy(GAITWAY_URDF_DIR "/humanoid22", robot, std::filesystem::copy_options::recursive);
  auto keeper = std::make_unique<ModuleKeeper>(std::vector<std::string>{
      "--robot", robot.string(), "--link", "unix:" + (folder.path() / "link").string(), "--port", "0",
      "--stop-port", "0"});
  const pid_t first = child();
  ASSERT_GT(first, 0);
  std::filesystem::remove(description);
  ASSERT_EQ(mkfifo(description.c_str(), 0600), 0);  // who opens it waits for who writes to it
  kill(first, SIGKILL);
  while (child() == first || child() == 0) std::this_thread::yield();
  const pid_t second = child();
  auto ends = std::async(std::launch::async, [&keeper] { keeper.reset(); });
  EXPECT_EQ(ends.wait_for(20s), std::future_status::ready);
  kill(second, SIGKILL);
}

// What stands on this process's standard error, while this exists.
class HeardErrors {
 public:
  HeardErrors() : own_(dup(STDERR_FILENO)) {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    heard_ = process::FileDescriptor(ends[0]);
    dup2(ends[1], STDERR_FILENO);
    close(ends[1]);
  }
  ~HeardErrors() { dup2(own_.get(), STDERR_FILENO); }
  HeardErrors(const HeardErrors&) = delete;
  HeardErrors& operator=(const HeardErrors&) = delete;

  // Waits for it; false: it does not come.
  [[nodiscard]] bool hear(std::string_view what) {
    pollfd one{heard_.get(), POLLIN, 0};
    std::array<char, 1024> text{};
    while (said_.find(what) == std::string::npos && poll(&one, 1, 10'000) > 0) {
      const ssize_t size = read(heard_.get(), text.data(), text.size());
      said_.append(text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    }
    return said_.find(what) != std::string::npos;
  }

 private:
  process::FileDescriptor own_, heard_;
  std::string said_;
};

TEST(ModuleKeeper, StartsItAgainAsSoonAsTheComputerCan) {
  const process::PrivateFolder folder("gaitway_keeper");
  const ModuleKeeper keeper({"--robot", GAITWAY_URDF_DIR "/humanoid22", "--link",
                             "unix:" + (folder.path() / "link").string(), "--port", "0", "--stop-port", "0"});
  const pid_t first = child();
  ASSERT_GT(first, 0);
  rlimit limit{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &limit), 0);
  {
    HeardErrors errors;
    const rlimit none{3, limit.rlim_max};  // what is open stays open
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
    kill(first, SIGKILL);
    EXPECT_TRUE(errors.hear("cannot be started: no pipe: Too many open files"));
    ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &limit), 0);
  }
  const auto until = std::chrono::steady_clock::now() + 20s;
  while (child() == 0 && std::chrono::steady_clock::now() < until) std::this_thread::yield();
  EXPECT_GT(child(), 0);
}

}  // namespace
}  // namespace gaitway::tools
