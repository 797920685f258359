// Tables in plain text, and YAML.
#include "tools/calibrate/calibration_report.hpp"
#include "gaitway/facts/facts.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace gaitway::calibration {
namespace {

constexpr double kMm = 1000.0, kPercent = 100.0;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<const char*, kCells> kCellNames{"front left", "front right", "rear left", "rear right"};
constexpr std::array<const char*, kImuSensors.size()> kSensorNames{"gyro", "accelerometer", "inclinometer"};

Estimate scaled(const Estimate& estimate, double factor, double from = 0.0) {
  return {factor * (estimate.value - from), factor * estimate.deviation, factor * estimate.prior_deviation};
}

bool is_told(const Estimate& estimate) {
  return estimate.learned() >= kToldShare;
}

std::span<const ImuSensor> sensors_of(const urdf::RobotModel& robot) {
  return std::span(kImuSensors).first(robot.carries(urdf::SensorKind::inclination) ? 3 : 2);
}

bool is_of_a_leg(const urdf::RobotModel& robot, std::size_t joint) {
  return std::ranges::any_of(robot.legs, [joint](const urdf::Leg& leg) {
    return std::ranges::find(leg.joints, static_cast<int>(joint)) != leg.joints.end();
  });
}

ReportSection zero_section(const urdf::RobotModel& robot, const Calibration& calibration,
                           const RobotDeviations* truth, bool of_legs) {
  ReportSection section{of_legs ? "Joint zeros: legs" : "Joint zeros: others", {}};
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    if (is_of_a_leg(robot, j) != of_legs) continue;
    section.rows.push_back({robot.joints[j].name, "deg",
                            scaled(calibration.zero_rad[j], facts::kDegreePerRad),
                            truth != nullptr ? facts::kDegreePerRad * truth->zero_rad[j] : kUnknown});
  }
  return section;
}

ReportSection trunk_section(const Calibration& calibration, const RobotDeviations* truth) {
  constexpr std::array kAxes{"ahead", "to the left", "up"};
  ReportSection section{"Trunk's centre of mass", {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    section.rows.push_back(
        {kAxes[axis], "mm", scaled(calibration.trunk_com_m[axis], kMm),
         truth != nullptr ? kMm * truth->trunk_com_offset_m[static_cast<Eigen::Index>(axis)] : kUnknown});
  }
  return section;
}

ReportSection cell_section(const Calibration& calibration, const RobotDeviations* truth) {
  ReportSection section{"Force cells: gain beyond 1", {}};
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      section.rows.push_back({fmt::format("{} foot, {}", side == 0 ? "left" : "right", kCellNames[cell]), "%",
                              scaled(calibration.cell_gain[side][cell], kPercent, 1.0),
                              truth != nullptr ? kPercent * (truth->cell_gain[side][cell] - 1.0) : kUnknown});
    }
  }
  return section;
}

ReportSection imu_section(const urdf::RobotModel& robot, const Calibration& calibration,
                          const RobotDeviations* truth) {
  constexpr std::array kAxes{"roll", "pitch"};
  ReportSection section{"IMU: what it says of an upright trunk", {}};
  for (const ImuSensor sensor : sensors_of(robot)) {
    const auto index = static_cast<std::size_t>(sensor);
    const Eigen::Vector2d real = truth != nullptr
                                     ? tilt_said(sensor, robot.imu, truth->imu, Eigen::Vector3d::UnitZ())
                                     : Eigen::Vector2d::Constant(kUnknown);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      section.rows.push_back({fmt::format("{}, {}", kSensorNames[index], kAxes[axis]), "deg",
                              scaled(calibration.imu_tilt_rad[index][axis], facts::kDegreePerRad),
                              facts::kDegreePerRad * real[static_cast<Eigen::Index>(axis)]});
    }
  }
  return section;
}

ReportSection posture_section(const urdf::RobotModel& robot, const Calibration& calibration,
                              const RobotDeviations* truth) {
  ReportSection section{"What it adds up to in the standing posture", {}};
  std::vector<double> real(calibration.posture.size(), kUnknown);
  if (truth != nullptr) real = posture_errors(robot, *truth);
  for (std::size_t i = 0; i < calibration.posture.size(); ++i) {
    const PostureError& error = calibration.posture[i];
    const bool is_length = error.unit == "m";
    const double factor = is_length ? kMm : facts::kDegreePerRad;
    section.rows.push_back(
        {error.name, is_length ? "mm" : "deg", scaled(error.estimate, factor), factor * real[i]});
  }
  return section;
}

std::string row_text(const ReportRow& row) {
  std::string text =
      fmt::format("  {:<38}{:>9.3f} ± {:<6.3f} {:<4}{:>5.0f} %", row.name, row.estimate.value,
                  row.estimate.deviation, row.unit, kPercent * std::max(0.0, row.estimate.learned()));
  if (!std::isnan(row.truth)) {
    const double error = row.estimate.value - row.truth;
    text += fmt::format("{:>10.3f}{:>9.3f}{:>7.1f}", row.truth, error, error / row.estimate.deviation);
  }
  return text + (is_told(row.estimate) ? "\n" : "  the poses cannot tell\n");
}

template <class Values>
std::string numbers(const Values& estimates, double Estimate::*member) {
  std::string text;
  for (const Estimate& estimate : estimates) {
    text += fmt::format("{}{:.5f}", text.empty() ? "" : ", ", estimate.*member);
  }
  return "[" + text + "]";
}

template <class Values>
std::string pair_text(const Values& estimates) {
  return fmt::format("{{value: {}, deviation: {}}}", numbers(estimates, &Estimate::value),
                     numbers(estimates, &Estimate::deviation));
}

}  // namespace

std::vector<ReportSection> report_sections(const urdf::RobotModel& robot, const Calibration& calibration,
                                           const RobotDeviations* truth) {
  return {zero_section(robot, calibration, truth, true),
          zero_section(robot, calibration, truth, false),
          trunk_section(calibration, truth),
          cell_section(calibration, truth),
          imu_section(robot, calibration, truth),
          posture_section(robot, calibration, truth)};
}

std::string report_text(const urdf::RobotModel& robot, const Calibration& calibration,
                        const RobotDeviations* truth) {
  std::string text;
  for (const ReportSection& section : report_sections(robot, calibration, truth)) {
    text += fmt::format("\n{:<40}{:>9}   {:<11}{:>7}{}\n", section.title, "value", "deviation", "learned",
                        truth == nullptr ? "" : "     truth    error  in dev.");
    for (const ReportRow& row : section.rows) text += row_text(row);
  }
  text += fmt::format("\nMass {:.3f} ± {:.3f} kg. Unexplained: {:.2f} of what noise explains.\n",
                      calibration.mass_kg.value, calibration.mass_kg.deviation, calibration.misfit);
  if (calibration.feet_on_edge > 0) {
    text +=
        fmt::format("{} times a foot stood near its edge: calibrate again with these joint zeros in use.\n",
                    calibration.feet_on_edge);
  }
  return text;
}

std::string calibration_text(const urdf::RobotModel& robot, const Calibration& calibration,
                             std::time_t made_s) {
  std::string text = fmt::format(
      "# Found by gaitway calibrate: put it beside robot.yaml, and everything uses it. Standard deviations "
      "are "
      "for people.\nrobot: {}\nmade: {:%Y-%m-%dT%H:%M:%SZ}\njoint_zeros_deg:  # what an encoder says where "
      "its joint "
      "is at 0\n",
      robot.name, fmt::gmtime(made_s));
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Estimate& zero = calibration.zero_rad[j];
    if (zero.learned() < kHeardShare) continue;
    text += fmt::format("  {}: {{value: {:.4f}, deviation: {:.4f}}}\n", robot.joints[j].name,
                        facts::kDegreePerRad * zero.value, facts::kDegreePerRad * zero.deviation);
  }
  text += "imu_tilts_deg:  # roll, pitch that each sensor says of an upright trunk\n";
  for (const ImuSensor sensor : sensors_of(robot)) {
    const auto index = static_cast<std::size_t>(sensor);
    std::array<Estimate, 2> tilt_deg;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      tilt_deg[axis] = scaled(calibration.imu_tilt_rad[index][axis], facts::kDegreePerRad);
    }
    text += fmt::format("  {}: {}\n", kSensorNames[index], pair_text(tilt_deg));
  }
  return text + fmt::format(
                    "trunk_com_offset_m: {}\nforce_cell_gains:  # front left, front right, rear left, rear "
                    "right\n  left: {}\n  right: {}\n",
                    pair_text(calibration.trunk_com_m), pair_text(calibration.cell_gain[0]),
                    pair_text(calibration.cell_gain[1]));
}

void CalibrationStatistics::add(const urdf::RobotModel& robot, const SimulatedCalibration& simulated) {
  const auto sections = report_sections(robot, simulated.calibration, &simulated.truth);
  sums_.resize(sections.size());
  ++robots_;
  for (std::size_t s = 0; s < sections.size(); ++s) {
    sums_[s].title = sections[s].title;
    sums_[s].rows.resize(sections[s].rows.size());
    for (std::size_t r = 0; r < sections[s].rows.size(); ++r) {
      const ReportRow& row = sections[s].rows[r];
      Row& sum = sums_[s].rows[r];
      const double error = row.estimate.value - row.truth;
      sum.name = row.name;
      sum.unit = row.unit;
      sum.before += row.truth * row.truth;
      sum.after += error * error;
      sum.claimed += row.estimate.deviation * row.estimate.deviation;
      sum.error_in_deviations += error * error / (row.estimate.deviation * row.estimate.deviation);
    }
  }
}

std::vector<CalibrationStatistics::Section> CalibrationStatistics::sections() const {
  std::vector<Section> result = sums_;
  const auto root = [](Row& row, double count) {
    for (double* const value : {&row.before, &row.after, &row.claimed, &row.error_in_deviations}) {
      *value = std::sqrt(*value / count);
    }
  };
  for (Section& section : result) {
    section.all = {"all of them", section.rows.front().unit};
    for (const Row& row : section.rows) {
      section.all.before += row.before;
      section.all.after += row.after;
      section.all.claimed += row.claimed;
      section.all.error_in_deviations += row.error_in_deviations;
      if (row.unit != section.all.unit) section.all.unit = "";
    }
    root(section.all, static_cast<double>(section.rows.size()) * robots_);
    for (Row& row : section.rows) root(row, robots_);
  }
  return result;
}

std::string CalibrationStatistics::text() const {
  const auto line = [](const Row& row) {
    return fmt::format("  {:<38}{:>9.3f}{:>9.3f}{:>9.3f} {:<4}{:>7.2f}\n", row.name, row.before, row.after,
                       row.claimed, row.unit, row.error_in_deviations);
  };
  std::string text;
  for (const Section& section : sections()) {
    text += fmt::format("\n{:<40}{:>9}{:>9}{:>9}     {:>7}\n", section.title, "before", "after", "claimed",
                        "in dev.");
    for (const Row& row : section.rows) text += line(row);
    if (!section.all.unit.empty()) text += line(section.all);
  }
  return text;
}

}  // namespace gaitway::calibration
