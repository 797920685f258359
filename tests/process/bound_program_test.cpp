// Programs that end with who started them.
#include "gaitway/process/bound_program.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <string>
#include <thread>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::process {
namespace {

struct Pipe {
  Pipe() {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    reads = FileDescriptor(ends[0]);
    writes = FileDescriptor(ends[1]);
  }
  // All that is written until every writer has gone.
  std::string all() {
    writes = FileDescriptor();
    std::string text;
    std::array<char, 256> bytes{};
    for (ssize_t count = 0; (count = read(reads.get(), bytes.data(), bytes.size())) > 0;) {
      text.append(bytes.data(), static_cast<std::size_t>(count));
    }
    return text;
  }
  FileDescriptor reads, writes;
};

int status_of(pid_t child) {
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  return status;
}

TEST(BoundProgram, BothOutputsGoWhereTheyAreWanted) {
  Pipe pipe;
  const pid_t child = start({.words = {"/bin/sh", "-c", "echo said; echo complained >&2; nice"},
                             .kept = -1,
                             .output = pipe.writes.get(),
                             .niceness = 7});
  ASSERT_GT(child, 0);
  EXPECT_EQ(pipe.all(), "said\ncomplained\n7\n");
  EXPECT_EQ(WEXITSTATUS(status_of(child)), 0);
}

TEST(BoundProgram, HasTheDescriptorThatIsKeptAndNoSignalBlocked) {
  Pipe pipe;
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const std::string says = "grep SigBlk /proc/self/status >&" + std::to_string(pipe.writes.get());
  const pid_t child =
      start({.words = {"/bin/sh", "-c", says}, .kept = pipe.writes.get(), .output = -1, .niceness = 0});
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ASSERT_GT(child, 0);
  EXPECT_EQ(pipe.all(), "SigBlk:\t0000000000000000\n");
  EXPECT_EQ(WEXITSTATUS(status_of(child)), 0);
}

TEST(BoundProgram, EndsWithTheThreadThatStartedIt) {
  Pipe pipe;
  pid_t child = -1;
  std::thread([&] {
    child = start({.words = {"/bin/sh", "-c", "echo up; exec sleep 1000"},
                   .kept = -1,
                   .output = pipe.writes.get(),
                   .niceness = 0});
    char byte = 0;
    EXPECT_EQ(read(pipe.reads.get(), &byte, 1), 1);  // it has begun
  }).join();
  ASSERT_GT(child, 0);
  const int status = status_of(child);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGKILL);
}

TEST(BoundProgram, WhatCannotBeRunSaysSoByItsCode) {
  const pid_t child = start({.words = {"/nowhere/program"}, .kept = -1, .output = -1, .niceness = 0});
  ASSERT_GT(child, 0);
  EXPECT_EQ(WEXITSTATUS(status_of(child)), 127);
}

}  // namespace
}  // namespace gaitway::process
