// The module beside `gaitway serve`: one that does not come to serve does not keep it from its end.
#include "tools/serve/module_keeper.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>
#include <string>
#include <thread>

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

}  // namespace
}  // namespace gaitway::tools
