// Which orders the user interface module may give, what each carries, and how old it may be when it is
// carried out.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::contract {

enum class OrderKind : std::uint16_t {
  walk = 1,
  motion = 2,
  user_command = 3,
  plugin_request = 4,
  way = 5,
  head = 6,
  command = 7,
  behaviour = 8
};

// An order begins with how many stops of all kinds the module had asked for when it was given (4 bytes,
// little-endian): one that was given before a stop which the robot has heard moves it no more, though it
// arrives after it. Then comes the request.
inline constexpr std::size_t kStopsSeenBytes = 4;

// Request and answer are topic values (topic_codec.hpp). Their fields `number` mean nothing on the link,
// which has its own. An answer's result is an OrderResultCode.
struct OrderRow {
  OrderKind kind;
  std::string_view name;  // for people
  const TypeDescriptor* request;
  const TypeDescriptor* answer;  // null: the result says all
  std::int64_t validity_ns;      // of the robot's time, from when the client is known to have given it
};

// A velocity's `valid_until_ns` counts from when it is carried out. Stops are no orders: they do not become
// too old.
inline constexpr std::array kOrders{
    OrderRow{OrderKind::walk, "velocity", &TopicType<WalkCommand>::descriptor, nullptr,
             200 * facts::kMillisecond_ns},
    OrderRow{OrderKind::motion, "motion", &TopicType<MotionRequest>::descriptor,
             &TopicType<MotionState>::descriptor, facts::kSecond_ns},
    OrderRow{OrderKind::user_command, "user command", &TopicType<UserCommand>::descriptor,
             &TopicType<UserCommandAnswer>::descriptor, facts::kSecond_ns},
    OrderRow{OrderKind::plugin_request, "plug-in request", &TopicType<PluginRequest>::descriptor,
             &TopicType<PluginAnswer>::descriptor, 5 * facts::kSecond_ns},
    OrderRow{OrderKind::way, "way", &TopicType<WalkToRequest>::descriptor,
             &TopicType<NavigationState>::descriptor, facts::kSecond_ns},
    OrderRow{OrderKind::head, "look", &TopicType<HeadCommand>::descriptor, nullptr, facts::kSecond_ns},
    OrderRow{OrderKind::command, "command", &TopicType<CommandRequest>::descriptor,
             &TopicType<CommandState>::descriptor, facts::kSecond_ns},
    // Of its answer, what tells of the nodes is left out: 0.
    OrderRow{OrderKind::behaviour, "mission", &TopicType<BehaviourRequest>::descriptor,
             &TopicType<PluginAnswer>::descriptor, facts::kSecond_ns},
};

// Null: no such kind.
[[nodiscard]] constexpr const OrderRow* find_order(std::uint16_t kind) noexcept {
  const auto* const found = std::ranges::find(kOrders, static_cast<OrderKind>(kind), &OrderRow::kind);
  return found == kOrders.end() ? nullptr : found;
}
[[nodiscard]] constexpr const OrderRow& row(OrderKind kind) noexcept {
  return *find_order(static_cast<std::uint16_t>(kind));
}

enum class OrderResultCode : std::uint16_t {
  done = 0,       // or answered by the robot, whose answer says whether it was done
  malformed = 1,  // not a value of the request's type, or a number that is not finite
  unknown = 2,    // no such kind of order
  full = 3,       // the robot's queue has no room
  overtaken = 4,  // another of its kind came before this one could be carried out
  stopped = 5     // it was given before a stop that has been heard
};

}  // namespace gaitway::contract
