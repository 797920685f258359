// The generated topic types and their descriptors.
#include "gaitway/msgclient/topics.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace gaitway {
namespace {

TEST(Topics, FieldTablesCoverEveryTypeWithoutOverlap) {
  for (const TypeDescriptor* type : kStandardTypes) {
    std::uint32_t end = 0;
    for (const FieldDescriptor& field : type->fields) {
      EXPECT_GE(field.offset, end) << type->name << "." << field.name;
      EXPECT_EQ(field.offset % scalar_size(field.type), 0u) << type->name << "." << field.name;
      end = field.offset + field.elements() * scalar_size(field.type);
    }
    EXPECT_LE(end, type->size);
    EXPECT_LT(type->size - end, 8u) << type->name;
  }
}

TEST(Topics, EveryTypeHasItsOwnHash) {
  std::set<std::uint64_t> hashes;
  for (const TypeDescriptor* type : kStandardTypes) {
    EXPECT_TRUE(hashes.insert(type->hash).second) << type->name;
  }
}

TEST(Topics, ADifferentUnitFrameOrExtentIsADifferentType) {
  auto fields = TopicType<WalkCommand>::fields;
  fields[2].unit = "mm/s";
  EXPECT_NE(type_hash("WalkCommand", fields), TopicType<WalkCommand>::hash);
  fields = TopicType<WalkCommand>::fields;
  fields[2].frame = "plan";
  EXPECT_NE(type_hash("WalkCommand", fields), TopicType<WalkCommand>::hash);
  fields = TopicType<WalkCommand>::fields;
  fields[2].extents[0] = 3;
  EXPECT_NE(type_hash("WalkCommand", fields), TopicType<WalkCommand>::hash);
  fields = TopicType<WalkCommand>::fields;
  fields[2].doc = "said in other words";
  EXPECT_EQ(type_hash("WalkCommand", fields), TopicType<WalkCommand>::hash);
}

TEST(Topics, FieldTableReadsAValueWithoutItsType) {
  FootForces forces{};
  forces.force[1][2] = 17.5;
  const FieldDescriptor& field = TopicType<FootForces>::fields[1];
  ASSERT_EQ(field.name, "force");
  ASSERT_EQ(field.rank, 2u);
  double value = 0.0;
  std::memcpy(
      &value,
      reinterpret_cast<const char*>(&forces) + field.offset + (1 * field.extents[1] + 2) * sizeof value,
      sizeof value);
  EXPECT_EQ(value, 17.5);
  EXPECT_EQ(field.unit, "N");
}

TEST(Topics, StandardTopicsNameWriterTypeAndPeriod) {
  const auto& joint_states = kStandardTopics.front();
  EXPECT_EQ(joint_states.name, "joint_states");
  EXPECT_EQ(joint_states.type, &TopicType<JointStates>::descriptor);
  EXPECT_EQ(joint_states.writer, "message_controller");
  EXPECT_EQ(joint_states.period_ns, 10'000'000);
}

}  // namespace
}  // namespace gaitway
