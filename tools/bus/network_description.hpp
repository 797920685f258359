// Every identifier on one robot's bus, with names, meanings and physical units: what the message table, the
// profile and the network file say together; and what is made from it, the .dbc file and docs/network.md.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/can/message_layout.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

// A value of a field that has a name.
struct NamedValue {
  std::int64_t value = 0;
  std::string_view name;     // a word
  std::string_view meaning;  // a sentence's part
};

// What messages and their fields mean, in words. Where the fields lie is said in can/message_layout.hpp
// alone, whose names these texts go by. What the message is for, in one or two sentences.
[[nodiscard]] std::string_view meaning_of(can::MessageKind kind);
// What the field says. Throws std::logic_error that names it when nobody has described it.
[[nodiscard]] std::string_view meaning_of(can::MessageKind kind, std::string_view field);
// Empty for a field that is a number.
[[nodiscard]] std::span<const NamedValue> values_of(can::MessageKind kind, std::string_view field);
// The field is a mask of bits: then the named values are its bits.
[[nodiscard]] bool is_mask(can::MessageKind kind, std::string_view field);

struct DescribedSignal {
  std::string name;  // a C identifier, unique in its message
  can::FieldSpec field;
  double factor = 1.0;  // of a raw value, in `unit`
  std::string unit;     // ASCII; empty for a bare number
  // Of the physical value: what the field holds, or what the joint's limits allow.
  double lowest = 0.0, highest = 0.0;
  std::string meaning;
  std::span<const NamedValue> values = {};
  bool mask = false;
};

struct DescribedMessage {
  std::uint32_t id = 0;
  std::string name;  // a C identifier, unique
  can::MessageKind kind{};
  can::NodeId node = 0;  // 0: to all
  bool toggle = false;
  std::uint8_t part = 0;  // of a tail
  std::string sender;
  std::vector<std::string> receivers;
  std::vector<DescribedSignal> signals;
};

struct DescribedNode {
  std::string name;  // a C identifier, unique: the joint's
  can::NodeId node = 0;
  int joint = 0;  // index into RobotModel::joints
};

struct NetworkDescription {
  std::string robot;
  can::Profile profile;
  std::vector<DescribedNode> nodes;        // the local controllers on the bus, in the order of the joints
  std::vector<DescribedMessage> messages;  // by identifier, the most urgent first
};

inline constexpr std::string_view kMessageControllerName = "message_controller";

[[nodiscard]] NetworkDescription describe_network(const urdf::RobotModel& robot, const can::Profile& profile);

// How a number is written: as short as it can be, rounded to twelve digits.
[[nodiscard]] std::string number_text(double value);

// The .dbc file, which cantools, SavvyCAN and other bus tools read to decode frames. Deterministic. Names
// longer than the format's 32 characters are cut and given whole in the attribute that tools know for it.
// Times: GenMsgCycleTime for periodic messages; messages on events have GenMsgSendType "event" and their
// smallest distance in GenMsgDelayTime, both in milliseconds; GaitwayDeadline in microseconds.
[[nodiscard]] std::string dbc_text(const NetworkDescription& network);

// docs/network.md: how the network works, and every message down to the bit, for whoever builds a robot or a
// tool for it. Markdown; deterministic. `full` and `paper`: the same robot in both profiles.
[[nodiscard]] std::string network_document(const urdf::RobotModel& robot, const NetworkDescription& full,
                                           const NetworkDescription& paper);

}  // namespace gaitway::tools
