// The memory block inside one process: declaring, claiming, reading, refusing.
#include "gaitway/msgclient/memory_block.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/msgclient/topics.hpp"
#include "topic_error.hpp"

namespace gaitway::msgclient {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(MemoryBlock, ASealedLocalClientOpensNothingMore) {
  MemoryBlock block;
  Client client = block.local_client("api");
  auto writer = client.write<Estimate>("estimate");
  client.seal();
  EXPECT_THAT(error_of([&] { (void)client.read<Imu>("imu"); }),
              ::testing::AllOf(::testing::HasSubstr("topic 'imu'"), ::testing::HasSubstr("'api' is sealed")));
  writer.publish({}, 3);
  Estimate seen{};
  EXPECT_EQ(block.local_client("other").read<Estimate>("estimate").read(seen).stamp_ns, 3);
}

TEST(MemoryBlock, DeliversTheNewestValueWithItsSequenceAndStamp) {
  MemoryBlock block;
  Client zmp = block.local_client("zmp");
  Client stability = block.local_client("stability");
  auto writer = zmp.write<Estimate>("estimate");
  auto reader = stability.read<Estimate>("estimate");

  Estimate estimate{};
  EXPECT_EQ(reader.read(estimate).status, ReadStatus::none);
  for (int i = 1; i <= 20; ++i) {
    estimate.com[2] = 0.01 * i;
    EXPECT_EQ(writer.publish(estimate, i * 1000), static_cast<std::uint64_t>(i));
  }
  Estimate seen{};
  const ReadResult result = reader.read(seen);
  EXPECT_EQ(result.status, ReadStatus::value);
  EXPECT_EQ(result.sequence, 20u);
  EXPECT_EQ(result.stamp_ns, 20'000);
  EXPECT_EQ(seen.com[2], 0.2);
}

TEST(MemoryBlock, ReaderMayComeBeforeTheWriter) {
  MemoryBlock block;
  Client client = block.local_client("both");
  auto reader = client.read<Imu>("imu");
  auto writer = client.write<Imu>("imu");
  Imu imu{};
  imu.acceleration[2] = 9.81;
  writer.publish(imu, 5);
  Imu seen{};
  ASSERT_TRUE(reader.read(seen));
  EXPECT_EQ(seen.acceleration[2], 9.81);
}

TEST(MemoryBlock, RefusesASecondWriterByName) {
  MemoryBlock block;
  Client first = block.local_client("trajectory");
  Client second = block.local_client("impostor");
  auto writer = first.write<MotionPlan>("motion_plan");
  EXPECT_THAT(error_of([&] { (void)second.write<MotionPlan>("motion_plan"); }),
              AllOf(HasSubstr("'motion_plan'"), HasSubstr("'trajectory'"), HasSubstr("'impostor'")));
}

TEST(MemoryBlock, AWriterThatGoesFreesItsTopicAndLeavesItsLastValue) {
  MemoryBlock block;
  Client client = block.local_client("trajectory");
  auto reader = client.read<WalkCommand>("walk_command");
  {
    auto writer = client.write<WalkCommand>("walk_command");
    EXPECT_EQ(client.find("walk_command")->writer, "trajectory");
    WalkCommand command{};
    command.walk = 1;
    writer.publish(command, 1);
  }
  EXPECT_EQ(client.find("walk_command")->writer, "");
  WalkCommand seen{};
  ASSERT_TRUE(reader.read(seen));
  EXPECT_EQ(seen.walk, 1u);

  auto again = client.write<WalkCommand>("walk_command");
  EXPECT_EQ(again.untyped().generation(), 2u);
  EXPECT_EQ(again.publish(seen, 2), 2u) << "the sequence goes on";
}

TEST(MemoryBlock, RefusesAnotherTypeNamingBothSides) {
  MemoryBlock block;
  Client client = block.local_client("zmp");
  Client other = block.local_client("vision");
  auto writer = client.write<Estimate>("estimate");
  EXPECT_THAT(error_of([&] { (void)other.read<Imu>("estimate"); }),
              AllOf(HasSubstr("'zmp'"), HasSubstr("'vision'"), HasSubstr("Estimate"), HasSubstr("Imu")));
}

TEST(MemoryBlock, RefusesTheSameTypeFromAnotherSchema) {
  MemoryBlock block;
  Client client = block.local_client("zmp");
  auto writer = client.write<Estimate>("estimate");
  TopicDescriptor other_build = TopicDescriptor::of<Estimate>("estimate");
  other_build.type_hash ^= 1;
  EXPECT_THAT(error_of([&] { (void)client.read_untyped(other_build); }), HasSubstr("same schema"));
}

TEST(MemoryBlock, RefusesAnotherKindOrCapacity) {
  MemoryBlock block;
  Client client = block.local_client("a");
  auto writer = client.write_stream<Imu>("imu", 8);
  EXPECT_THAT(error_of([&] { (void)client.read<Imu>("imu"); }), HasSubstr("stream"));
  EXPECT_THAT(error_of([&] { (void)client.read_stream<Imu>("imu", 9); }), HasSubstr("capacity 9"));
}

TEST(MemoryBlock, HoldsAllStandardTopicsInItsDefaultSize) {
  MemoryBlock block;
  Client client = block.local_client("all");
  for (const StandardTopic& topic : kStandardTopics) {
    (void)client.read_untyped({std::string(topic.name), std::string(topic.type->name), topic.type->hash,
                               topic.type->size, TopicKind::latest, 0});
  }
  EXPECT_LT(block.used_bytes(), block.size_bytes() / 2) << "leaves room for the plug-ins' own topics";
}

TEST(MemoryBlock, RefusesWhatDoesNotFitNamingTopicAndSizes) {
  MemoryBlock block(std::size_t{1} << 20);
  Client client = block.local_client("greedy");
  const TopicDescriptor large{"panorama", "Image", 1, 300'000, TopicKind::latest, 0};
  EXPECT_THAT(
      error_of([&] { (void)client.write_untyped(large); }),
      AllOf(HasSubstr("'panorama'"), HasSubstr("'greedy'"), HasSubstr("300000"), HasSubstr("1048576")));
  EXPECT_FALSE(client.find("panorama").has_value());
  MemoryBlock larger(kMaxBlockBytes);
  EXPECT_EQ(error_of([&] { (void)larger.local_client("greedy").write_untyped(large); }), "no error");
  EXPECT_THAT(error_of([] { MemoryBlock too_large(kMaxBlockBytes + 4096); }), HasSubstr("at most"));
}

TEST(MemoryBlock, RefusesUnusableNamesAndSizes) {
  MemoryBlock block;
  Client client = block.local_client("a");
  EXPECT_THAT(error_of([&] { (void)client.read<Imu>(""); }), HasSubstr("1 to 63"));
  EXPECT_THAT(error_of([&] { (void)client.read<Imu>(std::string(64, 'x')); }), HasSubstr("1 to 63"));
  EXPECT_THAT(error_of([&] { (void)client.read<Imu>("with space"); }), HasSubstr("'with space'"));
  EXPECT_THAT(error_of([&] {
                (void)client.read_untyped({"empty", "Empty", 1, 0, TopicKind::latest, 0});
              }),
              HasSubstr("0 bytes"));
}

TEST(MemoryBlock, DirectoryShowsTopicsGenerationAndHeartbeat) {
  MemoryBlock block;
  Client client = block.local_client("zmp");
  const std::uint64_t before = client.generation();
  auto writer = client.write<Estimate>("estimate");
  EXPECT_GT(client.generation(), before);
  block.beat(123'456);
  EXPECT_EQ(client.heartbeat_ns(), 123'456);
  const auto rows = client.directory();
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].descriptor.name, "estimate");
  EXPECT_EQ(rows[0].descriptor.type_name, "Estimate");
  EXPECT_EQ(rows[0].descriptor.type_hash, TopicType<Estimate>::hash);
  EXPECT_EQ(rows[0].descriptor.size, sizeof(Estimate));
  EXPECT_EQ(rows[0].writer, "zmp");
  EXPECT_EQ(rows[0].generation, 1u);
}

TEST(MemoryBlock, HandlesOutliveClientAndBlock) {
  auto block = std::make_unique<MemoryBlock>();
  auto reader = block->local_client("a").read<Imu>("imu");
  auto writer = block->local_client("b").write<Imu>("imu");
  block.reset();
  Imu imu{};
  writer.publish(imu, 7);
  EXPECT_EQ(reader.read(imu).stamp_ns, 7);
}

TEST(MemoryBlock, CarriesValuesWhoseSizeIsNoMultipleOfAWord) {
  MemoryBlock block;
  Client client = block.local_client("odd");
  const TopicDescriptor descriptor{"odd", "Odd", 7, 13, TopicKind::latest, 0};
  UntypedWriter writer = client.write_untyped(descriptor);
  UntypedReader reader = client.read_untyped(descriptor);
  const std::string value = "thirteenchars";
  writer.publish(value.data(), 1);
  std::string seen(16, '#');
  ASSERT_TRUE(reader.read(seen.data()));
  EXPECT_EQ(seen, value + "###") << "nothing is written behind the value";
}

}  // namespace
}  // namespace gaitway::msgclient
