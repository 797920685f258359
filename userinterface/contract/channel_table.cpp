// Sizes and the hash of the table.
#include "gaitway/contract/channel_table.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <string>

#include "gaitway/contract/event_list.hpp"
#include "gaitway/contract/order_table.hpp"
#include "gaitway/urdf/description_text.hpp"

namespace gaitway::contract {
namespace {

constexpr std::uint32_t kLayoutVersion =
    2;  // of what TypeDescriptors do not say: the codec, the events, the orders' meaning

constexpr std::uint32_t folded(std::uint64_t hash) noexcept {
  return static_cast<std::uint32_t>(hash ^ hash >> 32U);
}

}  // namespace

msgclient::TopicDescriptor descriptor_of(const MirroredTopic& topic) {
  return {.name = std::string(topic.name),
          .type_name = std::string(topic.type->name),
          .type_hash = topic.type->hash,
          .size = topic.type->size};
}

std::vector<link::Channel> link_channels(const TopicCodec& codec) {
  std::vector<link::Channel> channels;
  for (const ChannelRow& row : kChannels) {
    std::size_t bytes = 1;
    for (const MirroredTopic& topic : row.topics) {
      bytes += codec.most_bytes(*topic.type);
    }
    channels.push_back({row.name, bytes});
  }
  channels.push_back({"events", EventList::most_bytes(codec)});
  return channels;
}

std::uint32_t table_hash() {
  detail::Fnv1a64 hash;
  hash.add_number(kLayoutVersion);
  const auto add_type = [&hash](const TypeDescriptor* type) {
    if (type != nullptr) {
      hash.add(type->name);
      hash.add_number(static_cast<std::uint32_t>(type->hash));
      hash.add_number(static_cast<std::uint32_t>(type->hash >> 32U));
    }
  };
  for (const ChannelRow& row : kChannels) {
    hash.add(row.name);
    for (const MirroredTopic& topic : row.topics) {
      hash.add(topic.name);
      add_type(topic.type);
    }
  }
  add_type(&TopicType<Event>::descriptor);
  for (const OrderRow& row : kOrders) {
    hash.add_number(static_cast<std::uint32_t>(row.kind));
    hash.add(row.name);
    add_type(row.request);
    add_type(row.answer);
  }
  return folded(hash.value());
}

std::uint32_t robot_hash(const urdf::RobotModel& robot) {
  detail::Fnv1a64 hash;
  hash.add_number(static_cast<std::uint32_t>(robot.joints.size()));
  for (const char* const file : {"robot.urdf", "robot.yaml"}) {
    hash.add(urdf::description_text(robot.directory / file));
  }
  return folded(hash.value());
}

std::uint16_t calibration_hash(const urdf::RobotModel& robot) {
  const std::filesystem::path file = robot.directory / "calibration.yaml";
  detail::Fnv1a64 hash;
  if (!std::filesystem::exists(file)) {
    return 0;
  }
  hash.add(urdf::description_text(file));
  const std::uint32_t value = folded(hash.value());
  return std::max<std::uint16_t>(static_cast<std::uint16_t>(value ^ value >> 16U), 1);
}

link::LinkIdentity identity_of(link::Role role, std::uint64_t boot, std::string_view name,
                               const urdf::RobotModel& robot) {
  return {.role = role,
          .boot = boot,
          .table_hash = table_hash(),
          .name = name,
          .robot_hash = robot_hash(robot),
          .calibration_hash = calibration_hash(robot)};
}

}  // namespace gaitway::contract
