// The supervisor's own faults: what it started ends with it. And what it sees of its worker: what one side
// notes, the other side of the shared memory sees.
#include "gaitway/core/supervisor.hpp"

#include <gtest/gtest.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "gaitway/manager/step_watch.hpp"

namespace gaitway::core {
namespace {

// From now on, for this process and its children.
bool forbid_pidfd_open() {
  std::array filter{
      sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_pidfd_open, 0, 1),
      sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EMFILE),
      sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

TEST(StepWatch, TheOtherSideSeesWhoIsBeingStepped) {
  StepWatch watcher = StepWatch::make();
  StepWatch worker = StepWatch::open(dup(watcher.descriptor()));
  const std::uint32_t first = worker.add("first"), second = worker.add("second");
  EXPECT_EQ(watcher.current(), "");
  worker.enter(second);
  EXPECT_EQ(watcher.current(), "second");
  worker.enter(first);
  EXPECT_EQ(watcher.current(), "first");
  worker.leave();
  EXPECT_EQ(watcher.current(), "");
  worker.count_tick();
  EXPECT_EQ(watcher.ticks(), 1U);
}

TEST(StepWatch, MoreThanItHasRoomForAreNotNamed) {
  StepWatch watch = StepWatch::make();
  for (std::uint32_t i = 0; i < StepWatch::kCapacity; ++i) {
    EXPECT_NE(watch.add("plug-in " + std::to_string(i)), 0U);
  }
  EXPECT_EQ(watch.add("late"), 0U);
  EXPECT_EQ(watch.add("plug-in 7"), 8U) << "a plug-in that is replaced keeps its number";
}

// The page is the worker's, too, and a plug-in may write over it.
TEST(StepWatch, ANameWithoutAnEndIsCutOff) {
  StepWatch watch = StepWatch::make();
  watch.enter(watch.add("first"));
  constexpr std::size_t kPage = 4096;
  auto* const page =
      static_cast<char*>(mmap(nullptr, kPage, PROT_READ | PROT_WRITE, MAP_SHARED, watch.descriptor(), 0));
  ASSERT_NE(static_cast<void*>(page), MAP_FAILED);
  const std::size_t at = std::string_view(page, kPage).find("first");
  std::memset(page + at, 'x', kPage - at);
  EXPECT_EQ(watch.current(), std::string(48, 'x'));
  munmap(page, kPage);
}

// The robot stands on its safe tail meanwhile: nothing is won by giving up at once.
TEST(Supervisor, AStartThatFailsAfterADeathIsTriedAgain) {
  const std::string program = testing::TempDir() + "gaitway_worker_" + std::to_string(getpid());
  std::ofstream(program) << "#!/bin/sh\nrm \"$0\"\nkill -ABRT $$\n";
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  EXPECT_EQ(supervise({.program = program, .arguments = {}, .quiet = true}), kExitGivenUp);
}

TEST(Supervisor, WorkerThatCannotBeWatchedIsEnded) {
  const pid_t supervisor = fork();
  if (supervisor == 0) {
    if (!forbid_pidfd_open()) {
      _exit(1);
    }
    try {
      supervise({.program = "/bin/sh", .arguments = {"-c", "exec sleep 1000"}, .quiet = true});
      _exit(2);
    } catch (const std::system_error&) {
      _exit(waitpid(-1, nullptr, WNOHANG) == -1 && errno == ECHILD ? 0 : 3);  // 3: a child is left behind
    }
  }
  int status = 0;
  ASSERT_EQ(waitpid(supervisor, &status, 0), supervisor);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace gaitway::core
