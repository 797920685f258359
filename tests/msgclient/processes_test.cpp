// The memory block across processes: a server process, clients in further processes, and what happens when
// they are killed.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <list>
#include <string>
#include <vector>

#include "checked_value.hpp"
#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/msgclient/memory_block_server.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/process/listening_socket.hpp"
#include "gaitway/process/working_copy.hpp"
#include "topic_error.hpp"

namespace gaitway::msgclient {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A forked child must not outlive a test that fails.
void end_with_parent() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
}

// A process that runs `work`, then waits to be killed; ready() returns when the work is done.
class Process {
 public:
  explicit Process(const std::function<void()>& work) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    pid_ = fork();
    if (pid_ == 0) {
      end_with_parent();
      const auto say = [&](char c) { return write(ends[1], &c, 1) == 1; };
      try {
        work_ready_ = [&] { (void)say('+'); };
        work();
        (void)say('+');
        while (true) {
          pause();
        }
      } catch (const std::exception& error) {
        std::fprintf(stderr, "child: %s\n", error.what());
        (void)say('-');
        _exit(1);
      }
    }
    close(ends[1]);
    ready_ = process::FileDescriptor(ends[0]);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() { end(); }

  // For work that doesn't return: called in the child.
  static void work_is_ready() { work_ready_(); }
  bool ready() {
    char c = 0;
    return read(ready_.get(), &c, 1) == 1 && c == '+';
  }
  void end() {
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      waitpid(pid_, nullptr, 0);
      pid_ = -1;
    }
  }

 private:
  inline static std::function<void()> work_ready_;
  process::FileDescriptor ready_;
  pid_t pid_ = -1;
};

void serve_forever(const std::filesystem::path& socket) {
  MemoryBlock block;
  MemoryBlockServer server(block, socket);
  Process::work_is_ready();
  for (std::int64_t beat = 1;; ++beat) {
    pollfd wake{server.wake_fd(), POLLIN, 0};
    poll(&wake, 1, 1000);
    block.beat(beat);
    server.step(beat);
  }
}

class Processes : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/gaitway_test_XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder = name;
    socket = folder / "block.sock";
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  void start_server() {
    server = std::make_unique<Process>([this] { serve_forever(socket); });
    ASSERT_TRUE(server->ready());
  }
  // Claims are given back when the server has seen the end of the process; asks until then.
  template <class T>
  std::optional<Writer<T>> claim_again(Client& client, std::string_view topic) {
    for (int attempt = 0; attempt < 1000; ++attempt) {
      try {
        return client.write<T>(topic);
      } catch (const TopicError&) {
        poll(nullptr, 0, 1);
      }
    }
    return std::nullopt;
  }

  std::filesystem::path folder;
  std::filesystem::path socket;
  std::unique_ptr<Process> server;
};

TEST_F(Processes, ATopicCrossesFromOneProcessToAnother) {
  start_server();
  Client client = Client::connect(socket, "stability");
  auto reader = client.read<Estimate>("estimate");
  Process zmp([this] {
    static Client writer_client = Client::connect(socket, "zmp");
    static auto writer = writer_client.write<Estimate>("estimate");
    Estimate estimate{};
    estimate.com[2] = 0.42;
    writer.publish(estimate, 5);
  });
  ASSERT_TRUE(zmp.ready());
  Estimate seen{};
  const ReadResult result = reader.read(seen);
  EXPECT_EQ(result.status, ReadStatus::value);
  EXPECT_EQ(result.stamp_ns, 5);
  EXPECT_EQ(seen.com[2], 0.42);
  EXPECT_EQ(client.find("estimate")->writer, "zmp");
  EXPECT_GT(client.heartbeat_ns(), 0);
}

TEST_F(Processes, ASealedClientKeepsWhatItHasAndGetsNothingMore) {
  start_server();
  Client api = Client::connect(socket, "api");
  auto writer = std::make_optional(api.write<WalkCommand>("walk_command"));
  api.seal();
  for (const auto& request : std::initializer_list<std::function<void()>>{
           [&] { (void)api.write<Estimate>("estimate"); },
           [&] { (void)api.read<WalkCommand>("walk_command"); },
           [&] { (void)api.write_queue<UserCommand>("user_command"); }, [&] { api.seal(); }}) {
    EXPECT_THAT(error_of(request), AllOf(HasSubstr("'api' is sealed"), HasSubstr("before seal()")));
  }
  EXPECT_FALSE(api.find("estimate").has_value());
  Client other = Client::connect(socket, "other");
  writer->publish({}, 7);
  WalkCommand seen{};
  EXPECT_EQ(other.read<WalkCommand>("walk_command").read(seen).stamp_ns, 7) << "its handles work on";
  writer.reset();
  EXPECT_TRUE(claim_again<WalkCommand>(other, "walk_command").has_value()) << "it gives its claims back";
  EXPECT_NE(error_of([&] { (void)api.write<WalkCommand>("walk_command"); }), "") << "for good";
}

TEST_F(Processes, ASecondWriterAndAnotherTypeAreRefusedByName) {
  start_server();
  Client zmp = Client::connect(socket, "zmp");
  Client impostor = Client::connect(socket, "impostor");
  auto writer = zmp.write<Estimate>("estimate");
  EXPECT_THAT(error_of([&] { (void)impostor.write<Estimate>("estimate"); }),
              AllOf(HasSubstr("'estimate'"), HasSubstr("'zmp'"), HasSubstr("'impostor'")));
  EXPECT_THAT(error_of([&] { (void)impostor.read<Imu>("estimate"); }),
              AllOf(HasSubstr("Imu"), HasSubstr("Estimate")));
  EXPECT_THAT(error_of([&] {
                (void)impostor.write_untyped({"large", "Large", 1, 900'000, TopicKind::latest, 0});
              }),
              HasSubstr("'large'"));
}

TEST_F(Processes, AKilledWritersTopicKeepsItsValueAndCanBeClaimedAgain) {
  start_server();
  Client observer = Client::connect(socket, "observer");
  auto reader = observer.read<WalkCommand>("walk_command");
  Process first([this] {
    static Client client = Client::connect(socket, "behavior");
    static auto writer = client.write<WalkCommand>("walk_command");
    WalkCommand command{};
    command.walk = 1;
    writer.publish(command, 10);
  });
  ASSERT_TRUE(first.ready());
  first.end();
  WalkCommand seen{};
  ASSERT_TRUE(reader.read(seen)) << "the last value survives";
  EXPECT_EQ(seen.walk, 1u);
  Client restarted = Client::connect(socket, "behavior");
  auto writer = claim_again<WalkCommand>(restarted, "walk_command");
  ASSERT_TRUE(writer);
  EXPECT_EQ(writer->untyped().generation(), 2u);
  seen.walk = 0;
  EXPECT_EQ(writer->publish(seen, 20), 2u) << "the sequence goes on";
  EXPECT_EQ(reader.read(seen).stamp_ns, 20) << "an old mapping sees the new writer";
}

TEST_F(Processes, AReleasedHandleFreesItsTopicWithoutTheClientEnding) {
  start_server();
  Client client = Client::connect(socket, "a");
  { auto writer = client.write<Imu>("imu"); }
  auto again = client.write<Imu>("imu");
  EXPECT_EQ(again.untyped().generation(), 2u);
}

TEST_F(Processes, MemoryForReadingCannotBeWrittenTruncatedOrRemapped) {
  start_server();
  Client writer_client = Client::connect(socket, "writer");
  Client reader_client = Client::connect(socket, "reader");
  const TopicGrant writable = writer_client.open_window("window", 8192, Role::writer);
  const TopicGrant readable = reader_client.open_window("window", 8192, Role::reader);
  static_cast<char*>(writable.storage->data())[100] = 'x';
  EXPECT_EQ(static_cast<const char*>(readable.storage->data())[100], 'x');

  EXPECT_LT(readable.storage->fd(), 0) << "nothing is left through which it could be opened again";
  EXPECT_LT(writable.storage->fd(), 0);
  EXPECT_EQ(mprotect(readable.storage->data(), 8192, PROT_READ | PROT_WRITE), -1);
  EXPECT_EQ(errno, EACCES);
  EXPECT_EQ(static_cast<const char*>(readable.storage->data())[100], 'x');
  EXPECT_DEATH(static_cast<volatile char*>(readable.storage->data())[100] = 'z', "");
}

TEST(Segment, WhatIsHandedToReadersCannotBeWrittenTruncatedOrOpenedAgain) {
  const Segment segment = Segment::create("segment", 8192);
  const process::FileDescriptor readable = segment.reopen_read_only();
  EXPECT_EQ(mmap(nullptr, 8192, PROT_READ | PROT_WRITE, MAP_SHARED, readable.get(), 0), MAP_FAILED);
  EXPECT_EQ(errno, EACCES);
  EXPECT_EQ(pwrite(readable.get(), "y", 1, 100), -1);
  EXPECT_EQ(ftruncate(readable.get(), 0), -1);
  struct stat status {};
  ASSERT_EQ(fstat(readable.get(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0400U) << "not for writing, through /proc/self/fd either";
  for (const off_t size : {0, 4096, 16384}) {
    EXPECT_EQ(ftruncate(segment.fd(), size), -1) << "not even the writer can: " << size;
    EXPECT_EQ(errno, EPERM);
  }
  EXPECT_EQ(fcntl(segment.fd(), F_ADD_SEALS, F_SEAL_WRITE), -1) << "and nobody can seal the writer out";
}

TEST_F(Processes, AQueueCrossesProcesses) {
  start_server();
  Client api = Client::connect(socket, "api");
  auto writer = api.write_queue<WalkCommand>("walk_requests", 2);
  Process behavior([this] {
    static Client client = Client::connect(socket, "behavior");
    static auto reader = client.read_queue<WalkCommand>("walk_requests");
    static auto echo = client.write<WalkCommand>("walk_command");
    Process::work_is_ready();
    WalkCommand command{};
    while (true) {
      if (const ReadResult result = reader.pop(command); result) {
        echo.publish(command, result.stamp_ns);
      }
    }
  });
  ASSERT_TRUE(behavior.ready());
  auto reader = api.read<WalkCommand>("walk_command");
  WalkCommand command{};
  for (int i = 1; i <= 10; ++i) {
    command.turn_rate = i;
    while (!writer.push(command, i)) {
    }
  }
  WalkCommand seen{};
  while (reader.newest_sequence() < 10) {
  }
  ASSERT_TRUE(reader.read(seen));
  EXPECT_EQ(seen.turn_rate, 10.0);
}

TEST_F(Processes, TheEmiCrossesProcesses) {
  start_server();
  Client client = Client::connect(socket, "message_controller");
  EmiMessage message(client);
  Process main([this] {
    static Client host_client = Client::connect(socket, "main_controller");
    static EmiHost host(host_client);
    static HandOver hand_over;
    hand_over.sequence = 3;
    hand_over.joint_count = 22;
    hand_over.point_count = 30;
    hand_over.set_position(29, 21, 1.5F);
    if (!host.post(hand_over, 0)) {
      throw TopicError("not posted");
    }
    Process::work_is_ready();
    while (!host.take_answer(0)) {
    }
    host.post(TrimUpdate{.stamp_ns = 99}, 0);
  });
  ASSERT_TRUE(main.ready());
  const auto received = std::make_unique<HandOver>();
  ASSERT_EQ(message.take_hand_over(*received, 1'000'000), TakeStatus::mail);
  EXPECT_EQ(received->position_at(29, 21), 1.5F);
  ASSERT_TRUE(message.answer({MailKind::hand_over, 3, Verdict::accepted}));
  ASSERT_TRUE(main.ready());
  TrimUpdate trim;
  ASSERT_EQ(message.take_trim(trim, 1'000'000'000), TakeStatus::mail);
  EXPECT_EQ(trim.stamp_ns, 99);
}

TEST_F(Processes, ClientsSurviveTheServersEnd) {
  start_server();
  Client client = Client::connect(socket, "a");
  auto writer = client.write<Imu>("imu");
  auto reader = client.read<Imu>("imu");
  server->end();
  Imu imu{};
  writer.publish(imu, 4);
  EXPECT_EQ(reader.read(imu).stamp_ns, 4);
  EXPECT_THAT(error_of([&] { (void)client.read<Estimate>("estimate"); }), HasSubstr("message controller"));
  start_server();  // over the stale socket
  Client again = Client::connect(socket, "a");
  EXPECT_EQ(again.directory().size(), 0u);
}

TEST_F(Processes, MissingAndHangingServersAreNamed) {
  EXPECT_THAT(error_of([&] { (void)Client::connect(socket, "a"); }),
              AllOf(HasSubstr("block.sock"), HasSubstr("running?")));
  MemoryBlock block;
  MemoryBlockServer never_stepped(block, socket);
  EXPECT_THAT(error_of([&] { (void)Client::connect(socket, "a", std::chrono::milliseconds(20)); }),
              HasSubstr("no answer within 20 ms"));
  EXPECT_THROW(MemoryBlockServer(block, socket), process::SocketError) << "one serves it already";
}

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

// The writer is killed again and again while it publishes; large values make sure that it is in the middle of
// one.
TEST(CopiedBlock, GoesOnWithWhatIsThereAndLeavesNoTrace) {
  MemoryBlock block;
  Client client = block.local_client("both");
  auto writer = client.write<Imu>("imu");
  auto reader = client.read<Imu>("imu");
  auto pushes = client.write_queue<UserCommand>("user_command");
  auto pops = client.read_queue<UserCommand>("user_command");
  Imu imu{};
  writer.publish(imu, 5);
  (void)pushes.push(UserCommand{}, 5);
  for (int copies = 0; copies < 2; ++copies) {
    process::WorkingCopy copy([&](const process::WorkingCopy::Tell& tell) {
      block.keep_to_this_process();
      tell(std::to_string(reader.read(imu).stamp_ns));
      writer.publish(imu, 6);
      tell(std::to_string(reader.read(imu).stamp_ns));
      UserCommand command{};
      tell(pops.pop(command) ? "a command" : "no command");
    });
    std::vector<std::string> told;
    while (!copy.done()) {
      std::ranges::move(copy.listen(), std::back_inserter(told));
    }
    EXPECT_THAT(told, ElementsAre("5", "6", "a command"));
    EXPECT_EQ(reader.read(imu).stamp_ns, 5);
  }
}

TEST(KilledWriter, AlwaysLeavesAWholeValue) {
  using Value = CheckedValue<4096>;
  constexpr int kKills = 300;
  const RingGeometry geometry{sizeof(Value), kSlotsOfLargeTopic};
  const auto grant = [&, storage =
                             std::make_shared<const Segment>(Segment::create("killed", geometry.bytes()))] {
    TopicGrant result;
    result.geometry = geometry;
    result.storage = storage;
    return result;
  };
  UntypedReader reader(grant());
  auto* const base = static_cast<SharedWord*>(grant().storage->data());
  const auto value = std::make_unique<Value>();
  std::uint64_t last = 0;
  int killed_half_way = 0;
  int torn = 0;
  for (int round = 0; round < kKills; ++round) {
    const std::uint64_t before = ring::published(base);
    const pid_t writer = fork();
    if (writer == 0) {
      end_with_parent();
      UntypedWriter publisher(grant());
      for (std::uint64_t seed = before + 1;; ++seed) {
        value->fill(seed);
        publisher.publish(value.get(), 0);
      }
    }
    while (ring::published(base) < before + 3) {
    }
    for (int i = 0; i < round % 7; ++i) {  // and read under way: shifts the moment of the kill, too
      if (const ReadResult result = reader.read(value.get()); result) {
        torn += value->whole() && value->word[0] == result.sequence ? 0 : 1;
      }
    }
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
    const std::uint64_t newest = ring::published(base);
    killed_half_way += ring::slot(base, geometry, newest + 1)[0] == 0 ? 1 : 0;
    const ReadResult result = reader.read(value.get());
    ASSERT_EQ(result.status, ReadStatus::value) << "round " << round;
    ASSERT_EQ(result.sequence, newest);
    ASSERT_TRUE(value->whole() && torn == 0) << "round " << round;
    ASSERT_EQ(value->word[0], newest);
    ASSERT_GT(newest, last);
    last = newest;
  }
  EXPECT_GT(killed_half_way, 10) << "the test must hit writers at work";
}

}  // namespace
}  // namespace gaitway::msgclient
