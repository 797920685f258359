// A plug-in that serves the network, taken over: what it tries, in the thread that listens or in its step, is
// refused; and whatever becomes of its process, the others do not notice.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <poll.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include "gaitway/msgclient/memory_block_server.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "plugin_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::AllOf;
using testing::HasSubstr;

bool kernel_has_landlock() {
  constexpr long kCreateRuleset = 444;
  constexpr unsigned kAskVersion = 1;
  return syscall(kCreateRuleset, nullptr, 0, kAskVersion) >= 1;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

class NetworkChild : public PluginFixture {
 protected:
  NetworkChild() {
    std::string name = (std::filesystem::path(testing::TempDir()) / "gaitway_network_child_XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
    std::filesystem::create_directories(inside());
    std::ofstream(inside() / "kept") << "kept";
  }
  ~NetworkChild() override {
    manager.reset();
    std::filesystem::remove_all(folder);
  }
  [[nodiscard]] std::filesystem::path inside() const { return folder / "inside"; }
  static std::string server(const std::string& more = "") {
    return "  - {name: server, library: serves_network.so, isolation: process, network: serve" + more + "}\n";
  }
  [[nodiscard]] std::string writes() const { return ", writes: " + inside().string(); }

  // The newest line of the server that contains `part`.
  [[nodiscard]] std::string newest(const std::string& part) const {
    const EventLog& events = manager->events();
    for (std::uint64_t i = events.total(); i > events.first(); --i) {
      if (events[i - 1].source() == "server" && events[i - 1].text().find(part) != std::string_view::npos) {
        return std::string(events[i - 1].text());
      }
    }
    return {};
  }
  // The server's answer; -2: it closed the connection without one.
  [[nodiscard]] int ask(const std::string& what) const {
    const process::FileDescriptor connection(socket(AF_INET, SOCK_STREAM, 0));
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port = htons(static_cast<std::uint16_t>(std::atoi(newest("port ").c_str() + 5)));
    EXPECT_EQ(connect(connection.get(), reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
    EXPECT_EQ(send(connection.get(), what.data(), what.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(what.size()));
    std::array<char, 32> answer{};
    return recv(connection.get(), answer.data(), answer.size() - 1, 0) > 0 ? std::atoi(answer.data()) : -2;
  }
  int step() {
    const int failed = manager->step(tick(++number));
    manager->maintain(tick(number).now_ns);
    return failed;
  }
  [[nodiscard]] std::string fault() const {
    for (std::size_t i = 0; i < manager->size(); ++i) {
      if (manager->plugin(i).name() == "server") {
        return std::string(manager->plugin(i).fault());
      }
    }
    return {};
  }
  // Of the last of two relays that work beside it.
  double relayed() {
    Correction correction{};
    EXPECT_TRUE(other.read<Correction>("b").read(correction));
    return correction.com_offset[0];
  }
  static std::string relays() {
    return relay("first", "to: a") + relay("second", "from: a, add: 100, to: b");
  }
  [[nodiscard]] ServiceState service() const {
    for (const PluginTiming& timing : manager->timings()) {
      if (timing.name == "server") {
        return timing.state;
      }
    }
    return ServiceState::stopped;
  }
  // Ends its process and gives the line with which it comes back.
  std::string end_and_wait() {
    EXPECT_EQ(ask("die"), -2);
    int failed = 0;
    for (int i = 0; i == 0 || (failed > 0 && i < 100); ++i) {
      failed = step();
      EXPECT_EQ(failed, i == 0 ? 1 : std::min(failed, 1)) << "nobody else fails";
      EXPECT_EQ(relayed(), 100.0 + number);
      EXPECT_EQ(manager->fault_behind("b"), nullptr);
    }
    EXPECT_EQ(failed, 0);
    return newest("runs in a new process");
  }

  std::filesystem::path folder;
  std::unique_ptr<PluginManager> manager;
  std::uint32_t number = 0;
};

TEST_F(NetworkChild, WhatItsThreadTriesAfterSetUpIsRefused) {
  manager = load(server(writes()));
  for (const char* const name :
       {"socket", "socketpair", "connect", "fast open", "bind",   "listen", "openat2",  "unlink",
        "rename", "mkdir",      "link",    "symlink",   "chmod",  "chown",  "truncate", "mount",
        "kill",   "own",        "limit",   "fork",      "execve", "ptrace", "real time"}) {
    EXPECT_EQ(ask(std::string("here ") + name), EPERM) << name;
  }
  for (const char* const name :
       {"read", "read and write", "path", "write outside", "write beside", "write to memory"}) {
    EXPECT_EQ(ask(std::string("here ") + name), EACCES) << name;
  }
  EXPECT_EQ(ask("here thread"), 0);
  EXPECT_EQ(ask("here write inside"), kernel_has_landlock() ? 0 : EACCES);
  EXPECT_EQ(text_of(inside() / "recording"), kernel_has_landlock() ? "data" : "");
  EXPECT_EQ(text_of(inside() / "kept"), "kept");
  EXPECT_FALSE(std::filesystem::exists(folder / "taken"));
  EXPECT_EQ(step(), 0) << "it is no fault of its step";
}

TEST_F(NetworkChild, WhatItsStepTriesIsRefusedAndAFaultOfThatStep) {
  manager = load(server(writes()));
  for (const auto& [name, call] : {std::pair{"socket", "socket"},
                                   {"connect", "connect"},
                                   {"kill", "kill"},
                                   {"fork", "clone"},
                                   {"execve", "execve"},
                                   {"own", "fcntl"}}) {
    ASSERT_EQ(ask(std::string("step ") + name), 0);
    EXPECT_EQ(step(), 1) << name;
    EXPECT_THAT(fault(), HasSubstr(std::string("called ") + call));
    EXPECT_EQ(newest("error"), "error " + std::to_string(EPERM)) << name;
    EXPECT_EQ(step(), 0) << "its process lives on";
  }
  for (const char* const name : {"read", "write outside"}) {
    ASSERT_EQ(ask(std::string("step ") + name), 0);
    EXPECT_EQ(step(), 0) << name;
    EXPECT_EQ(newest("error"), "error " + std::to_string(EACCES)) << name;
  }
}

TEST_F(NetworkChild, WithoutAFolderItCreatesNoFileAtAll) {
  manager = load(server());
  for (const char* const name : {"read", "write inside", "write outside"}) {
    EXPECT_EQ(ask(std::string("here ") + name), EACCES) << name;
  }
}

TEST_F(NetworkChild, ItsFolderIsMade) {
  manager = load(server(", writes: " + (folder / "new" / "deep").string()));
  EXPECT_TRUE(std::filesystem::is_directory(folder / "new" / "deep"));
  EXPECT_THAT(newest("port"), HasSubstr("writes to '" + (folder / "new" / "deep").string() + "'"));
}

TEST_F(NetworkChild, FolderThatCannotBeMadeOrFromWhichPluginsAreLoadedIsRefused) {
  EXPECT_THAT(refusal(server(", writes: /proc/new")),
              AllOf(HasSubstr("plug-in 'server' (test.yaml:2)"), HasSubstr("'/proc/new' cannot be made")));
  EXPECT_THAT(refusal(server(", writes: " GAITWAY_TEST_PLUGINS)),
              HasSubstr("from which plug-ins are loaded"));
  EXPECT_THAT(refusal(server(", writes: " GAITWAY_TEST_PLUGINS "/..")),
              HasSubstr("from which plug-ins are loaded"));
  EXPECT_THAT(refusal(server(writes()) + "  - {name: other, library: " + inside().string() + "/other.so}\n"),
              HasSubstr("from which plug-ins are loaded"));
}

TEST_F(NetworkChild, HasTheLimitsOfItsEntryAndNoPriority) {
  const sched_param first{.sched_priority = 1}, none{};
  const bool real_time = sched_setscheduler(0, SCHED_FIFO, &first) == 0;  // where the rights are there
  manager = load(server(", descriptors: 200, memory: 700 MiB"));
  if (real_time) {
    sched_setscheduler(0, SCHED_OTHER, &none);
  }
  EXPECT_EQ(ask("policy"), SCHED_OTHER);
  EXPECT_EQ(ask("nice"), 5);
  EXPECT_EQ(ask("descriptors"), 200);
  EXPECT_EQ(ask("memory"), 700);
}

TEST_F(NetworkChild, IsAClientOfTheMemoryBlockThatClaimsNothingMore) {
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
  manager = load(server(writes() + ", parameters: {client: true}"));
  EXPECT_THAT(newest("port"), HasSubstr("memory at '" + memory_socket.string() + "'"));
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

TEST_F(NetworkChild, InProcessItKnowsTheMemorySocket) {
  memory_socket = "/run/robot/block.sock";
  manager = load("  - {name: server, library: serves_network.so}\n");
  EXPECT_THAT(newest("port"), HasSubstr("memory at '/run/robot/block.sock', writes to ''"));
}

TEST_F(NetworkChild, IsAlwaysReplacedButTheOftenerTheLater) {
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

TEST_F(NetworkChild, InRealTimeLateStepsLeaveNoTraceOnTheOthersAndNeverPutItOutOfService) {
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
  EXPECT_THAT(newest("has not answered"), HasSubstr("ms"));
}

TEST_F(NetworkChild, FloodOfFaultsIsToldOnceASecond) {
  manager = load(server());
  for (int i = 0; i < 250; ++i) {
    ASSERT_EQ(ask("step socket"), 0);
    EXPECT_EQ(step(), 1);
  }
  int told = 0;
  for (std::uint64_t i = manager->events().first(); i < manager->events().total(); ++i) {
    told += manager->events()[i].kind == EventKind::fault ? 1 : 0;
  }
  EXPECT_LE(told, 3);
  EXPECT_EQ(service(), ServiceState::failing);
}

TEST_F(NetworkChild, WithARuleOfItsOwnItIsGivenUpByIt) {
  manager = load(server(", give_up_after: {faults: 3, within: 2 s}"));
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(ask("step socket"), 0);
    EXPECT_EQ(step(), 1);
  }
  EXPECT_EQ(service(), ServiceState::out_of_service);
}

}  // namespace
}  // namespace gaitway::core
