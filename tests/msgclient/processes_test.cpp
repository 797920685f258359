// The memory block across processes: topics, queues and the EMI between them, and what memory for reading is
// held to.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <cerrno>
#include <functional>
#include <initializer_list>

#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "processes.hpp"

namespace gaitway::msgclient {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

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
                (void)impostor.write_untyped({"large", "Large", 1, 3'200'000, TopicKind::latest, 0});
              }),
              HasSubstr("'large'"));
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

}  // namespace
}  // namespace gaitway::msgclient
