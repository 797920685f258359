// Rows of a CSV file by the names of their columns: states.csv of a run, or the points of `gaitway motion
// plan`.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/motion/stance_map.hpp"
#include "tools/simulate/measured_feet.hpp"
#include "tools/simulate/trajectory_source.hpp"

namespace gaitway::tools {
namespace {

using kinematic::Trajectory;
using kinematic::ZmpSource;

constexpr int kMeasuredHalfWindow = 5;  // rows: 50 ms either way
constexpr double kOffBeat_s = 0.001;    // by which a row's time may be off its slot

class CsvTable {
 public:
  explicit CsvTable(const std::filesystem::path& file) : file_(file), in_(file) {
    std::string header;
    if (!in_ || !std::getline(in_, header)) refuse(1, "", "", "must be a CSV file with a header line");
    for (const std::string_view name : split(header)) columns_.emplace(name, columns_.size());
  }
  // A row's fields are in fields() then. False: there is none left.
  bool next() {
    if (!std::getline(in_, row_)) return false;
    ++line_;
    fields_ = split(row_);
    if (fields_.size() != columns_.size()) {
      refuse(line_, "row", fmt::format("{} fields", fields_.size()),
             fmt::format("must have the header's {}", columns_.size()));
    }
    return true;
  }
  [[nodiscard]] bool has(const std::string& name) const { return columns_.contains(name); }
  [[nodiscard]] std::size_t column(const std::string& name, const std::string& remedy = {}) const {
    const auto found = columns_.find(name);
    if (found == columns_.end()) refuse(1, "column", name, "is missing", remedy);
    return found->second;
  }
  [[nodiscard]] std::string_view text(std::size_t column) const { return fields_[column]; }
  [[nodiscard]] double number(std::size_t column, bool may_be_unknown = false) const {
    const std::string_view text = fields_[column];
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (!whole || (!std::isfinite(value) && !may_be_unknown))
      refuse(line_, name_of(column), std::string(text), "must be a finite number");
    return value;
  }
  [[nodiscard]] int line() const noexcept { return line_; }
  [[noreturn]] void refuse(int line, const std::string& field, const std::string& value,
                           const std::string& rule, const std::string& remedy = {}) const {
    input::refuse(
        {.file = file_, .line = line, .field = field, .value = value, .rule = rule, .remedy = remedy});
  }

 private:
  static std::vector<std::string_view> split(std::string_view text) {
    std::vector<std::string_view> fields;
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      fields.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
    return fields;
  }
  [[nodiscard]] std::string name_of(std::size_t column) const {
    const auto found =
        std::ranges::find_if(columns_, [column](const auto& one) { return one.second == column; });
    return found->first;
  }

  std::filesystem::path file_;
  std::ifstream in_;
  std::map<std::string, std::size_t, std::less<>> columns_;
  std::string row_;
  std::vector<std::string_view> fields_;
  int line_ = 1;
};

// One column for each joint, "NAME" + `ending`.
std::vector<std::size_t> joint_columns(const CsvTable& table, const urdf::RobotModel& robot,
                                       const std::string& ending) {
  std::vector<std::size_t> columns;
  for (const urdf::Joint& joint : robot.joints) {
    columns.push_back(
        table.column(joint.name + ending, fmt::format("The robot is '{}': give another --robot, "
                                                      "or a file of this one",
                                                      robot.name)));
  }
  return columns;
}

// Rows are a time slot apart.
void take_time(const CsvTable& table, std::size_t column, std::size_t row, Trajectory& trajectory) {
  const double time_s = table.number(column);
  if (row == 0) trajectory.start_s = time_s;
  if (std::abs(time_s - trajectory.time_s(row)) > kOffBeat_s) {
    table.refuse(table.line(), "time_s", fmt::format("{}", time_s),
                 fmt::format("must be {:.3f}: rows are {} s apart", trajectory.time_s(row), facts::kSlot_s));
  }
}

void take_angles(const CsvTable& table, const std::vector<std::size_t>& columns,
                 std::vector<double>& angles) {
  for (const std::size_t column : columns) angles.push_back(table.number(column));
}

Trajectory read_points(CsvTable table, const urdf::RobotModel& robot) {
  Trajectory trajectory{.name = "", .kind = "points of a motion", .joint_count = robot.joints.size()};
  trajectory.points_of_wire = true;
  const std::size_t time = table.column("time_s"), contact = table.column("contact");
  const auto angles = joint_columns(table, robot, "_rad");
  std::vector<std::size_t> references;
  if (table.has(robot.joints[0].name + "_reference_rad"))
    references = joint_columns(table, robot, "_reference_rad");
  for (std::size_t row = 0; table.next(); ++row) {
    take_time(table, time, row, trajectory);
    take_angles(table, angles, trajectory.joint_rad);
    take_angles(table, references, trajectory.reference_rad);
    const auto name = std::ranges::find(motion::kContactNames, table.text(contact));
    if (name == motion::kContactNames.end()) {
      table.refuse(table.line(), "contact", std::string(table.text(contact)),
                   "must be both, left, right or none");
    }
    trajectory.contact.push_back(static_cast<motion::Contact>(name - motion::kContactNames.begin()));
  }
  return trajectory;
}

class RunReader {
 public:
  RunReader(CsvTable table, const urdf::RobotModel& robot)
      : table_(std::move(table)), robot_(robot), feet_(robot) {}

  Trajectory read() {
    Trajectory trajectory{.name = "", .kind = "run", .joint_count = robot_.joints.size()};
    trajectory.half_window = kMeasuredHalfWindow;
    trajectory.rounding_counts = 0.5;
    trajectory.measured = true;
    trajectory.place_error_m = place_error_m(robot_);
    find_columns();
    for (std::size_t row = 0; table_.next(); ++row) {
      take_time(table_, time_, row, trajectory);
      take_angles(table_, angles_, trajectory.joint_rad);
      if (robot_.senses_load()) trajectory.contact.push_back(contact());
      trajectory.base.push_back(base());
      for (std::size_t i = 0; i < zmp_.size(); ++i) {
        const auto [source, x, y] = zmp_[i];
        trajectory.zmp[kinematic::index_of(source)].emplace_back(table_.number(x, true),
                                                                 table_.number(y, true));
      }
    }
    trajectory.notes.emplace_back("the floor is taken as level, whatever the run's world was");
    return trajectory;
  }

 private:
  void find_columns() {
    time_ = table_.column("time_s");
    angles_ = joint_columns(table_, robot_, "_position_rad");
    for (const char* const name :
         {"base_x_m", "base_y_m", "base_z_m", "base_roll_rad", "base_pitch_rad", "base_yaw_rad"})
      base_.push_back(table_.column(name));
    for (const auto& [source, name] : {std::pair{ZmpSource::planned, std::string("reference_zmp")},
                                       {ZmpSource::cells, "measured_zmp"},
                                       {ZmpSource::solver, "cop"}})
      zmp_.push_back({source, table_.column(name + "_x_m"), table_.column(name + "_y_m")});
    for (const std::string side : {"left", "right"}) {
      for (const char* const cell : {"front_left", "front_right", "rear_left", "rear_right"})
        cells_.push_back(table_.column(fmt::format("{}_foot_force_{}_N", side, cell)));
    }
  }
  [[nodiscard]] motion::Contact contact() {
    std::array<double, 2> force_N{};
    for (std::size_t i = 0; i < cells_.size(); ++i) force_N[i / 4] += table_.number(cells_[i]);
    return feet_.contact(force_N);
  }
  [[nodiscard]] Eigen::Isometry3d base() const {
    const auto at = [this](std::size_t i) { return table_.number(base_[i]); };
    Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
    base.linear() = motion::rotation_of({at(3), at(4), at(5)});
    base.translation() = Eigen::Vector3d(at(0), at(1), at(2));
    return base;
  }

  struct ZmpColumns {
    ZmpSource source;
    std::size_t x, y;
  };
  CsvTable table_;
  const urdf::RobotModel& robot_;
  MeasuredFeet feet_;
  std::size_t time_ = 0;
  std::vector<std::size_t> angles_, base_, cells_;
  std::vector<ZmpColumns> zmp_;
};

}  // namespace

Trajectory read_csv_trajectory(const urdf::RobotModel& robot, const std::filesystem::path& file) {
  CsvTable table(file);
  const bool run = table.has("base_x_m");
  if (!run && !table.has("contact")) {
    table.refuse(1, "column", "contact", "is missing, and so is base_x_m",
                 "Give states.csv of `gaitway run`, or what `gaitway motion plan --out` writes");
  }
  Trajectory trajectory =
      run ? RunReader(std::move(table), robot).read() : read_points(std::move(table), robot);
  trajectory.name = file.filename() == "states.csv"
                        ? (file.parent_path().filename() / file.filename()).string()
                        : file.filename().string();
  return trajectory;
}

}  // namespace gaitway::tools
