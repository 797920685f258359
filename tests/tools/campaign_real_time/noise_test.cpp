// What the campaign in real time disturbs robots with does what it says, and ends.
#include "tools/campaign/real_time/noise.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <stdexcept>

#include "command_run.hpp"
#include "gaitway/process/private_folder.hpp"
#include "tools/campaign/real_time/disturbance.h"

namespace gaitway::tools {
namespace {

// Runs a command with the library that the campaign preloads.
test::CommandRun run_disturbed(const process::PrivateFolder& folder, const gaitway_disturbance& words,
                               const std::string& command) {
  std::ofstream(folder.path() / "words", std::ios::binary)
      .write(reinterpret_cast<const char*>(&words), sizeof words);
  return test::run_command("LD_PRELOAD=" GAITWAY_DISTURBANCE " " GAITWAY_DISTURBANCE_VARIABLE "=" +
                           (folder.path() / "words").string() + " " + command);
}

TEST(Disturbance, ShiftsTheClockOfTheDayAndNoOther) {
  const process::PrivateFolder folder("gaitway_noise");
  const auto off_s = [&folder](std::int64_t shift_ns) {
    return std::atoll(run_disturbed(folder, {shift_ns, 0}, "date +%s").said.c_str()) - std::time(nullptr);
  };
  EXPECT_NEAR(static_cast<double>(off_s(0)), 0.0, 5.0);
  EXPECT_NEAR(static_cast<double>(off_s(3'600'000'000'000)), 3600.0, 5.0);
  EXPECT_NEAR(static_cast<double>(off_s(-3'600'000'000'000)), -3600.0, 5.0);
  const test::CommandRun monotonic =
      run_disturbed(folder, {3'600'000'000'000, 0}, "python3 -c 'import time; print(int(time.monotonic()))'");
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  EXPECT_NEAR(std::atof(monotonic.said.c_str()), static_cast<double>(now.tv_sec), 5.0);
}

TEST(Disturbance, WritingToAFileTakesLongerAndToAPipeDoesNot) {
  const process::PrivateFolder folder("gaitway_noise");
  const auto lasts_s = [&folder](const std::string& what) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(run_disturbed(folder, {0, 300'000'000}, what).code, 0) << what;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  const std::string file = (folder.path() / "file").string();
  EXPECT_GE(lasts_s("dd if=/dev/zero of=" + file + " bs=1 count=2 status=none"), 0.6);
  EXPECT_EQ(std::filesystem::file_size(file), 2U);
  EXPECT_LT(lasts_s("dd if=/dev/zero bs=1 count=2 status=none 2>/dev/null | cat"), 0.3);
}

TEST(FullDisk, LeavesADiskThatIsNotItsOwnAlone) {
  const process::PrivateFolder folder("gaitway_noise");
  EXPECT_THROW(FullDisk{folder.path()}, std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(BusyComputer, LeavesNoProcessBehind) {
  const process::PrivateFolder folder("gaitway_noise");
  const auto children = [] { return test::text_of("/proc/thread-self/children"); };
  const std::string before = children();
  {
    const BusyComputer busy(folder.path());
    EXPECT_NE(children(), before);
  }
  EXPECT_EQ(children(), before);
}

}  // namespace
}  // namespace gaitway::tools
