// Reads a calibration strictly: values that no calibration gives are refused.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <iterator>
#include <string_view>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/tilt.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"
#include "gaitway/urdf/calibration.hpp"
#include "robot_files.hpp"

namespace gaitway::urdf {
namespace {

using Keys = std::vector<std::string_view>;

using facts::kRadPerDegree;
constexpr input::Range kZero_deg{-20.0, 20.0, "deg"};
constexpr input::Range kImuTilt_deg{-20.0, 20.0, "deg"};
constexpr input::Range kComOffset_m{-0.1, 0.1, "m"};
constexpr input::Range kGain{0.5, 2.0, ""};
constexpr input::Range kDeviation{0.0, 1000.0, ""};

// Deviations are for people; nothing is reckoned with them.
template <std::size_t count>
Calibrated<count> values_with_deviation(const input::YamlValue& map, const input::Range& range) {
  map.require_map(Keys{"value", "deviation"});
  Calibrated<count> values;
  if (const auto deviation = map.find("deviation")) values.deviation = deviation->numbers<count>(kDeviation);
  values.value = map.at("value").numbers<count>(range);
  return values;
}

Calibrated<1> zero_of(const input::YamlValue& map) {
  map.require_map(Keys{"value", "deviation"});
  Calibrated<1> zero_rad;
  if (const auto deviation = map.find("deviation")) {
    zero_rad.deviation = std::array{deviation->number(kDeviation) * kRadPerDegree};
  }
  zero_rad.value = {map.at("value").number(kZero_deg) * kRadPerDegree};
  return zero_rad;
}

void read_joint_zeros(const input::YamlValue& map, const RobotModel& model, Calibration& calibration) {
  std::vector<std::string> known;
  std::transform(model.joints.begin(), model.joints.end(), std::back_inserter(known),
                 [](const Joint& joint) { return joint.name; });
  for (const auto& [name, value] : map.entries()) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      value.refuse(fmt::format("the robot '{}' has no joint '{}'", model.name, name),
                   input::suggest(name, known));
    }
    calibration.zero_rad[static_cast<std::size_t>(found - known.begin())] = zero_of(value);
  }
}

std::optional<Calibrated<2>> tilt_of(const input::YamlValue& map, std::string_view sensor) {
  const auto tilt_deg = map.find(sensor);
  if (!tilt_deg) return std::nullopt;
  Calibrated<2> tilt_rad = values_with_deviation<2>(*tilt_deg, kImuTilt_deg);
  for (double& angle : tilt_rad.value) angle *= kRadPerDegree;
  if (tilt_rad.deviation) {
    for (double& angle : *tilt_rad.deviation) angle *= kRadPerDegree;
  }
  return tilt_rad;
}

ImuTilts imu_tilts(const input::YamlValue& map, const RobotModel& model) {
  map.require_map(Keys{"gyro", "accelerometer", "inclinometer"});
  ImuTilts tilts{tilt_of(map, "gyro"), tilt_of(map, "accelerometer"), tilt_of(map, "inclinometer")};
  if (tilts.inclinometer_rad && !model.carries(SensorKind::inclination)) {
    map.at("inclinometer")
        .refuse(fmt::format("the robot '{}' has no inclinometer", model.name), "Leave this key out.");
  }
  return tilts;
}

// The least turn of what a sensor says by which it says upright where it says this tilt.
Eigen::Matrix3d levelled(const std::optional<Calibrated<2>>& tilt_rad) {
  if (!tilt_rad) return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d up = geometry::up_at_tilt(Eigen::Vector2d(tilt_rad->value.data()));
  return Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

// A number of exactly so many digits at the text's beginning, which is taken off; -1: there is none.
int take_digits(std::string_view& text, std::size_t digits) {
  int number = -1;
  const char* const end = text.data() + std::min(digits, text.size());
  const bool all =
      text.size() >= digits && std::all_of(text.data(), end, [](char c) { return c >= '0' && c <= '9'; });
  if (all) {
    std::from_chars(text.data(), end, number);
    text.remove_prefix(digits);
  }
  return number;
}

bool take(std::string_view& text, char letter) {
  const bool there = text.starts_with(letter);
  text.remove_prefix(there ? 1 : 0);
  return there;
}

bool is_date(std::string_view text) {
  constexpr int kFirstYear = 2000, kHours = 24, kSixty = 60;
  const int year = take_digits(text, 4);
  bool holds = year >= kFirstYear && take(text, '-');
  const int month = take_digits(text, 2);
  holds = holds && month >= 0 && take(text, '-');
  const int day = take_digits(text, 2);
  using namespace std::chrono;
  holds = holds && day >= 0 &&
          year_month_day(std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                         std::chrono::day(static_cast<unsigned>(day)))
              .ok();
  if (!holds || text.empty()) {
    return holds;
  }
  holds = take(text, 'T');
  const int hour = take_digits(text, 2);
  holds = holds && take(text, ':');
  const int minute = take_digits(text, 2);
  holds = holds && take(text, ':');
  const int second = take_digits(text, 2);
  return holds && take(text, 'Z') && text.empty() && hour >= 0 && hour < kHours && minute >= 0 &&
         minute < kSixty && second >= 0 && second < kSixty;
}

std::string date_of(const input::YamlValue& value) {
  std::string text = value.text();
  if (!is_date(text)) {
    value.refuse(
        fmt::format(
            "'{}' is no date: a day that there is, from 2000 on, as YYYY-MM-DD, or with a time of UTC "
            "as YYYY-MM-DDTHH:MM:SSZ",
            text),
        "Write when the calibration was made, such as 2026-11-25T03:21:29Z, or leave the line out.");
  }
  return text;
}

void set_gains(Side side, const std::array<double, Calibration::kCells>& gains, RobotModel& model) {
  for (auto& pair : model.channels) {
    for (SensorChannel& channel : pair) {
      if (channel.kind == SensorKind::force_cell && channel.side == side) {
        channel.gain = gains[static_cast<std::size_t>(channel.index)];
      }
    }
  }
}

Calibration read_file(const std::filesystem::path& file, const RobotModel& model) {
  const input::YamlValue top = input::YamlValue::read(file);
  top.require_map(
      Keys{"robot", "made", "joint_zeros_deg", "trunk_com_offset_m", "force_cell_gains", "imu_tilts_deg"});
  const input::YamlValue robot = top.at("robot");
  if (robot.text() != model.name) {
    robot.refuse(fmt::format("the robot in this folder is '{}'", model.name),
                 "Calibrate this robot (gaitway calibrate), or remove the file.");
  }
  Calibration calibration;
  calibration.zero_rad.resize(model.joints.size());
  if (const auto made = top.find("made")) calibration.made = date_of(*made);
  if (const auto zeros = top.find("joint_zeros_deg")) read_joint_zeros(*zeros, model, calibration);
  if (const auto offset = top.find("trunk_com_offset_m")) {
    calibration.trunk_com_offset_m = values_with_deviation<3>(*offset, kComOffset_m);
  }
  if (const auto gains = top.find("force_cell_gains")) {
    gains->require_map(Keys{"left", "right"});
    calibration.cell_gain = {values_with_deviation<Calibration::kCells>(gains->at("left"), kGain),
                             values_with_deviation<Calibration::kCells>(gains->at("right"), kGain)};
  }
  if (const auto tilts = top.find("imu_tilts_deg")) calibration.imu_tilt = imu_tilts(*tilts, model);
  return calibration;
}

}  // namespace

std::optional<Calibration> read_calibration(const RobotModel& model) {
  const std::filesystem::path file = model.directory / "calibration.yaml";
  return std::filesystem::exists(file) ? std::optional(read_file(file, model)) : std::nullopt;
}

void apply_calibration_file(const std::filesystem::path& file, RobotModel& model) {
  const Calibration calibration = read_file(file, model);
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    if (const auto& zero_rad = calibration.zero_rad[j]) model.joints[j].encoder_zero_rad = zero_rad->value[0];
  }
  if (const auto& offset_m = calibration.trunk_com_offset_m) {
    model.trunk_com_offset_m = Eigen::Vector3d(offset_m->value.data());
    model.links[static_cast<std::size_t>(model.imu.link)].com_m += model.trunk_com_offset_m;
  }
  if (const auto& gains = calibration.cell_gain) {
    for (const Side side : kSides) set_gains(side, (*gains)[index_of(side)].value, model);
  }
  model.imu.levelling = {.gyro = levelled(calibration.imu_tilt.gyro_rad),
                         .accelerometer = levelled(calibration.imu_tilt.accelerometer_rad),
                         .inclinometer = levelled(calibration.imu_tilt.inclinometer_rad)};
}

}  // namespace gaitway::urdf
