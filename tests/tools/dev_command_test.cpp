// `gaitway dev` as an author meets it: what is saved goes live in the walking robot, what is broken does not.
#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

namespace gaitway::tools {
namespace {

using testing::HasSubstr;

class DevCommand : public testing::Test {
 protected:
  DevCommand() {
    std::string name = (std::filesystem::temp_directory_path() / "gaitway_dev_XXXXXX").string();
    folder_ = mkdtemp(name.data());
    const std::string line = std::string(GAITWAY_COMMAND) + " new-plugin sway --kind stability --dir " +
                             (folder_ / "sway").string() + " >/dev/null";
    EXPECT_EQ(std::system(line.c_str()), 0);
    process_ = fork();
    if (process_ == 0) {
      std::freopen((folder_ / "log").c_str(), "w", stdout);
      dup2(STDOUT_FILENO, STDERR_FILENO);
      execl(GAITWAY_COMMAND, GAITWAY_COMMAND, "dev", (folder_ / "sway").c_str(), nullptr);
      _exit(127);
    }
  }
  ~DevCommand() override {
    if (process_ > 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
    std::filesystem::remove_all(folder_);
  }

  static std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  // What it says from now on contains this, within two minutes.
  bool says(const std::string& part) {
    for (int i = 0; i < 12'000; ++i) {
      const std::size_t at = text_of(folder_ / "log").find(part, heard_);
      if (at != std::string::npos) {
        heard_ = at + part.size();
        return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  void save(const std::string& before, const std::string& after) {
    const std::filesystem::path file = folder_ / "sway" / "sway.cpp";
    std::string text = text_of(file);
    const std::size_t at = text.find(before);
    ASSERT_NE(at, std::string::npos) << before;
    std::ofstream(file) << text.replace(at, before.size(), after);
  }
  void end() {
    kill(process_, SIGINT);
    int status = -1;
    ASSERT_EQ(waitpid(process_, &status, 0), process_);
    process_ = 0;
    EXPECT_EQ(status, 0) << log();
  }
  [[nodiscard]] std::string log() const { return text_of(folder_ / "log"); }

  std::filesystem::path folder_;
  pid_t process_ = 0;
  std::size_t heard_ = 0;
};

TEST_F(DevCommand, WhatIsSavedGoesLiveAndWhatIsBrokenDoesNot) {
  ASSERT_TRUE(says("sway.so) replaces stability")) << log();
  ASSERT_TRUE(says("GOOD: upright")) << log();
  save("\"0.1.0\"", "\"0.2.0\"");
  ASSERT_TRUE(says("after it was saved: in place of 0.1.0 now 0.2.0")) << log();
  save("class", "clas");
  ASSERT_TRUE(says("NOT CHANGED: it does not build")) << log();
  save("clas ", "class ");
  ASSERT_TRUE(says("in place of 0.2.0 now 0.2.0")) << log();
  save("trim_.publish();", "throw std::runtime_error(\"no trim\");");
  ASSERT_TRUE(says("NOT CHANGED: the new version was taken back")) << log();
  EXPECT_TRUE(says("no trim")) << log();
  // A first step is in a batch's tick, whose number leaves 6: this one crashes later.
  save("throw std::runtime_error(\"no trim\");",
       "if (tick.tick % 256 == 255) __builtin_trap(); trim_.publish();");
  ASSERT_TRUE(says("in place of 0.2.0 now 0.2.0")) << log();
  ASSERT_TRUE(says("was ended by SIGILL in its step")) << log();
  ASSERT_TRUE(says("runs in a new process")) << log();
  end();
  EXPECT_THAT(log(), Not(HasSubstr("FELL")));
}

TEST_F(DevCommand, ARobotThatFellBeginsAnewWithTheLastGoodVersion) {
  ASSERT_TRUE(says("GOOD: upright")) << log();
  save("= against(estimate, 1)",
       "= tick.tick > 300 ? (tick.tick / 40 % 2 == 0 ? 0.34 : -0.34) : against(estimate, 1)");
  ASSERT_TRUE(says("in place of 0.1.0 now 0.1.0")) << log();
  ASSERT_TRUE(says("FELL")) << log();
  save("(\"correction\")) {}", "(\"correction\")) { throw std::runtime_error(\"no calibration\"); }");
  ASSERT_TRUE(says("NOT CHANGED: it cannot be loaded")) << log();
  for (int fall = 0; fall < 2; ++fall) {
    ASSERT_TRUE(says("FELL")) << log();
  }
  std::filesystem::remove_all(folder_ / "sway" / "build");
  for (int fall = 0; fall < 2; ++fall) {
    ASSERT_TRUE(says("FELL")) << log();
  }
  end();
}

}  // namespace
}  // namespace gaitway::tools
