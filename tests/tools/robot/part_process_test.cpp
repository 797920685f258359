// Parts as real processes: how their ends are told, that there is never a second one, and that they outlive
// whoever started them.
#include "tools/robot/keeper/part_process.hpp"

#include <gmock/gmock.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <memory>

#include "command_run.hpp"
#include "gaitway/process/private_folder.hpp"

namespace gaitway::tools {
namespace {

using testing::HasSubstr;
using testing::Optional;

class PartProcessTest : public testing::Test {
 protected:
  [[nodiscard]] PartProcess part(const std::string& script, const std::string& name = "dummy") const {
    return {name, {"/bin/sh", "-c", script}, {.folder = folder.path(), .log = folder.path()}};
  }
  static std::optional<std::string> wait(PartProcess& process) {
    pollfd ended{process.ended_fd(), POLLIN, 0};
    EXPECT_EQ(poll(&ended, 1, 10'000), 1);
    return process.take_end();
  }
  [[nodiscard]] std::string text(const char* name) const { return test::text_of(folder.path() / name); }
  // Waits until the part has written the file.
  [[nodiscard]] std::string awaited(const char* name) const {
    std::string said;
    for (int tries = 0; tries < 10'000 && (said = text(name)).empty(); ++tries) usleep(1000);
    return said;
  }

  // A process that has ended may wait for somebody to take notice.
  static bool lives(pid_t process) {
    const std::string stat = test::text_of("/proc/" + std::to_string(process) + "/stat");
    return !stat.empty() && stat.find(") Z") == std::string::npos;
  }

  process::PrivateFolder folder{"gaitway_part"};
};

TEST_F(PartProcessTest, AnEndIsToldWithItsCodeAndItsLastWords) {
  PartProcess process = part(
      "echo 'dummy: an older line' >&2; echo 'dummy: the bus has gone' >&2; echo '{\"summary\": 1}'; exit 3");
  process.start();
  EXPECT_THAT(wait(process), Optional(std::string("ended with code 3: the bus has gone")));
  EXPECT_EQ(process.pid(), 0);
  process.start();
  EXPECT_THAT(wait(process), Optional(HasSubstr("the bus has gone")));
  PartProcess silent = part("exit 0", "silent");
  silent.start();
  EXPECT_THAT(wait(silent), Optional(std::string("ended with code 0"))) << "nobody has asked it to";
}

TEST_F(PartProcessTest, ASignalIsToldByItsName) {
  PartProcess process = part("kill -SEGV $$");
  process.start();
  EXPECT_THAT(wait(process), Optional(HasSubstr("was ended by signal 11 (Segmentation fault)")));
}

TEST_F(PartProcessTest, AProgramThatIsNotThereIsAnEndLikeAnother) {
  PartProcess process("dummy", {"/nowhere/dummy"}, {.folder = folder.path(), .log = folder.path()});
  process.start();
  EXPECT_THAT(wait(process),
              Optional(HasSubstr("ended with code 127: '/nowhere/dummy' cannot be run: No such")));
}

TEST_F(PartProcessTest, ASecondOneOfTheNameIsRefused) {
  PartProcess first = part("exec sleep 60");
  first.start();
  PartProcess second = part("exec sleep 60");
  try {
    second.start();
    FAIL() << "a second one runs";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("another one runs in this folder"));
    EXPECT_THAT(error.what(), HasSubstr("process " + std::to_string(first.pid())));
  }
  first.end_group();
  EXPECT_THAT(wait(first), Optional(HasSubstr("signal 9 (Killed)")));
  second.start();
  second.end_group();
  wait(second);
}

// As when its supervisor is killed: what it leaves behind is found, watched and ended by the next one.
TEST_F(PartProcessTest, OutlivesWhoStartedItAndIsTakenOver) {
  const pid_t supervisor = fork();
  if (supervisor == 0) {
    part("exec sleep 60").start();
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(supervisor, &status, 0), supervisor);
  ASSERT_TRUE(WIFSIGNALED(status));
  PartProcess other = part("exec sleep 61");
  try {
    EXPECT_FALSE(other.take_over());
    FAIL() << "it was started with other words";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("runs in this folder with other words"));
  }
  PartProcess next = part("exec sleep 60");
  ASSERT_TRUE(next.take_over());
  EXPECT_EQ(kill(next.pid(), 0), 0);
  EXPECT_FALSE(next.take_end());
  next.send(SIGTERM);
  EXPECT_THAT(wait(next), Optional(HasSubstr("how is not known")));
  EXPECT_FALSE(next.take_over()) << "there is none left";
}

// After an upgrade a part's next start has an option more or less: its robot and its bus are what binds.
TEST_F(PartProcessTest, IsTakenOverWhateverDiffersButRobotAndBus) {
  const auto with = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {"/bin/sh", "-c", "exec sleep 60", "sh"});
    return PartProcess("dummy", std::move(options), {.folder = folder.path(), .log = folder.path()});
  };
  PartProcess older = with({"--robot", "/a", "--can", "can0", "--gone", "--seed", "1"});
  older.start();
  ASSERT_FALSE(awaited("dummy.lock").empty());
  for (const char* const binding : {"--robot", "--can"}) {
    PartProcess other = with({"--robot", "/a", "--can", "can0", binding, "other"});
    EXPECT_THAT([&] { other.take_over(); },
                testing::ThrowsMessage<std::runtime_error>(HasSubstr(std::string("another ") + binding)));
  }
  PartProcess unbound = with({"--robot", "/a"});
  EXPECT_THROW(unbound.take_over(), std::runtime_error) << "it has a bus";
  PartProcess newer = with({"--robot", "/a", "--can", "can0", "--seed", "2", "--new", "x"});
  ASSERT_TRUE(newer.take_over());
  EXPECT_EQ(newer.differences(), "--gone, --new, --seed");
  newer.end_group();
  wait(older);
}

TEST_F(PartProcessTest, LastWordsAreWithoutTheTimeThatIsToldBesideThem) {
  PartProcess process =
      part("echo 'dummy: 2026-11-28T02:05:00.893Z: from outside, the process was ended' >&2; exit 3");
  process.start();
  EXPECT_THAT(wait(process), Optional(std::string("ended with code 3: from outside, the process was ended")));
}

// A part that has left a process behind is not started beside it.
TEST_F(PartProcessTest, WhatAPartHadStartedEndsBeforeItsNextStart) {
  PartProcess process = part("(trap '' TERM; while :; do sleep 1; done) & echo $! > " +
                             (folder.path() / "left").string() + "; wait");
  process.start();
  const pid_t left = std::stoi(awaited("left"));
  process.send(SIGKILL);
  wait(process);
  process.start();
  EXPECT_FALSE(lives(left)) << "process " << left << " lives on";
  process.end_group();
  wait(process);
}

TEST_F(PartProcessTest, ItsRoundsGrowUntilItIsStopped) {
  PartProcess process = part("while :; do sleep 0.002; done");
  process.start();
  const std::uint64_t first = process.rounds();
  for (int tries = 0; tries < 10'000 && process.rounds() == first; ++tries) usleep(1000);
  EXPECT_GT(process.rounds(), first);
  process.send(SIGSTOP);
  for (int tries = 0; tries < 10'000 && process.kernel_state() != "it was stopped (SIGSTOP)"; ++tries) {
    usleep(1000);
  }
  EXPECT_EQ(process.kernel_state(), "it was stopped (SIGSTOP)");
  const std::uint64_t stopped = process.rounds();
  usleep(20'000);
  EXPECT_EQ(process.rounds(), stopped);
  process.end_group();
  wait(process);
}

// Each start has the same rights, and none of them what was meant for another process alone.
TEST_F(PartProcessTest, RightsToRealTimeAreTheSameAfterARestart) {
  sched_param normal{};
  ASSERT_EQ(sched_setscheduler(0, SCHED_OTHER, &normal), 0);
  PartProcess process = part("cat /proc/self/limits > " + (folder.path() / "limits.next").string() + "; mv " +
                             (folder.path() / "limits.next").string() + " " +
                             (folder.path() / "limits").string() + "; exec sleep 60");
  std::vector<std::string> seen;
  for (int start = 0; start < 2; ++start) {
    process.start();
    seen.push_back(awaited("limits"));
    EXPECT_EQ(sched_getscheduler(process.pid()), SCHED_OTHER) << "neither FIFO nor reset on fork";
    std::filesystem::remove(folder.path() / "limits");
    process.end_group();
    wait(process);
  }
  EXPECT_EQ(seen[0], seen[1]);
  rlimit own{};
  ASSERT_EQ(getrlimit(RLIMIT_MEMLOCK, &own), 0);
  EXPECT_THAT(seen[0],
              HasSubstr("Max locked memory         " +
                        (own.rlim_cur == RLIM_INFINITY ? "unlimited" : std::to_string(own.rlim_cur))));
}

TEST_F(PartProcessTest, ALogKeepsItsNewestHalf) {
  const std::filesystem::path log = folder.path() / "dummy.log";
  std::ofstream out(log);
  for (int line = 0; line < 1000; ++line) out << "line " << 1000 + line << "\n";
  out.close();
  bound_log(log, 20'000);
  EXPECT_EQ(std::filesystem::file_size(log), 10'000u) << "it is not too large";
  bound_log(log, 5'000);
  const std::string kept = test::text_of(log);
  EXPECT_LE(kept.size(), 2'500u);
  EXPECT_THAT(kept, testing::StartsWith("line 17"));
  EXPECT_THAT(kept, testing::EndsWith("line 1999\n"));
}

}  // namespace
}  // namespace gaitway::tools
