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
#include <optional>
#include <stdexcept>
#include <string>

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

// Does `work` while the server is stepped.
template <class Work>
auto served(MemoryBlockServer& memory, const Work& work) {
  auto result = std::async(std::launch::async, work);
  while (result.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    memory.step(0);
  }
  return result.get();
}

// The one that asks is served before the one whose claim it is, since it came first.
class ClaimsOfOthers : public Processes {
 protected:
  void SetUp() override {
    Processes::SetUp();
    memory.emplace(block, socket);
    first.emplace(served(*memory, [this] { return Client::connect(socket, "first"); }));
    holder.emplace(served(*memory, [this] { return Client::connect(socket, "holder"); }));
    held.emplace(served(*memory, [this] { return holder->write<Imu>("imu"); }));
  }
  void TearDown() override {
    memory.reset();
    Processes::TearDown();
  }
  // What the first one is told that asks to write the topic; `leave` is called when the question lies there,
  // before anybody is served.
  template <class T, class Leave>
  std::string answer_after(const char* topic, const Leave& leave) {
    pollfd wake{memory->wake_fd(), POLLIN, 0};
    auto asked =
        std::async(std::launch::async, [&] { return error_of([&] { (void)first->write<T>(topic); }); });
    EXPECT_EQ(poll(&wake, 1, 2000), 1) << "the question has come";
    leave();
    while (asked.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      memory->step(0);
    }
    return asked.get();
  }

  MemoryBlock block;
  std::optional<MemoryBlockServer> memory;
  std::optional<Client> first;
  std::optional<Client> holder;
  std::optional<Writer<Imu>> held;
};

TEST_F(ClaimsOfOthers, RefuseWhileTheirHolderLives) {
  EXPECT_THAT(answer_after<Imu>("imu", [] {}), HasSubstr("already written by 'holder'"));
}

TEST_F(ClaimsOfOthers, AreVoidWhenTheirHolderHasLeft) {
  EXPECT_EQ(answer_after<Imu>("imu",
                              [this] {
                                held.reset();
                                holder.reset();
                              }),
            "no error");
}

TEST_F(ClaimsOfOthers, AreVoidWhenTheirHolderHasGivenThemBack) {
  EXPECT_EQ(answer_after<Imu>("imu", [this] { held.reset(); }), "no error");
  EXPECT_NO_THROW(served(*memory, [this] { (void)holder->write<TrimCommand>("trim"); })) << "it lives on";
}

TEST_F(ClaimsOfOthers, AreVoidWhenTheirHolderWasKilled) {
  Process killed([this] {
    static Client client = Client::connect(socket, "killed");
    static const Writer<TrimCommand> writer = client.write<TrimCommand>("trim");
  });
  ASSERT_TRUE(served(*memory, [&] { return killed.ready(); }));
  EXPECT_EQ(answer_after<TrimCommand>("trim", [&] { killed.end(); }), "no error");
}

TEST_F(ClaimsOfOthers, AreNotMadeWithAnAnswerThatCannotBeGiven) {
  Client owner = block.local_client("owner");
  const QueueReader<UserCommand> reader = owner.read_queue<UserCommand>("user_command");
  const auto ask = [this] {
    return served(*memory, [this] {
      return error_of([this] { (void)first->write_queue<UserCommand>("user_command"); });
    });
  };
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{0, before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  const std::string refusal = ask();
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_THAT(refusal, HasSubstr("for reading"));
  EXPECT_EQ(ask(), "no error");
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
