// The complete list of channel names, built once.
#include "gaitway/urdf/robot_model.hpp"

#include <array>

namespace gaitway::urdf {
namespace {

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};

void add(std::vector<NamedChannel>& list, const std::string& prefix, std::span<const std::string_view> names,
         SensorKind kind, Side side) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    list.push_back({prefix + std::string(names[i]), {kind, side, static_cast<int>(i), 1.0}});
  }
}

std::vector<NamedChannel> make_channels() {
  static constexpr std::array<std::string_view, 4> kCellNames{"front_left", "front_right", "rear_left",
                                                              "rear_right"};
  static constexpr std::array<std::string_view, 6> kWrenchNames{"force_x",  "force_y",  "force_z",
                                                                "torque_x", "torque_y", "torque_z"};
  static constexpr std::array<std::string_view, 2> kTiltNames{"roll", "pitch"};
  std::vector<NamedChannel> list;
  for (const Side side : kSides) {
    const std::string prefix = side == Side::left ? "left_" : "right_";
    add(list, prefix + "cell_", kCellNames, SensorKind::force_cell, side);
    add(list, prefix + "foot_acceleration_", kAxes, SensorKind::foot_acceleration, side);
    add(list, prefix + "foot_", kWrenchNames, SensorKind::foot_wrench, side);
  }
  add(list, "angular_velocity_", kAxes, SensorKind::angular_velocity, Side::left);
  add(list, "acceleration_", kAxes, SensorKind::acceleration, Side::left);
  add(list, "inclination_", kTiltNames, SensorKind::inclination, Side::left);
  return list;
}

}  // namespace

const std::vector<NamedChannel>& all_channels() {
  static const std::vector<NamedChannel> kChannels = make_channels();
  return kChannels;
}

std::string channel_name(const SensorChannel& channel) {
  for (const NamedChannel& candidate : all_channels()) {
    if (candidate.channel.kind == channel.kind && candidate.channel.side == channel.side &&
        candidate.channel.index == channel.index) {
      return candidate.name;
    }
  }
  return "none";
}

}  // namespace gaitway::urdf
