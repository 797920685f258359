// Reads a calibration strictly: values that no calibration gives are refused.
#include "robot_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"

namespace gaitway::urdf {
namespace {

using Keys = std::vector<std::string_view>;

using facts::kRadPerDegree;
constexpr input::Range kZero_deg{-20.0, 20.0, "deg"};
constexpr input::Range kComOffset_m{-0.1, 0.1, "m"};
constexpr input::Range kGain{0.5, 2.0, ""};
constexpr input::Range kDeviation{0.0, 1000.0, ""};
constexpr std::size_t kCells = 4;

// Deviations are for people: read, so that a slip of the pen is found, and not used.
template <std::size_t count>
std::array<double, count> values_with_deviation(const input::YamlValue& map, const input::Range& range) {
  map.require_map(Keys{"value", "deviation"});
  if (const auto deviation = map.find("deviation")) (void)deviation->numbers<count>(kDeviation);
  return map.at("value").numbers<count>(range);
}

void read_joint_zeros(const input::YamlValue& map, RobotModel& model) {
  std::vector<std::string> known;
  std::transform(model.joints.begin(), model.joints.end(), std::back_inserter(known),
                 [](const Joint& joint) { return joint.name; });
  for (const auto& [name, value] : map.entries()) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      value.refuse(fmt::format("the robot '{}' has no joint '{}'", model.name, name),
                   input::suggest(name, known));
    }
    value.require_map(Keys{"value", "deviation"});
    if (const auto deviation = value.find("deviation")) (void)deviation->number(kDeviation);
    model.joints[static_cast<std::size_t>(found - known.begin())].encoder_zero_rad =
        value.at("value").number(kZero_deg) * kRadPerDegree;
  }
}

void set_gains(Side side, const std::array<double, kCells>& gains, RobotModel& model) {
  for (auto& pair : model.channels) {
    for (SensorChannel& channel : pair) {
      if (channel.kind == SensorKind::force_cell && channel.side == side) {
        channel.gain = gains[static_cast<std::size_t>(channel.index)];
      }
    }
  }
}

}  // namespace

void apply_calibration_file(const std::filesystem::path& file, RobotModel& model) {
  const input::YamlValue top = input::YamlValue::read(file);
  top.require_map(Keys{"robot", "joint_zeros_deg", "trunk_com_offset_m", "force_cell_gains"});
  const input::YamlValue robot = top.at("robot");
  if (robot.text() != model.name) {
    robot.refuse(fmt::format("the robot in this folder is '{}'", model.name),
                 "Calibrate this robot (gaitway calibrate), or remove the file.");
  }
  if (const auto zeros = top.find("joint_zeros_deg")) read_joint_zeros(*zeros, model);
  if (const auto offset = top.find("trunk_com_offset_m")) {
    const auto offset_m = values_with_deviation<3>(*offset, kComOffset_m);
    model.trunk_com_offset_m = Eigen::Vector3d(offset_m.data());
    model.links[static_cast<std::size_t>(model.imu.link)].com_m += model.trunk_com_offset_m;
  }
  if (const auto gains = top.find("force_cell_gains")) {
    gains->require_map(Keys{"left", "right"});
    set_gains(Side::left, values_with_deviation<kCells>(gains->at("left"), kGain), model);
    set_gains(Side::right, values_with_deviation<kCells>(gains->at("right"), kGain), model);
  }
}

}  // namespace gaitway::urdf
