// Reads strictly; writes so many digits that nothing is lost that matters.
#include "tools/calibrate/standing_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"

namespace gaitway::calibration {
namespace {

using Keys = std::vector<std::string_view>;
using input::YamlValue;

constexpr input::Range kAngle{-180.0, 180.0, "deg"};
constexpr input::Range kSpecificForce{-20.0, 20.0, "m/s²"};
constexpr input::Range kForce{-1000.0, 1000.0, "N"};
constexpr input::Range kMass{0.1, 1000.0, "kg"};
constexpr input::Range kMassDeviation{1e-6, 100.0, "kg"};
constexpr double kSmallest = 1e-9, kLargest = 100.0;

template <std::size_t count>
struct WithDeviation {
  std::array<double, count> value, deviation;
};

template <std::size_t count>
WithDeviation<count> read_pair(const YamlValue& map, const input::Range& range) {
  map.require_map(Keys{"value", "deviation"});
  return {map.at("value").numbers<count>(range),
          map.at("deviation").numbers<count>({kSmallest, kLargest, range.unit})};
}

std::vector<double> read_joints(const YamlValue& map, const urdf::RobotModel& robot) {
  std::vector<double> joint_rad(robot.joints.size(), 0.0);
  std::vector<std::string> missing;
  for (const urdf::Joint& joint : robot.joints) missing.push_back(joint.name);
  for (const auto& [name, value] : map.entries()) {
    const auto found = std::ranges::find(missing, name);
    if (found == missing.end()) {
      value.refuse(fmt::format("the robot '{}' has no joint '{}'", robot.name, name),
                   input::suggest(name, missing));
    }
    missing.erase(found);
    joint_rad[static_cast<std::size_t>(robot.joint_index(name))] =
        value.number(kAngle) * facts::kRadPerDegree;
  }
  if (!missing.empty()) {
    map.refuse(fmt::format("the angle of '{}' is missing", missing.front()), "Give each joint's.");
  }
  return joint_rad;
}

std::array<bool, 2> read_stands(const YamlValue& value) {
  const std::string text = value.text();
  if (text != "both" && text != "left" && text != "right") {
    value.refuse("must be both, left or right", "Name the feet on the floor.");
  }
  return {text != "right", text != "left"};
}

StandingMeasurement read_pose(const YamlValue& map, const urdf::RobotModel& robot) {
  map.require_map(Keys{"name", "stands", "placement", "joints_deg", "specific_force_m_per_s2",
                       "inclination_deg", "left_cells_N", "right_cells_N"});
  StandingMeasurement pose;
  pose.pose = map.at("name").text();
  if (const auto stands = map.find("stands")) pose.stands = read_stands(*stands);
  if (const auto placement = map.find("placement")) pose.placement = placement->integer(0, 1000);
  pose.joint_rad = read_joints(map.at("joints_deg"), robot);
  const auto force = read_pair<3>(map.at("specific_force_m_per_s2"), kSpecificForce);
  pose.specific_force_m_per_s2 = Eigen::Vector3d(force.value.data());
  pose.specific_force_deviation_m_per_s2 = Eigen::Vector3d(force.deviation.data());
  if (const auto inclination = map.find("inclination_deg")) {
    const auto tilt = read_pair<2>(*inclination, kAngle);
    pose.inclination_rad = Eigen::Vector2d(facts::kRadPerDegree * Eigen::Vector2d(tilt.value.data()));
    pose.inclination_deviation_rad = facts::kRadPerDegree * Eigen::Vector2d(tilt.deviation.data());
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const auto cells = read_pair<kCells>(map.at(side == 0 ? "left_cells_N" : "right_cells_N"), kForce);
    pose.force_N[side] = cells.value;
    pose.force_deviation_N[side] = cells.deviation;
  }
  return pose;
}

template <class Values>
std::string list(const Values& values, double factor, int digits) {
  std::string text;
  for (const double value : values) {
    text += fmt::format("{}{:.{}f}", text.empty() ? "" : ", ", value * factor, digits);
  }
  return "[" + text + "]";
}

template <class Values>
std::string pair_text(const Values& values, const Values& deviations, double factor, int digits) {
  return fmt::format("{{value: {}, deviation: {}}}\n", list(values, factor, digits),
                     list(deviations, factor, digits));
}

std::string pose_text(const StandingMeasurement& pose, const urdf::RobotModel& robot) {
  std::string text =
      fmt::format("  - name: {}\n    stands: {}\n    placement: {}\n    joints_deg:\n", pose.pose,
                  pose.stands[0] && pose.stands[1] ? "both"
                  : pose.stands[0]                 ? "left"
                                                   : "right",
                  pose.placement);
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    text += fmt::format("      {}: {:.5f}\n", robot.joints[j].name, pose.joint_rad[j] * facts::kDegreePerRad);
  }
  text += "    specific_force_m_per_s2: " +
          pair_text(pose.specific_force_m_per_s2, pose.specific_force_deviation_m_per_s2, 1.0, 7);
  if (pose.inclination_rad) {
    text += "    inclination_deg: " +
            pair_text(*pose.inclination_rad, pose.inclination_deviation_rad, facts::kDegreePerRad, 7);
  }
  text += "    left_cells_N: " + pair_text(pose.force_N[0], pose.force_deviation_N[0], 1.0, 6);
  return text + "    right_cells_N: " + pair_text(pose.force_N[1], pose.force_deviation_N[1], 1.0, 6);
}

}  // namespace

MeasurementFile read_measurements(const std::filesystem::path& file, const urdf::RobotModel& robot) {
  const YamlValue top = YamlValue::read(file);
  top.require_map(Keys{"robot", "weighed", "poses"});
  const YamlValue name = top.at("robot");
  if (name.text() != robot.name) {
    name.refuse(fmt::format("the description's robot is '{}'", robot.name),
                "Name the description's folder with --robot.");
  }
  MeasurementFile result;
  if (const auto weighed = top.find("weighed")) {
    weighed->require_map(Keys{"mass_kg", "deviation_kg"});
    result.weighing =
        Weighing{weighed->at("mass_kg").number(kMass), weighed->at("deviation_kg").number(kMassDeviation)};
  }
  for (const YamlValue& pose : top.at("poses").items()) result.poses.push_back(read_pose(pose, robot));
  return result;
}

std::string measurement_text(const MeasurementFile& measurements, const urdf::RobotModel& robot) {
  std::string text = fmt::format("robot: {}\n", robot.name);
  if (measurements.weighing) {
    text += fmt::format("weighed: {{mass_kg: {:.4f}, deviation_kg: {:.4f}}}\n",
                        measurements.weighing->mass_kg, measurements.weighing->deviation_kg);
  }
  text += "poses:\n";
  for (const StandingMeasurement& pose : measurements.poses) text += pose_text(pose, robot);
  return text;
}

}  // namespace gaitway::calibration
