// Which topics the narrow link mirrors, in which channels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "gaitway/contract/topic_codec.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/link/session.hpp"
#include "gaitway/link/state_sender.hpp"
#include "gaitway/msgclient/topic.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::contract {

struct MirroredTopic {
  std::string_view name;
  const TypeDescriptor* type;
};

// As who opens it wants it.
[[nodiscard]] msgclient::TopicDescriptor descriptor_of(const MirroredTopic& topic);

// A channel's value: a byte whose bit i says that topic i is there, then those that are (topic_codec.hpp).
// Topics of one channel arrive together: what belongs to one time slot is never mixed with another.
struct ChannelRow {
  std::string_view name;
  std::span<const MirroredTopic> topics;
  std::int64_t period_ns;         // between two values, at least
  std::int64_t narrow_period_ns;  // the same on a carrier that is slower than a Unix socket
};

inline constexpr std::array kMotionTopics{
    MirroredTopic{"joint_states", &TopicType<JointStates>::descriptor},
    MirroredTopic{"estimate", &TopicType<Estimate>::descriptor},
    MirroredTopic{"planned_state", &TopicType<PlannedState>::descriptor}};
inline constexpr std::array kSensorTopics{MirroredTopic{"foot_forces", &TopicType<FootForces>::descriptor},
                                          MirroredTopic{"imu", &TopicType<Imu>::descriptor}};
inline constexpr std::array kNetworkTopics{
    MirroredTopic{"network_state", &TopicType<NetworkState>::descriptor}};
inline constexpr std::array kMotionStateTopics{
    MirroredTopic{"motion_state", &TopicType<MotionState>::descriptor}};
inline constexpr std::array kNavigationTopics{
    MirroredTopic{"navigation_state", &TopicType<NavigationState>::descriptor}};
inline constexpr std::array kCommandTopics{
    MirroredTopic{"command_state", &TopicType<CommandState>::descriptor}};
inline constexpr std::array kBehaviourTopics{
    MirroredTopic{"behaviour_state", &TopicType<BehaviourState>::descriptor}};
inline constexpr std::array kBehaviourNodeTopics{
    MirroredTopic{"behaviour_nodes", &TopicType<BehaviourNodes>::descriptor}};
inline constexpr std::array kHealthTopics{
    MirroredTopic{"network_health", &TopicType<NetworkHealth>::descriptor}};
inline constexpr std::array kStatisticsTopics{
    MirroredTopic{"plugin_statistics", &TopicType<PluginStatistics>::descriptor}};
inline constexpr std::array kBusSlotTopics{MirroredTopic{"bus_slot", &TopicType<BusSlot>::descriptor}};

inline constexpr std::array kChannels{
    ChannelRow{"motion", kMotionTopics, 0, 0},
    ChannelRow{"sensors", kSensorTopics, 0, 10 * facts::kSlot_ns},
    ChannelRow{"network", kNetworkTopics, 0, 5 * facts::kSlot_ns},
    ChannelRow{"motion_state", kMotionStateTopics, 0, 0},
    ChannelRow{"navigation", kNavigationTopics, 8 * facts::kSlot_ns, 50 * facts::kSlot_ns},
    ChannelRow{"health", kHealthTopics, 10 * facts::kSlot_ns, 50 * facts::kSlot_ns},
    ChannelRow{"statistics", kStatisticsTopics, 50 * facts::kSlot_ns, 100 * facts::kSlot_ns},
    // A slot every 250 ms. Of these each third on a narrow carrier: two have no slots of odd numbers.
    ChannelRow{"bus_slot", kBusSlotTopics, 0, 70 * facts::kSlot_ns},
    ChannelRow{"command", kCommandTopics, 0, 20 * facts::kSlot_ns},
    // 2.4 kB with each batch.
    ChannelRow{"behaviour", kBehaviourTopics, 0, 100 * facts::kSlot_ns},
    // Parts of a tree, one with each batch, in turn. Of these each 67th on a narrow carrier: a prime above
    // the number of parts that there can be, so each comes in its turn.
    ChannelRow{"behaviour_nodes", kBehaviourNodeTopics, 0, 532 * facts::kSlot_ns},
};

// Behind them: the newest events (event_list.hpp).
inline constexpr std::size_t kEventChannel = kChannels.size();

// The link's table of channels for a robot.
[[nodiscard]] std::vector<link::Channel> link_channels(const TopicCodec& codec);

static_assert((kMaxTreeNodes + kToldNodes - 1) / kToldNodes < 67, "parts of a tree");

// By which both ends know that they mean the same: channels, orders and types; the robot's description
// (robot.urdf and robot.yaml of its folder); its calibration (calibration.yaml; 0: there is none). Throws
// urdf::RobotError when a file cannot be read.
[[nodiscard]] std::uint32_t table_hash();
[[nodiscard]] std::uint32_t robot_hash(const urdf::RobotModel& robot);
[[nodiscard]] std::uint16_t calibration_hash(const urdf::RobotModel& robot);

// What an end of the link says of itself: with these. `name` outlives it.
[[nodiscard]] link::LinkIdentity identity_of(link::Role role, std::uint64_t boot, std::string_view name,
                                             const urdf::RobotModel& robot);

// Which topics of a channel's value are there.
[[nodiscard]] constexpr std::uint8_t topic_bit(std::size_t topic) noexcept {
  return static_cast<std::uint8_t>(1U << topic);
}

}  // namespace gaitway::contract
