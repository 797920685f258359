// Recordings of the robot API: what is stamped with a slot's time goes into that slot's row.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "gaitway/api/cdr_codec.hpp"
#include "gaitway/api/mcap_reader.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/api/ros_messages.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "tools/simulate/measured_feet.hpp"
#include "tools/simulate/trajectory_source.hpp"

namespace gaitway::tools {
namespace {

using api::Topic;
using kinematic::ZmpSource;

constexpr int kRecordedHalfWindow = 5;
constexpr std::int64_t kLongestGap_slots = 50;  // half a second: then it is another trajectory

struct Row {
  std::vector<double> angle_rad;
  std::optional<Eigen::Isometry3d> base;
  std::optional<Eigen::Vector2d> planned_m, cells_m;
  std::array<std::optional<double>, 2> force_N;  // [Side]
};

class RecordingReader {
 public:
  RecordingReader(const urdf::RobotModel& robot, const std::filesystem::path& file)
      : robot_(robot), file_(file), feet_(robot) {}

  kinematic::Trajectory read() {
    const bool complete = api::read_mcap(file_, [this](const api::McapMessage& message) { take(message); });
    kinematic::Trajectory trajectory{
        .name = file_.filename().string(), .kind = "recording", .joint_count = robot_.joints.size()};
    trajectory.half_window = kRecordedHalfWindow;
    trajectory.rounding_counts = 0.5;
    trajectory.measured = true;
    trajectory.place_error_m = place_error_m(robot_);
    fill(trajectory);
    if (!complete) trajectory.notes.emplace_back("the recording has no end: it was cut off");
    return trajectory;
  }

 private:
  [[noreturn]] void refuse(const std::string& field, const std::string& value,
                           const std::string& rule) const {
    input::refuse({.file = file_, .line = 0, .field = field, .value = value, .rule = rule, .remedy = {}});
  }
  Row& row_of(const api::ros::Time& stamp) {
    const std::int64_t ns = std::int64_t{stamp.sec} * facts::kSecond_ns + stamp.nanosec;
    return rows_[(ns + facts::kSlot_ns / 2) / facts::kSlot_ns];
  }
  template <class Message>
  [[nodiscard]] Message decoded(const api::McapMessage& message) const {
    try {
      return api::read_cdr<Message>(message.data);
    } catch (const std::invalid_argument& error) {
      refuse(std::string(message.topic),
             fmt::format("{} bytes at {} ns", message.data.size(), message.log_ns), error.what());
    }
  }
  void take(const api::McapMessage& message) {
    const auto is = [&message](Topic topic) {
      return message.topic == api::row(topic).name && message.type == api::row(topic).type;
    };
    if (is(Topic::joint_states)) {
      take_joints(decoded<api::ros::JointState>(message));
    } else if (is(Topic::odometry)) {
      take_base(decoded<api::ros::Odometry>(message));
    } else if (is(Topic::zmp)) {
      const auto point = decoded<api::ros::PointStamped>(message);
      row_of(point.header.stamp).cells_m = Eigen::Vector2d(point.point.x, point.point.y);
    } else if (is(Topic::reference_zmp)) {
      const auto point = decoded<api::ros::PointStamped>(message);
      row_of(point.header.stamp).planned_m = Eigen::Vector2d(point.point.x, point.point.y);
    } else if (is(Topic::left_wrench) || is(Topic::right_wrench)) {
      const auto wrench = decoded<api::ros::WrenchStamped>(message);
      row_of(wrench.header.stamp).force_N[is(Topic::left_wrench) ? 0 : 1] = wrench.wrench.force.z;
    }
  }
  void take_joints(const api::ros::JointState& joints) {
    if (joints.position.size() != joints.name.size())
      refuse("/joint_states", fmt::format("{} positions", joints.position.size()),
             "must have one for each name");
    std::vector<double> angles(robot_.joints.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < joints.name.size(); ++i)
      angles[static_cast<std::size_t>(robot_.joint_index(joints.name[i]))] = joints.position[i];
    bool whole = true;
    for (const double angle : angles) whole = whole && std::isfinite(angle);
    if (whole) row_of(joints.header.stamp).angle_rad = std::move(angles);  // else a gap, as one that is lost
  }
  void take_base(const api::ros::Odometry& odometry) {
    const auto& pose = odometry.pose.pose;
    const auto& turn = pose.orientation;
    Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
    base.linear() = Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z).normalized().toRotationMatrix();
    base.translation() << pose.position.x, pose.position.y, pose.position.z;
    if (base.matrix().allFinite()) row_of(odometry.header.stamp).base = base;
  }

  void fill(kinematic::Trajectory& trajectory);
  // Between the last row and this one, evenly.
  void fill_gap(std::int64_t gap, const Row& last, const Row& row, kinematic::Trajectory& trajectory);
  void append(const Row& row, kinematic::Trajectory& trajectory);

  const urdf::RobotModel& robot_;
  std::filesystem::path file_;
  std::map<std::int64_t, Row> rows_;  // by slot
  bool has_base_ = true, has_forces_ = true;
  std::size_t filled_ = 0;
  MeasuredFeet feet_;
};

void RecordingReader::append(const Row& row, kinematic::Trajectory& trajectory) {
  trajectory.joint_rad.insert(trajectory.joint_rad.end(), row.angle_rad.begin(), row.angle_rad.end());
  const Eigen::Vector2d unknown = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  trajectory.zmp[kinematic::index_of(ZmpSource::planned)].push_back(row.planned_m.value_or(unknown));
  trajectory.zmp[kinematic::index_of(ZmpSource::cells)].push_back(row.cells_m.value_or(unknown));
  if (has_base_) trajectory.base.push_back(*row.base);
  if (!has_forces_) return;
  trajectory.contact.push_back(feet_.contact({*row.force_N[0], *row.force_N[1]}));
}

void RecordingReader::fill_gap(std::int64_t gap, const Row& last, const Row& row,
                               kinematic::Trajectory& trajectory) {
  for (std::int64_t k = 1; k < gap; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(gap);
    Row between = last;
    for (std::size_t j = 0; j < between.angle_rad.size(); ++j)
      between.angle_rad[j] += share * (row.angle_rad[j] - last.angle_rad[j]);
    if (has_base_) {
      between.base->translation() += share * (row.base->translation() - last.base->translation());
      between.base->linear() = Eigen::Quaterniond(last.base->linear())
                                   .slerp(share, Eigen::Quaterniond(row.base->linear()))
                                   .toRotationMatrix();
    }
    append(between, trajectory);
    ++filled_;
  }
}

void RecordingReader::fill(kinematic::Trajectory& trajectory) {
  std::erase_if(rows_, [](const auto& row) { return row.second.angle_rad.empty(); });
  if (rows_.empty()) refuse("/joint_states", "no whole message", "must be in the recording");
  for (const auto& [slot, row] : rows_) {
    has_base_ = has_base_ && row.base;
    has_forces_ = has_forces_ && row.force_N[0] && row.force_N[1];
  }
  has_forces_ = has_forces_ && robot_.senses_load();
  trajectory.start_s = static_cast<double>(rows_.begin()->first) * facts::kSlot_s;
  const Row* last = nullptr;
  std::int64_t last_slot = 0;
  for (const auto& [slot, row] : rows_) {
    if (last != nullptr) {
      if (slot - last_slot > kLongestGap_slots) {
        refuse("/joint_states",
               fmt::format("none from {:.2f} to {:.2f} s", static_cast<double>(last_slot) * facts::kSlot_s,
                           static_cast<double>(slot) * facts::kSlot_s),
               "must not stay out for more than half a second");
      }
      fill_gap(slot - last_slot, *last, row, trajectory);
    }
    append(row, trajectory);
    last = &row;
    last_slot = slot;
  }
  if (filled_ > 0)
    trajectory.notes.push_back(
        fmt::format("{} of {} rows are not in the recording: drawn between their neighbours", filled_,
                    trajectory.rows()));
  if (!has_base_)
    trajectory.notes.emplace_back("/odom is not in each row: the feet that stand carry the base");
}

}  // namespace

kinematic::Trajectory read_recording(const urdf::RobotModel& robot, const std::filesystem::path& file) {
  return RecordingReader(robot, file).read();
}

}  // namespace gaitway::tools
