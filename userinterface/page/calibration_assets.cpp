// calibration.yaml into JSON, beside what of the description it corrects.
#include "gaitway/page/calibration_assets.hpp"

#include <Eigen/Geometry>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "gaitway/urdf/calibration.hpp"

namespace gaitway::page {
namespace {

using Calibration = urdf::Calibration;
using CalibrationJson = nlohmann::ordered_json;

template <std::size_t count>
CalibrationJson calibrated(const std::optional<urdf::Calibrated<count>>& values) {
  if (!values) {
    return nullptr;
  }
  CalibrationJson json{{"value", values->value}, {"deviation", nullptr}};
  if (values->deviation) {
    json["deviation"] = *values->deviation;
  }
  return json;
}

CalibrationJson zeros(const urdf::RobotModel& robot, const std::optional<Calibration>& calibration) {
  CalibrationJson joints = CalibrationJson::array();
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const urdf::Joint& joint = robot.joints[j];
    joints.push_back(
        {{"name", joint.name},
         {"zero", calibration ? calibrated(calibration->zero_rad[j]) : CalibrationJson()},
         {"encoder_step", joint.encoder_count_rad},
         {"trim_channel", joint.trim_channel < 0 ? CalibrationJson() : CalibrationJson(joint.trim_channel)}});
  }
  return joints;
}

CalibrationJson foot(const urdf::RobotModel& robot, const std::optional<Calibration>& calibration,
                     urdf::Side side) {
  static constexpr std::array<const char*, 3> kSensors{"cells", "six_axis", "none"};
  const std::size_t index = urdf::index_of(side);
  const bool gains = calibration && calibration->cell_gain;
  return {{"side", side == urdf::Side::left ? "left" : "right"},
          {"sensor", kSensors[static_cast<std::size_t>(robot.feet[index].sensor)]},
          {"gain", gains ? calibrated(std::optional((*calibration->cell_gain)[index])) : CalibrationJson()}};
}

CalibrationJson imu(const urdf::RobotModel& robot) {
  const Eigen::Vector3d place_m = robot.imu.pose.translation();
  const Eigen::Quaterniond turn(robot.imu.pose.linear());
  return {{"link", robot.links[static_cast<std::size_t>(robot.imu.link)].name},
          {"place", std::array{place_m.x(), place_m.y(), place_m.z()}},
          {"turn", std::array{turn.x(), turn.y(), turn.z(), turn.w()}}};
}

}  // namespace

void add_calibration(AssetTable& table, const urdf::RobotModel& robot) {
  const std::optional<Calibration> calibration = urdf::read_calibration(robot);
  CalibrationJson json{
      {"there", calibration.has_value()},
      {"made",
       calibration && !calibration->made.empty() ? CalibrationJson(calibration->made) : CalibrationJson()},
      {"joints", zeros(robot, calibration)},
      {"trunk_com_offset", calibration ? calibrated(calibration->trunk_com_offset_m) : CalibrationJson()},
      {"feet", {foot(robot, calibration, urdf::Side::left), foot(robot, calibration, urdf::Side::right)}},
      {"imu", imu(robot)}};
  table.add("/calibration.json", "application/json", json.dump(), true);
}

}  // namespace gaitway::page
