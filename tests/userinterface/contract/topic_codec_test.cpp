// Topic values over the narrow link: what arrives is what was sent, and what is none is refused.
#include "gaitway/contract/topic_codec.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <vector>

#include "gaitway/contract/channel_table.hpp"
#include "gaitway/contract/order_table.hpp"
#include "gaitway/link/order.hpp"

namespace gaitway::contract {
namespace {

constexpr std::size_t kJoints = 22;

// A value of any type with numbers that a float32 holds, and texts of any length.
class RandomValue {
 public:
  RandomValue(const TypeDescriptor& type, std::mt19937_64& random)
      : words(type.size / sizeof(std::uint64_t)), random_(random) {
    for (const FieldDescriptor& field : type.fields) fill(field);
  }
  std::vector<std::uint64_t> words;

 private:
  void fill(const FieldDescriptor& field) {
    const bool joints = field.rank > 0 && field.extents[0] == kMaxJoints;
    const std::uint32_t elements = joints ? field.elements() / kMaxJoints * kJoints : field.elements();
    auto* place = reinterpret_cast<std::byte*>(words.data()) + field.offset;
    const bool text = field.type == ScalarType::uint8_value && field.rank > 0;
    const std::uint32_t used =
        text ? std::uniform_int_distribution<std::uint32_t>(0, elements)(random_) : elements;
    for (std::uint32_t i = 0; i < used; ++i, place += scalar_size(field.type)) {
      if (field.type == ScalarType::float64_value) {
        const double number = static_cast<float>(std::normal_distribution<double>(0.0, 100.0)(random_));
        std::memcpy(place, &number, sizeof number);
      } else if (field.type == ScalarType::float32_value) {
        const auto number = static_cast<float>(std::normal_distribution<double>(0.0, 100.0)(random_));
        std::memcpy(place, &number, sizeof number);
      } else {
        const std::uint64_t number = random_() >> (random_() % 64);
        std::memcpy(place, &number, scalar_size(field.type));
      }
    }
  }
  std::mt19937_64& random_;
};

std::vector<const TypeDescriptor*> types() {
  std::vector<const TypeDescriptor*> all{&TopicType<Event>::descriptor};
  for (const ChannelRow& row : kChannels) {
    for (const MirroredTopic& topic : row.topics) all.push_back(topic.type);
  }
  for (const OrderRow& row : kOrders) {
    all.push_back(row.request);
    if (row.answer != nullptr) all.push_back(row.answer);
  }
  return all;
}

TEST(TopicCodec, WhatIsEncodedIsDecoded) {
  std::mt19937_64 random(1);
  const TopicCodec codec{.joint_count = kJoints};
  for (const TypeDescriptor* type : types()) {
    std::vector<std::uint8_t> wire(codec.most_bytes(*type));
    for (int round = 0; round < 200; ++round) {
      const RandomValue value(*type, random);
      const std::size_t size = codec.encode(*type, value.words.data(), wire);
      ASSERT_GT(size, 0U) << type->name << ": most_bytes() are enough";
      std::vector<std::uint64_t> back(value.words.size(), ~std::uint64_t{0});
      ASSERT_EQ(codec.decode(*type, std::span(wire).first(size), back.data()), size) << type->name;
      ASSERT_EQ(back, value.words) << type->name;
    }
  }
}

TEST(TopicCodec, AnExactOneKeepsEveryBit) {
  const TopicCodec codec{.joint_count = kJoints, .exact = true};
  WalkCommand command{};
  command.velocity[0] = 0.12;
  command.turn_rate = -1.0 / 3.0;
  std::vector<std::uint8_t> wire(codec.most_bytes(TopicType<WalkCommand>::descriptor));
  const std::size_t size = codec.encode(TopicType<WalkCommand>::descriptor, &command, wire);
  WalkCommand back;
  ASSERT_EQ(codec.decode(TopicType<WalkCommand>::descriptor, std::span(wire).first(size), &back), size);
  EXPECT_EQ(std::memcmp(&back, &command, sizeof back), 0);
}

TEST(TopicCodec, LeavesOutTheJointsThatTheRobotHasNot) {
  const TopicCodec codec{.joint_count = kJoints};
  JointStates joints{};
  joints.position[kJoints] = 5.0;
  std::vector<std::uint8_t> wire(codec.most_bytes(TopicType<JointStates>::descriptor));
  const std::size_t size = codec.encode(TopicType<JointStates>::descriptor, &joints, wire);
  EXPECT_LT(size, 4 * kJoints * sizeof(float) + 30);
  JointStates back;
  ASSERT_EQ(codec.decode(TopicType<JointStates>::descriptor, std::span(wire).first(size), &back), size);
  EXPECT_EQ(back.position[kJoints], 0.0);
}

TEST(TopicCodec, KeepsTheWholeOfWhatHasNothingToDoWithJoints) {
  const TopicCodec codec{.joint_count = kJoints};
  BehaviourState state{};
  state.transition_node[kTreeTransitions - 1] = 7;
  std::vector<std::uint8_t> wire(codec.most_bytes(TopicType<BehaviourState>::descriptor));
  const std::size_t size = codec.encode(TopicType<BehaviourState>::descriptor, &state, wire);
  BehaviourState back;
  ASSERT_EQ(codec.decode(TopicType<BehaviourState>::descriptor, std::span(wire).first(size), &back), size);
  EXPECT_EQ(back.transition_node[kTreeTransitions - 1], 7U);
}

TEST(TopicCodec, WhatIsCutOffOrTooLargeIsNone) {
  std::mt19937_64 random(2);
  const TopicCodec codec{.joint_count = kJoints};
  for (const TypeDescriptor* type : types()) {
    std::vector<std::uint8_t> wire(codec.most_bytes(*type));
    const RandomValue value(*type, random);
    const std::size_t size = codec.encode(*type, value.words.data(), wire);
    std::vector<std::uint64_t> back(value.words.size());
    for (std::size_t cut = 0; cut < size; ++cut) {
      ASSERT_EQ(codec.decode(*type, std::span(wire).first(cut), back.data()), 0U)
          << type->name << " cut at " << cut;
      ASSERT_EQ(codec.encode(*type, value.words.data(), std::span(wire).first(cut)), 0U);
      codec.encode(*type, value.words.data(), wire);
    }
  }
}

// Whatever the bytes: what is decoded is encoded to the same, so there is one way to say a thing.
TEST(TopicCodec, RandomBytesAreRefusedOrSayOneThing) {
  std::mt19937_64 random(3);
  const TopicCodec codec{.joint_count = kJoints};
  int decoded = 0;
  for (int round = 0; round < 20'000; ++round) {
    const std::vector<const TypeDescriptor*> all = types();
    const TypeDescriptor& type = *all[random() % all.size()];
    std::vector<std::uint8_t> wire(codec.most_bytes(type));
    const bool sparse = round % 2 == 0;
    for (std::uint8_t& byte : wire)
      byte = sparse && random() % 8 != 0 ? 0 : static_cast<std::uint8_t>(random());
    std::vector<std::uint64_t> value(type.size / sizeof(std::uint64_t));
    const std::size_t read = codec.decode(type, wire, value.data());
    if (read == 0) continue;
    ++decoded;
    if (!all_finite(type, value.data())) continue;  // a signalling NaN becomes a quiet one
    std::vector<std::uint8_t> again(wire.size());
    ASSERT_EQ(codec.encode(type, value.data(), again), read) << type.name;
    ASSERT_TRUE(std::equal(again.begin(), again.begin() + static_cast<std::ptrdiff_t>(read), wire.begin()))
        << type.name;
  }
  EXPECT_GT(decoded, 500);
}

TEST(TopicCodec, FindsNumbersThatAreNotFinite) {
  WalkCommand command{};
  EXPECT_TRUE(all_finite(TopicType<WalkCommand>::descriptor, &command));
  command.velocity[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(all_finite(TopicType<WalkCommand>::descriptor, &command));
  command.velocity[1] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(all_finite(TopicType<WalkCommand>::descriptor, &command));
}

TEST(OrderTable, EveryOrderAndItsAnswerFitIntoTheLinksMessages) {
  const TopicCodec codec{.joint_count = kMaxJoints, .exact = true};
  for (const OrderRow& row : kOrders) {
    EXPECT_LE(kStopsSeenBytes + codec.most_bytes(*row.request), link::kMostOrderBytes) << row.name;
    if (row.answer != nullptr) {
      EXPECT_LE(codec.most_bytes(*row.answer), link::kMostAnswerBytes) << row.name;
    }
    EXPECT_EQ(find_order(static_cast<std::uint16_t>(row.kind)), &row);
  }
  EXPECT_EQ(find_order(0), nullptr);
}

TEST(ChannelTable, ABusSlotTakesLittleOfANarrowCarrier) {
  constexpr std::size_t kFullest = 22 + 22 + 3;  // feedback, a batch, SYNC, trim and heartbeat
  BusSlot slot{};
  slot.stamp_ns = INT64_MAX / 2;
  slot.cycle = UINT32_MAX;
  slot.frame_count = kFullest;
  for (std::size_t i = 0; i < kFullest; ++i) {
    slot.id[i] = 0x7FF;
    slot.end_us[i] = 10'000;
    slot.length_us[i] = 135;
  }
  const TopicCodec codec{.joint_count = kJoints};
  std::vector<std::uint8_t> bytes(codec.most_bytes(TopicType<BusSlot>::descriptor));
  const std::size_t size = codec.encode(TopicType<BusSlot>::descriptor, &slot, bytes);
  ASSERT_GT(size, 0U);
  EXPECT_LE(size, 450U);
}

TEST(ChannelTable, TheHashesTellRobotsAndCalibrationsApart) {
  const std::filesystem::path robots = std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf";
  const urdf::RobotModel robot = urdf::load_robot(robots / "humanoid22");
  EXPECT_EQ(robot_hash(robot), robot_hash(robot));
  EXPECT_EQ(calibration_hash(robot), 0U);
  const std::filesystem::path other = std::filesystem::temp_directory_path() / "gaitway_table_hash_test";
  std::filesystem::remove_all(other);
  std::filesystem::copy(robots / "humanoid22", other, std::filesystem::copy_options::recursive);
  urdf::RobotModel changed = robot;
  changed.directory = other;
  EXPECT_EQ(robot_hash(changed), robot_hash(robot)) << "the same description elsewhere";
  std::ofstream(other / "calibration.yaml") << "robot: humanoid22\n";
  EXPECT_NE(calibration_hash(changed), 0U);
  EXPECT_EQ(robot_hash(changed), robot_hash(robot)) << "it is calibrated, but the same robot";
  std::filesystem::resize_file(other / "robot.yaml", std::filesystem::file_size(other / "robot.yaml") - 1);
  EXPECT_NE(robot_hash(changed), robot_hash(robot));
  std::filesystem::remove_all(other);
}

}  // namespace
}  // namespace gaitway::contract
