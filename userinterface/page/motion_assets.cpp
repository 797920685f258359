// Tables of prepared motions into JSON, thinned out.
#include "gaitway/page/motion_assets.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/trajectory/motion_table.hpp"

namespace gaitway::page {
namespace {

using Json = nlohmann::ordered_json;
using trajectory::MotionTable;

constexpr double kSlot_s = static_cast<double>(facts::kSlot_ns) * 1e-9;  // between two points of a table
constexpr std::size_t kStride =
    std::chrono::nanoseconds(kPreviewPeriod).count() / facts::kSlot_ns;  // points to a posture

// To a tenth of a milliradian, or of a millimetre: what nobody sees is not sent.
double rounded(double value) {
  constexpr double kSteps = 1e4;
  return std::round(value * kSteps) / kSteps;
}

// The start as people say it.
std::string start_of(const MotionTable& motion) {
  if (motion.lies_on) {
    return "lies on its " + std::string(trajectory::name_of(*motion.lies_on));
  }
  return motion.on_ground ? "lies" : "stands";
}

Json posture_of(const MotionTable& motion, const urdf::RobotModel& robot, std::size_t point) {
  const trajectory::MotionPoint& place = motion.path.points[point];
  Json joints = Json::array(), feet = Json::array();
  const std::span<const float> offsets_rad = motion.path.row(point);
  for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
    joints.push_back(rounded(robot.joints[joint].home_rad + static_cast<double>(offsets_rad[joint])));
  }
  for (std::size_t side = 0; side < place.foot_m.size(); ++side) {
    const auto& [x, y, z] = place.foot_m[side];
    feet.push_back({rounded(x), rounded(y), rounded(z), rounded(place.foot_yaw_rad[side])});
  }
  return {{"joints", std::move(joints)}, {"feet", std::move(feet)}, {"support", place.support}};
}

std::string postures_of(const MotionTable& motion, const urdf::RobotModel& robot) {
  Json postures = Json::array();
  for (std::size_t point = 0; point < motion.path.size(); point += kStride) {
    postures.push_back(posture_of(motion, robot, point));
  }
  const auto period_ms = static_cast<double>(kPreviewPeriod.count());
  return Json{{"period", period_ms * 1e-3}, {"postures", std::move(postures)}}.dump();
}

// Empty: it can be shown.
std::string why_not(const MotionTable& motion, const urdf::RobotModel& robot) {
  if (motion.joint_count == robot.joints.size() &&
      motion.robot_digest == trajectory::robot_digest(robot.directory)) {
    return {};
  }
  return "it was prepared for another robot's description: prepare it again with `gaitway motion prepare`";
}

class MotionList {
 public:
  MotionList(AssetTable& table, const urdf::RobotModel& robot) : table_(table), robot_(robot) {}

  void add(const std::filesystem::path& file) {
    try {
      add(trajectory::read_motion_table(file));
    } catch (const trajectory::MotionTableError& error) {
      add({{"name", file.stem().string()}, {"refused", error.what()}});
    }
  }
  void finish() { table_.add("/motions.json", "application/json", list_.dump(), true); }

 private:
  void add(const MotionTable& motion) {
    Json entry{{"name", motion.name},
               {"description", motion.description},
               {"duration", rounded(static_cast<double>(motion.path.size() - 1) * kSlot_s)},
               {"start", start_of(motion)}};
    std::string refused = why_not(motion, robot_);
    std::string postures = refused.empty() ? postures_of(motion, robot_) : std::string{};
    if (postures.size() > kMostPreviewBytes - bytes_) {
      refused = "all motions together are too long for previews";
    }
    if (!refused.empty()) {
      entry["refused"] = refused;
    } else {
      bytes_ += postures.size();
      entry["postures"] = "motion/" + motion.name + ".json";
    }
    if (add(std::move(entry)) && refused.empty()) {
      table_.add("/motion/" + motion.name + ".json", "application/json", std::move(postures), true);
    }
  }
  bool add(Json entry) {
    if (!names_.insert(entry["name"].get<std::string>()).second) {
      return false;
    }
    list_.push_back(std::move(entry));
    return true;
  }

  AssetTable& table_;
  const urdf::RobotModel& robot_;
  Json list_ = Json::array();
  std::set<std::string> names_;
  std::size_t bytes_ = 0;
};

}  // namespace

void add_motions(AssetTable& table, const urdf::RobotModel& robot,
                 std::span<const std::filesystem::path> folders) {
  MotionList list(table, robot);
  for (const std::filesystem::path& folder : folders) {
    for (const std::filesystem::path& file : trajectory::motion_table_files(folder)) {
      list.add(file);
    }
  }
  list.finish();
}

}  // namespace gaitway::page
