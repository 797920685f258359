// Whom the memory block's server lets in, and that nobody who misbehaves keeps others out.
#include <gmock/gmock.h>
#include <poll.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <chrono>
#include <cstring>
#include <future>
#include <limits>
#include <list>
#include <memory>
#include <stdexcept>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/process/listening_socket.hpp"
#include "processes.hpp"

namespace gaitway::msgclient {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// A connection that asks for nothing; or a hello, which is enough to be taken for a client.
class RawClient {
 public:
  explicit RawClient(const std::filesystem::path& path) : socket_(::socket(AF_UNIX, SOCK_SEQPACKET, 0)) {
    const sockaddr_un address = process::socket_address(path);
    connected_ = connect(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }
  [[nodiscard]] bool connected() const noexcept { return connected_; }
  // Whether the other side has hung up.
  [[nodiscard]] bool dropped() const noexcept {
    pollfd end{socket_.get(), POLLIN, 0};
    return poll(&end, 1, 0) == 1 && (end.revents & POLLHUP) != 0;
  }

 private:
  process::FileDescriptor socket_;
  bool connected_ = false;
};

constexpr std::int64_t kSecond_ns = 1'000'000'000;

TEST_F(Processes, MissingAndHangingServersAreNamed) {
  EXPECT_THAT(error_of([&] { (void)Client::connect(socket, "a"); }),
              AllOf(HasSubstr("block.sock"), HasSubstr("running?")));
  MemoryBlock block;
  MemoryBlockServer never_stepped(block, socket);
  EXPECT_THAT(error_of([&] { (void)Client::connect(socket, "a", std::chrono::milliseconds(20)); }),
              HasSubstr("no answer within 20 ms"));
  EXPECT_THROW(MemoryBlockServer(block, socket), process::SocketError) << "one serves it already";
}

TEST_F(Processes, OneProcessCannotTakeTheConnectionsOfAllOthers) {
  MemoryBlock block;
  MemoryBlockServer memory(block, socket);
  std::list<RawClient> leaked;
  for (int i = 0; i < 300; ++i) {
    leaked.emplace_back(socket);
    ASSERT_TRUE(leaked.back().connected());
    memory.step(0);
  }
  EXPECT_LE(memory.client_count(), 32U);
  Process other([this] { (void)Client::connect(socket, "other").read<Imu>("imu"); });
  const process::FileDescriptor watched(dup(memory.wake_fd()));
  for (int i = 0; i < 1000 && !block.local_client("test").find("imu"); ++i) {
    pollfd wake{watched.get(), POLLIN, 0};
    poll(&wake, 1, 10);
    memory.step(0);
  }
  EXPECT_TRUE(block.local_client("test").find("imu")) << "another process was served";
}

// Its first request lies unread when the server hangs up, which resets the connection.
TEST_F(Processes, WhoIsTurnedAwayIsToldWhy) {
  MemoryBlock block;
  MemoryBlockServer memory(block, socket);
  std::list<RawClient> others;
  for (std::size_t i = 0; i < MemoryBlockServer::kMostOfOneProcess; ++i) {
    others.emplace_back(socket);
    memory.step(0);
  }
  for (int attempt = 0; attempt < 50; ++attempt) {
    auto why = std::async(std::launch::async,
                          [this] { return error_of([this] { (void)Client::connect(socket, "late"); }); });
    while (why.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      memory.step(0);
    }
    ASSERT_THAT(why.get(), HasSubstr("close some first"));
  }
}

// The kernel gives a server no number of a process that its PID namespace does not hold.
TEST_F(Processes, ProcessesOfOtherNamespacesShareTheConnectionsOfOne) {
  server = std::make_unique<Process>([this] {
    if (unshare(CLONE_NEWUSER | CLONE_NEWPID) != 0) {
      throw std::runtime_error("no namespaces here");
    }
    if (fork() == 0) {
      end_with_parent();
      serve_forever(socket);
    }
    while (true) {
      pause();
    }
  });
  if (!server->ready()) {
    GTEST_SKIP() << "this machine gives no namespaces to ordinary users";
  }
  std::list<RawClient> leaked;
  for (std::size_t i = 0; i < MemoryBlockServer::kMostOfOneProcess; ++i) {
    leaked.emplace_back(socket);
  }
  EXPECT_THAT(error_of([this] { (void)Client::connect(socket, "late"); }),
              AllOf(HasSubstr("PID namespaces"), HasSubstr("close some first")));
}

TEST_F(Processes, AClientThatAsksForNothingIsDroppedInTime) {
  MemoryBlock block;
  MemoryBlockServer memory(block, socket);
  const RawClient silent(socket);
  memory.step(5 * kSecond_ns);
  ASSERT_EQ(memory.client_count(), 1U);
  EXPECT_EQ(memory.due_ns(), 7 * kSecond_ns);
  memory.step(7 * kSecond_ns - 1);
  EXPECT_FALSE(silent.dropped());
  memory.step(7 * kSecond_ns);
  EXPECT_TRUE(silent.dropped());
  EXPECT_EQ(memory.client_count(), 0U);
  EXPECT_EQ(memory.due_ns(), std::numeric_limits<std::int64_t>::max());
}

TEST_F(Processes, WithoutADescriptorLeftTheServerTurnsClientsAwayAndSleepsOn) {
  MemoryBlock block;
  MemoryBlockServer memory(block, socket);
  const RawClient client(socket);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const int next = dup(0);  // the lowest that is free
  close(next);
  const rlimit none{static_cast<rlim_t>(next), before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  memory.step(0);
  pollfd wake{memory.wake_fd(), POLLIN, 0};
  const int readable = poll(&wake, 1, 0);
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_EQ(readable, 0) << "nothing is left to do";
  EXPECT_TRUE(client.dropped());
  const RawClient later(socket);
  memory.step(0);
  EXPECT_EQ(memory.client_count(), 1U);
}

TEST_F(Processes, AClientThatTalksNonsenseIsDroppedAlone) {
  start_server();
  Client good = Client::connect(socket, "good");
  process::FileDescriptor bad(::socket(AF_UNIX, SOCK_SEQPACKET, 0));
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, socket.c_str(), sizeof address.sun_path - 1);
  ASSERT_EQ(connect(bad.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ASSERT_EQ(send(bad.get(), "nonsense", 8, 0), 8);
  char byte = 0;
  EXPECT_LE(recv(bad.get(), &byte, 1, 0), 0) << "the server hangs up";
  EXPECT_NO_THROW((void)good.read<Imu>("imu"));
}

}  // namespace
}  // namespace gaitway::msgclient
