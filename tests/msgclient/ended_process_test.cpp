// What the end of a process leaves behind: of a writer in the middle of a value, of the server, of a copy.
#include <gmock/gmock.h>
#include <poll.h>

#include <array>
#include <filesystem>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "checked_value.hpp"
#include "gaitway/msgclient/memory_block_server.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/working_copy.hpp"
#include "processes.hpp"

namespace gaitway::msgclient {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

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

// Another process reads from the copy what the first owner never had, and the first owner sees nothing of it.
TEST(CopiedBlock, BecomesABlockForOtherProcesses) {
  const process::PrivateFolder folder("gaitway_copy");
  const std::filesystem::path socket = folder.path() / "copy.sock";
  MemoryBlock block;
  Client client = block.local_client("both");
  auto writer = client.write<Imu>("imu");
  auto reader = client.read<Imu>("imu");
  auto pushes = client.write_queue<UserCommand>("user_command");
  Imu imu{};
  writer.publish(imu, 5);
  (void)pushes.push(UserCommand{}, 5);
  process::WorkingCopy copy([&](const process::WorkingCopy::Tell& tell) {
    block.keep_to_this_process();
    writer.publish(imu, 6);
    block.share_anew();
    MemoryBlockServer server(block, socket);
    process::WorkingCopy other([&](const process::WorkingCopy::Tell& tell_owner) {
      Client outside = Client::connect(socket, "outside");
      auto outside_reader = outside.read<Imu>("imu");
      auto outside_pops = outside.read_queue<UserCommand>("user_command");
      UserCommand command{};
      tell_owner(std::to_string(outside_reader.read(imu).stamp_ns));
      tell_owner(outside_pops.pop(command) ? "a command" : "no command");
      while (outside_reader.read(imu).stamp_ns != 7) {
      }
      tell_owner("7");
    });
    bool published = false;
    while (!other.done()) {
      std::array<pollfd, 2> wakes{pollfd{server.wake_fd(), POLLIN, 0}, pollfd{other.descriptor(), POLLIN, 0}};
      poll(wakes.data(), wakes.size(), -1);
      server.step(0);
      if (wakes[1].revents == 0) continue;
      for (const std::string& line : other.listen()) {
        tell(line);
        if (line == "a command" && !std::exchange(published, true)) writer.publish(imu, 7);
      }
    }
  });
  std::vector<std::string> told;
  while (!copy.done()) {
    std::ranges::move(copy.listen(), std::back_inserter(told));
  }
  EXPECT_THAT(told, ElementsAre("6", "a command", "7"));
  EXPECT_EQ(reader.read(imu).stamp_ns, 5);
}

// The writer is killed again and again while it publishes; large values make sure that it is in the middle of
// one.
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
