// What a network file's joints carry and claim: sensor channels with their scales, names, controllers, places
// in the trim frame. All functions throw RobotError.
#pragma once

#include <array>
#include <map>
#include <string>

#include "gaitway/input/yaml_value.hpp"
#include "robot_files.hpp"

namespace gaitway::urdf {

// The network file's channel_scale: only the kinds of sensors that the robot has need one.
class ChannelScales {
 public:
  explicit ChannelScales(const input::YamlValue& map);

  // The channel of this name, with its scale.
  [[nodiscard]] SensorChannel channel(const input::YamlValue& name) const;

 private:
  std::map<std::string, double, std::less<>> scale_;
};

// Complains where two joints share a name, a controller, a place in the trim frame or a sensor channel.
class JointClaims {
 public:
  void add(const input::YamlValue& map, const NetworkJoint& joint);

  // Complains where a sensor is carried in part, where one is missing that every robot has (gyro,
  // accelerometer, what its feet say that they have), and where a foot's channel is not of its sensor.
  void require_channels(const input::YamlValue& joints, const std::array<Foot, 2>& feet) const;

 private:
  void claim(const input::YamlValue& value, const std::string& what, const std::string& owner,
             const std::string& remedy);
  [[nodiscard]] bool is_carried(const NamedChannel& channel) const;
  [[nodiscard]] bool any_of_sensor(const SensorChannel& channel) const;

  std::map<std::string, std::string> owners_;
};

}  // namespace gaitway::urdf
