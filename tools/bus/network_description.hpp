// Every identifier on one robot's bus, with names and physical units: what the message table, the profile and
// the network file say together. The .dbc file and docs/network.md are made from it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/can/profile.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/bus/message_meaning.hpp"

namespace gaitway::tools {

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

}  // namespace gaitway::tools
