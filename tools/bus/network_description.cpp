// Walks over the message table, once for each node where the profile says so.
#include "tools/bus/network_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "gaitway/facts/facts.hpp"

namespace gaitway::tools {
namespace {

using can::IdRule;
using can::MessageKind;

// The nearest C identifier.
std::string identifier(std::string_view text) {
  std::string name;
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    name += std::isalnum(code) != 0 && code < 0x80U ? character : '_';
  }
  return name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0 ? "_" + name : name;
}

std::string unique(const std::string& name, std::set<std::string>& taken) {
  std::string candidate = name;
  for (int number = 2; !taken.insert(candidate).second; ++number) {
    candidate = fmt::format("{}_{}", name, number);
  }
  return candidate;
}

std::string_view unit_of(const urdf::SensorChannel& channel) {
  switch (channel.kind) {
    case urdf::SensorKind::none:
      return "";
    case urdf::SensorKind::force_cell:
      return "N";
    case urdf::SensorKind::foot_acceleration:
    case urdf::SensorKind::acceleration:
      return "m/s^2";
    case urdf::SensorKind::angular_velocity:
      return "rad/s";
    case urdf::SensorKind::inclination:
      return "rad";
    case urdf::SensorKind::foot_wrench:
      return channel.index < 3 ? "N" : "Nm";
  }
  return "";
}

// The last part of "channel_1".
std::size_t index_of(std::string_view field) {
  return static_cast<std::size_t>(field.back() - '0');
}

void set_range(DescribedSignal& signal) {
  const double span = std::ldexp(1.0, signal.field.width);
  signal.lowest = signal.field.is_signed ? -span / 2.0 * signal.factor : 0.0;
  signal.highest = (signal.field.is_signed ? span / 2.0 - 1.0 : span - 1.0) * signal.factor;
}

class Describer {
 public:
  Describer(const urdf::RobotModel& robot, const can::Profile& profile) : robot_(robot) {
    description_.robot = robot.name;
    description_.profile = profile;
    std::set<std::string> taken{std::string(kMessageControllerName)};
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      const urdf::Joint& source = robot.joints[joint];
      if (source.node <= profile.largest_node) {
        description_.nodes.push_back(
            {unique(identifier(source.name), taken), source.node, static_cast<int>(joint)});
      }
    }
  }

  NetworkDescription run() {
    for (const can::MessageLayout& message : can::kMessageLayouts) {
      switch (description_.profile.row(message.kind).rule) {
        case IdRule::unused:
          break;
        case IdRule::one:
          add(message, nullptr, {.kind = message.kind});
          break;
        case IdRule::per_node:
        case IdRule::per_node_and_toggle:
        case IdRule::per_part_node_and_toggle:
          for (const DescribedNode& node : description_.nodes) {
            add_all(message, node);
          }
          break;
      }
    }
    std::ranges::sort(description_.messages, {}, &DescribedMessage::id);
    return std::move(description_);
  }

 private:
  // Each identifier of a node's message.
  void add_all(const can::MessageLayout& layout, const DescribedNode& node) {
    const can::Profile& profile = description_.profile;
    can::Identified which{.kind = layout.kind, .node = node.node};
    for (int part = 0; part < profile.parts(layout.kind); ++part) {
      which.part = static_cast<std::uint8_t>(part);
      which.toggle = false;
      add(layout, &node, which);
      if (can::has_toggle(profile.row(layout.kind).rule)) {
        which.toggle = true;
        add(layout, &node, which);
      }
    }
  }

  void add(const can::MessageLayout& layout, const DescribedNode* node, const can::Identified& which) {
    const can::Profile& profile = description_.profile;
    DescribedMessage message;
    message.kind = layout.kind;
    message.node = which.node;
    message.toggle = which.toggle;
    message.part = which.part;
    message.id = profile.id_of(layout.kind, which.node, which.toggle, which.part);
    std::string name = identifier(layout.name);
    if (profile.row(layout.kind).rule == IdRule::per_part_node_and_toggle) {
      name += "_" + std::to_string(which.part);
    }
    if (can::has_toggle(profile.row(layout.kind).rule)) {
      name += which.toggle ? "_1" : "_0";
    }
    message.name = unique(node == nullptr ? name : name + "_" + node->name, message_names_);
    name_ends(layout, node, message);
    std::set<std::string> taken;
    for (const can::FieldSpec& field : layout.fields) {
      DescribedSignal signal = describe(layout.kind, field, node);
      signal.name = unique(identifier(signal.name), taken);
      message.signals.push_back(std::move(signal));
    }
    description_.messages.push_back(std::move(message));
  }

  void name_ends(const can::MessageLayout& layout, const DescribedNode* node,
                 DescribedMessage& message) const {
    if (layout.sender == can::Sender::local_controller && node != nullptr) {
      message.sender = node->name;
      message.receivers.emplace_back(kMessageControllerName);
      return;
    }
    message.sender = kMessageControllerName;
    if (node != nullptr) {
      message.receivers.push_back(node->name);
      return;
    }
    for (const DescribedNode& receiver : description_.nodes) {
      message.receivers.push_back(receiver.name);
    }
  }

  DescribedSignal describe(MessageKind kind, const can::FieldSpec& field, const DescribedNode* node) const {
    DescribedSignal signal;
    signal.name = field.name;
    signal.field = field;
    signal.meaning = meaning_of(kind, field.name);
    signal.values = values_of(kind, field.name);
    signal.mask = is_mask(kind, field.name);
    signal.unit = field.unit;
    const urdf::Joint* const joint =
        node == nullptr ? nullptr : &robot_.joints[static_cast<std::size_t>(node->joint)];
    if (field.unit == "network file" && node != nullptr) {
      describe_channel(robot_.channels[static_cast<std::size_t>(node->joint)][index_of(field.name)], signal);
    } else if (field.unit == "turn/65536") {
      signal.factor = 360.0 / 65536.0;
      signal.unit = "deg";
    } else if (field.unit == "N*m/8") {
      signal.factor = 0.125;
      signal.unit = "Nm";
    } else if (field.unit == "count" && field.is_signed && joint != nullptr) {
      signal.factor = joint->count_rad * facts::kDegreePerRad;
      signal.unit = "deg";
    } else if (field.unit == "trim count") {
      describe_trim(static_cast<int>(index_of(field.name)), signal);
    } else if (signal.mask) {
      signal.unit.clear();
    }
    set_range(signal);
    if (joint != nullptr && kind == MessageKind::feedback && field.name == "position") {
      signal.lowest = joint->lower_rad * facts::kDegreePerRad;
      signal.highest = joint->upper_rad * facts::kDegreePerRad;
    }
    return signal;
  }

  static void describe_channel(const urdf::SensorChannel& channel, DescribedSignal& signal) {
    signal.unit = unit_of(channel);
    if (channel.kind == urdf::SensorKind::none) {
      signal.meaning = "carries no sensor";
      return;
    }
    signal.name = urdf::channel_name(channel);
    signal.factor = channel.scale / channel.gain;
  }

  void describe_trim(int channel, DescribedSignal& signal) const {
    signal.factor = robot_.trim.count_rad * facts::kDegreePerRad;
    signal.unit = "deg";
    for (const DescribedNode& node : description_.nodes) {
      if (robot_.joints[static_cast<std::size_t>(node.joint)].trim_channel == channel) {
        signal.name = "trim_" + node.name;
        signal.meaning = "correction of " + node.name;
        return;
      }
    }
    signal.meaning = "no joint has this trim channel";
  }

  const urdf::RobotModel& robot_;
  NetworkDescription description_;
  std::set<std::string> message_names_;
};

}  // namespace

NetworkDescription describe_network(const urdf::RobotModel& robot, const can::Profile& profile) {
  return Describer(robot, profile).run();
}

std::string number_text(double value) {
  return fmt::format("{:.12g}", value);
}

}  // namespace gaitway::tools
