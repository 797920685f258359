// A plug-in that may use Unix sockets, and no others: what else it tries, in its constructor, its step or its
// thread, is refused; and whatever becomes of its process, the others do not notice.
#include <gmock/gmock.h>
#include <poll.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "gaitway/msgclient/memory_block_server.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/listening_socket.hpp"
#include "isolation/local_sockets_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST_F(LocalSockets, UnixSocketsMayBeUsedInTheConstructorAndEverAfter) {
  manager = load(server());
  EXPECT_EQ(newest("own door"), "reached its own door");
  const std::uint64_t before = manager->events().total();
  ASSERT_EQ(ask("step greet"), 0);
  EXPECT_EQ(step(), 0) << fault();
  EXPECT_GT(manager->events().total(), before) << "it connected from its step";
  for (const char* const name : {"unix", "unix datagram", "unix pair", "thread"}) {
    EXPECT_EQ(ask(std::string("here ") + name), 0) << name;
    ASSERT_EQ(ask(std::string("step ") + name), 0);
    EXPECT_EQ(step(), 0) << fault();
    EXPECT_EQ(newest("error"), std::string(name) + ": error 0");
  }
}

TEST_F(LocalSockets, WithoutTheKeyThereIsNoSocketAtAll) {
  for (const char* const keys : {", isolation: process", ", isolation: process, sockets: none"}) {
    EXPECT_THAT(refusal(entry(keys)), AllOf(HasSubstr("plug-in 'server' (test.yaml:2)"),
                                            HasSubstr("socket: Operation not permitted")))
        << keys;
  }
}

TEST_F(LocalSockets, EveryOtherSocketIsRefusedAndAFaultOfTheStep) {
  manager = load(server());
  for (const char* const name : {"tcp", "tcp 6", "udp", "raw", "netlink", "packet", "can", "hypervisor",
                                 "tcp with an upper word", "unix with an upper word"}) {
    ASSERT_EQ(ask(std::string("step ") + name), 0);
    EXPECT_EQ(step(), 1) << name;
    EXPECT_THAT(fault(), HasSubstr("called socket, which a plug-in in a process of its own may not")) << name;
    EXPECT_EQ(newest("error"), std::string(name) + ": error " + std::to_string(EPERM));
    EXPECT_EQ(step(), 0) << "its process lives on";
  }
  ASSERT_EQ(ask("step tcp pair"), 0);
  EXPECT_EQ(step(), 1);
  EXPECT_THAT(fault(), HasSubstr("called socketpair, which"));
}

TEST_F(LocalSockets, WhatItsConstructorTriesIsRefused) {
  for (const char* const name : {"tcp", "udp", "netlink", "packet", "fork", "execve"}) {
    manager.reset();
    manager = load(server("", std::string(", attempt: ") + name));
    EXPECT_EQ(newest("error"), std::string(name) + ": error " + std::to_string(EPERM));
    EXPECT_EQ(step(), 0) << "it is no fault of its step";
  }
}

TEST_F(LocalSockets, WhatItsThreadTriesIsRefusedAndAFaultOfTheNextStep) {
  manager = load(server());
  EXPECT_EQ(ask("here tcp"), EPERM);
  EXPECT_EQ(ask("here kill"), EPERM);
  EXPECT_EQ(step(), 1);
  EXPECT_THAT(fault(), HasSubstr("called socket, which"));
  EXPECT_EQ(step(), 0);
}

TEST_F(LocalSockets, ProcessesSignalsLimitsAndPrioritiesAreRefusedAsToOtherChildren) {
  manager = load(server());
  for (const auto& [name, call] : {std::pair{"fork", "clone"},
                                   {"execve", "execve"},
                                   {"ptrace", "ptrace"},
                                   {"kill", "kill"},
                                   {"own", "fcntl"},
                                   {"limit", "prlimit64"},
                                   {"real time", "sched_setscheduler"}}) {
    ASSERT_EQ(ask(std::string("step ") + name), 0);
    EXPECT_EQ(step(), 1) << name;
    EXPECT_THAT(fault(), HasSubstr(std::string("called ") + call + ", which"));
    EXPECT_EQ(newest("error"), std::string(name) + ": error " + std::to_string(EPERM));
    EXPECT_EQ(step(), 0) << "its process lives on";
  }
}

TEST_F(LocalSockets, HasTheLimitsOfItsEntryAndAPriorityBelowTheManagers) {
  const sched_param second{.sched_priority = 2}, none{};
  const bool real_time = sched_setscheduler(0, SCHED_FIFO, &second) == 0;  // where the rights are there
  manager = load(server(", descriptors: 200, memory: 700 MiB"));
  if (real_time) {
    sched_setscheduler(0, SCHED_OTHER, &none);
  }
  EXPECT_EQ(ask("policy"), real_time ? SCHED_FIFO : SCHED_OTHER);
  EXPECT_EQ(ask("priority"), real_time ? 1 : 0);
  EXPECT_EQ(ask("descriptors"), 200);
  EXPECT_EQ(ask("memory"), 700);
}

TEST_F(LocalSockets, IsAClientOfTheMemoryBlockThatClaimsNothingMore) {
  memory_socket = folder / "block.sock";
  msgclient::MemoryBlockServer memory(block, memory_socket);
  std::atomic<bool> serving{true};
  std::jthread server_thread([&] {
    while (serving) {
      pollfd wake{memory.wake_fd(), POLLIN, 0};
      poll(&wake, 1, 10);
      memory.step(0);
    }
  });
  manager = load(server("", ", client: true"));
  EXPECT_EQ(newest("listens"), "listens, memory at '" + memory_socket.string() + "'");
  EXPECT_EQ(ask("walk"), 0);
  WalkCommand command{};
  EXPECT_TRUE(other.read<WalkCommand>("walk_command").read(command));
  EXPECT_EQ(command.velocity[0], 0.1);
  EXPECT_EQ(ask("here reopen"), EACCES) << "what it may read it cannot write";
  EXPECT_EQ(ask("claim"), 1);
  EXPECT_FALSE(other.find("trim").has_value());
  manager.reset();
  serving = false;
}

TEST_F(LocalSockets, InProcessItKnowsTheMemorySocket) {
  memory_socket = "/run/robot/block.sock";
  manager = load(entry(""));
  EXPECT_EQ(newest("listens"), "listens, memory at '/run/robot/block.sock'");
}

TEST_F(LocalSockets, IsAlwaysReplacedButTheOftenerTheLater) {
  manager = load(relays() + server());
  for (const int delay_ms : {40, 80, 160, 320, 640, 800, 800}) {
    EXPECT_THAT(end_and_wait(), testing::EndsWith(" after " + std::to_string(delay_ms) + " ms"));
  }
  for (int i = 0; i < 1001; ++i) {
    ASSERT_EQ(step(), 0);
  }
  EXPECT_THAT(end_and_wait(), testing::EndsWith(" after 40 ms"));
  EXPECT_EQ(service(), ServiceState::works);
}

TEST_F(LocalSockets, InRealTimeLateStepsLeaveNoTraceOnTheOthersAndNeverPutItOutOfService) {
  isolation.lock_step = false;
  manager = load(relays() + server(", budget: 80 ms"));
  ASSERT_EQ(step(), 0);
  ASSERT_EQ(ask("step wait"), 0);
  EXPECT_EQ(step(), 1);
  EXPECT_THAT(fault(), HasSubstr("did not answer within 80 ms"));
  for (int i = 0; i < 40; ++i) {
    EXPECT_EQ(step(), 1);
    EXPECT_EQ(relayed(), 100.0 + number);
    EXPECT_EQ(manager->fault_behind("b"), nullptr);
  }
  EXPECT_EQ(service(), ServiceState::failing);
  EXPECT_EQ(ask("waits"), 1) << "it still serves";
  for (int i = 0; i < 20; ++i) {  // 0.6 s: its process is ended, and replaced
    step();
    EXPECT_EQ(relayed(), 100.0 + number);
  }
  EXPECT_THAT(newest("has not answered"), HasSubstr("has not answered for 510 ms: its process was ended"));
}

TEST_F(LocalSockets, FloodOfFaultsIsToldOnceASecond) {
  manager = load(server());
  for (int i = 0; i < 250; ++i) {
    ASSERT_EQ(ask("step tcp"), 0);
    EXPECT_EQ(step(), 1);
  }
  int told = 0;
  for (std::uint64_t i = manager->events().first(); i < manager->events().total(); ++i) {
    told += manager->events()[i].kind == EventKind::fault ? 1 : 0;
  }
  EXPECT_LE(told, 3);
  EXPECT_EQ(service(), ServiceState::failing);
}

TEST_F(LocalSockets, WithARuleOfItsOwnItIsGivenUpByIt) {
  manager = load(server(", give_up_after: {faults: 3, within: 2 s}"));
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(ask("step tcp"), 0);
    EXPECT_EQ(step(), 1);
  }
  EXPECT_EQ(service(), ServiceState::out_of_service);
}

}  // namespace
}  // namespace gaitway::core
