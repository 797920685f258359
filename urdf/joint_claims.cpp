// Which channels belong together, and who has which.
#include "joint_claims.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gaitway/input/complaint.hpp"

namespace gaitway::urdf {
namespace {

constexpr int kWrenchForces = 3;
constexpr std::array kNeededOfWrench{2, 3, 4};  // force z, torque x and y: the place of the pressure

// Key of a channel's scale in channel_scale.
std::string_view scale_key(const SensorChannel& channel) {
  switch (channel.kind) {
    case SensorKind::none:
      break;
    case SensorKind::force_cell:
      return "force_N";
    case SensorKind::foot_acceleration:
      return "foot_acceleration_m_per_s2";
    case SensorKind::angular_velocity:
      return "angular_velocity_rad_per_s";
    case SensorKind::acceleration:
      return "acceleration_m_per_s2";
    case SensorKind::inclination:
      return "inclination_rad";
    case SensorKind::foot_wrench:
      return channel.index < kWrenchForces ? "foot_force_N" : "foot_torque_Nm";
  }
  return "";
}

std::string claim_of(const std::string& channel) {
  return "sensor channel '" + channel + "'";
}

const char* sensor_name(FootSensor sensor) {
  return sensor == FootSensor::cells ? "cells" : sensor == FootSensor::six_axis ? "six_axis" : "none";
}

}  // namespace

ChannelScales::ChannelScales(const input::YamlValue& map) {
  std::vector<std::string_view> keys;
  for (const NamedChannel& known : all_channels()) {
    const std::string_view key = scale_key(known.channel);
    if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  }
  map.require_map(keys);
  for (const std::string_view key : keys) {
    if (const auto value = map.find(key)) {
      scale_.emplace(key, value->number(input::Range{1e-6, 10.0, "a count"}));
    }
  }
}

SensorChannel ChannelScales::channel(const input::YamlValue& name) const {
  const std::string text = name.text();
  std::vector<std::string> known{"none"};
  if (text == "none") {
    return {};
  }
  for (const NamedChannel& candidate : all_channels()) {
    if (candidate.name == text) {
      SensorChannel channel = candidate.channel;
      const auto scale = scale_.find(scale_key(channel));
      if (scale == scale_.end()) {
        name.refuse("nothing says what a count of it is",
                    fmt::format("Add channel_scale.{}", scale_key(channel)));
      }
      channel.scale = scale->second;
      return channel;
    }
    known.push_back(candidate.name);
  }
  name.refuse("there is no such sensor channel", input::suggest(text, known));
}

void JointClaims::add(const input::YamlValue& map, const NetworkJoint& joint) {
  const std::string& owner = joint.joint.name;
  claim(map.at("name"), "name '" + owner + "'", owner, "List each joint once: it has one local controller");
  claim(map.at("node"), fmt::format("controller {}", joint.joint.node), owner,
        "Give each joint a controller of its own, 1..64");
  if (joint.joint.trim_channel >= 0) {
    claim(map.at("trim_channel"), fmt::format("trim channel {}", joint.joint.trim_channel), owner,
          "Give each trimmed joint a channel of its own, 0..7");
  }
  for (std::size_t i = 0; i < joint.channels.size(); ++i) {
    if (joint.channels[i].kind != SensorKind::none) {
      claim(map.at("channels").items()[i], claim_of(channel_name(joint.channels[i])), owner,
            "Each sensor channel travels in one joint's feedback frame only");
    }
  }
}

void JointClaims::require_channels(const input::YamlValue& joints, const std::array<Foot, 2>& feet) const {
  for (const NamedChannel& named : all_channels()) {
    const SensorChannel& channel = named.channel;
    const FootSensor sensor = feet[index_of(channel.side)].sensor;
    const FootSensor of_kind =
        channel.kind == SensorKind::force_cell ? FootSensor::cells : FootSensor::six_axis;
    const bool tells_load = channel.kind == SensorKind::force_cell || channel.kind == SensorKind::foot_wrench;
    if (tells_load && sensor != of_kind) {
      if (!is_carried(named)) continue;
      joints.refuse(
          fmt::format("the sensor channel '{}' is carried, but the foot's sensor is '{}'", named.name,
                      sensor_name(sensor)),
          fmt::format("Write sensor: {} for both feet, or take the channel away", sensor_name(of_kind)));
    }
    const bool may_lack =
        channel.kind == SensorKind::foot_wrench
            ? std::ranges::find(kNeededOfWrench, channel.index) == kNeededOfWrench.end()
            : (channel.kind == SensorKind::foot_acceleration || channel.kind == SensorKind::inclination) &&
                  !any_of_sensor(channel);
    if (!may_lack && !is_carried(named)) {
      joints.refuse(fmt::format("the sensor channel '{}' is carried by no joint", named.name),
                    "Add it to the channels of a joint that has room");
    }
  }
}

void JointClaims::claim(const input::YamlValue& value, const std::string& what, const std::string& owner,
                        const std::string& remedy) {
  const auto [place, is_new] = owners_.emplace(what, owner);
  if (!is_new) {
    value.refuse(
        fmt::format("{} is taken by joint '{}' already (asked for by '{}')", what, place->second, owner),
        remedy);
  }
}

bool JointClaims::is_carried(const NamedChannel& channel) const {
  return owners_.contains(claim_of(channel.name));
}

bool JointClaims::any_of_sensor(const SensorChannel& channel) const {
  return std::ranges::any_of(all_channels(), [&](const NamedChannel& other) {
    return other.channel.kind == channel.kind && other.channel.side == channel.side && is_carried(other);
  });
}

}  // namespace gaitway::urdf
