// What the other plug-ins want to know of each point, from the points alone.
#include "gaitway/motion/motion_planner.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/body_load.hpp"
#include "gaitway/motion/stance_map.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/motion_table.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/leg_joints.hpp"

namespace gaitway::motion {
namespace {

constexpr auto kPointsOfBatch = static_cast<std::size_t>(kBatchPoints);
constexpr std::size_t kLongestName = 47;

// Whole batches after the first point: it rests at its end for a little longer.
MotionPlan in_whole_batches(const urdf::RobotModel& robot, MotionPlan plan) {
  std::size_t missing = kRestPoints;
  while ((plan.point_count() - 1 + missing) % kPointsOfBatch != 0) ++missing;
  const std::span<const double> row = plan.point(plan.point_count() - 1);
  const std::vector<double> last(row.begin(), row.end());
  for (std::size_t i = 0; i < missing; ++i) {
    plan.joint_rad.insert(plan.joint_rad.end(), last.begin(), last.end());
    plan.contact.push_back(plan.contact.back());
    plan.pelvis.push_back(plan.pelvis.back());
  }
  plan.reference_rad = leading_references(robot, plan);
  return plan;
}

class TableWriter {
 public:
  explicit TableWriter(const urdf::RobotModel& robot) : robot_(robot), kinematics_(robot) {
    for (const urdf::Side side : urdf::kSides) {
      const int hip_pitch = urdf::LegJoints(robot, kinematics_, side)[urdf::LegJoint::hip_pitch];
      hip_link_[urdf::index_of(side)] = robot.joints[static_cast<std::size_t>(hip_pitch)].child_link;
    }
    home_ = standing_point();
    hip_link_height_m_ = hip_link_height_m(home_pelvis_);
  }

  trajectory::MotionWay way(const MotionPlan& plan) {
    trajectory::MotionWay way;
    PlanLoads loads(robot_, plan);
    for (std::size_t i = 0; i < plan.point_count(); ++i) {
      trajectory::MotionPoint point = home_;
      point.support = static_cast<std::uint64_t>(trajectory::kNothingStands);
      if (plan.contact[i] != Contact::none) point = standing_point(plan, i, loads);
      way.points.push_back(point);
      const std::span<const double> row = plan.reference(i);
      for (std::size_t j = 0; j < row.size(); ++j) {
        way.offset_rad.push_back(static_cast<float>(row[j] - robot_.joints[j].home_rad));
      }
    }
    set_velocities(way);
    return way;
  }

 private:
  static std::uint64_t support_of(Contact contact) {
    return contact == Contact::left ? 0 : contact == Contact::right ? 1 : 2;
  }

  // Both feet at home, and where the pelvis is then.
  trajectory::MotionPoint standing_point() {
    const Eigen::Isometry3d left = kinematics_.sole_pose(urdf::Side::left),
                            right = kinematics_.sole_pose(urdf::Side::right);
    home_pelvis_.translation() = -0.5 * (left.translation() + right.translation());
    trajectory::MotionPoint point = posed(home_pelvis_);
    point.zmp_m = point.com_m;
    point.hip_height_m = robot_.hip_height_m;
    return point;
  }

  // Of the posture that the kinematics has computed.
  trajectory::MotionPoint posed(const Eigen::Isometry3d& pelvis) const {
    trajectory::MotionPoint point;
    const Eigen::Vector3d com = pelvis * kinematics_.com_m();
    point.com_m = {com.x(), com.y()};
    const Eigen::Vector3d trunk = attitude_of(pelvis.linear() * kinematics_.link_rotation(robot_.imu.link));
    point.trunk_attitude_rad = {trunk.x(), trunk.y()};
    point.base_yaw_rad = attitude_of(pelvis.linear()).z();
    for (const urdf::Side side : urdf::kSides) {
      const auto s = static_cast<std::size_t>(side);
      const Eigen::Isometry3d sole = pelvis * kinematics_.sole_pose(side);
      point.foot_m[s] = {sole.translation().x(), sole.translation().y(), sole.translation().z()};
      point.foot_yaw_rad[s] = attitude_of(sole.linear()).z();
    }
    return point;
  }

  trajectory::MotionPoint standing_point(const MotionPlan& plan, std::size_t i, PlanLoads& loads) {
    kinematics_.compute(plan.point(i));
    trajectory::MotionPoint point = posed(plan.pelvis[i]);
    point.hip_height_m = robot_.hip_height_m + hip_link_height_m(plan.pelvis[i]) - hip_link_height_m_;
    point.support = support_of(plan.contact[i]);
    const Eigen::Vector2d zmp = loads.at(i).zmp_m;
    point.zmp_m = {zmp.x(), zmp.y()};
    return point;
  }

  // Of the middle between the thighs' upper ends, over the ground.
  double hip_link_height_m(const Eigen::Isometry3d& pelvis) const {
    double sum_m = 0.0;
    for (const int link : hip_link_) sum_m += 0.5 * (pelvis * kinematics_.link_position_m(link)).z();
    return sum_m;
  }

  static void set_velocities(trajectory::MotionWay& way) {
    for (std::size_t i = 0; i < way.size(); ++i) {
      const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, way.size() - 1);
      const double span_s = static_cast<double>(std::max<std::size_t>(after - before, 1)) * facts::kSlot_s;
      for (std::size_t axis = 0; axis < 2; ++axis) {
        way.points[i].com_velocity_m_per_s[axis] =
            (way.points[after].com_m[axis] - way.points[before].com_m[axis]) / span_s;
      }
    }
  }

  const urdf::RobotModel& robot_;
  urdf::ForwardKinematics kinematics_;
  std::array<int, 2> hip_link_{};  // [Side]: the thigh
  Eigen::Isometry3d home_pelvis_ = Eigen::Isometry3d::Identity();
  trajectory::MotionPoint home_;
  double hip_link_height_m_ = 0.0;
};

}  // namespace

PreparedMotion prepare_motion(const urdf::RobotModel& robot, const Motion& motion,
                              const PlannerOptions& options) {
  if (motion.name.size() > kLongestName) {
    throw MotionError(fmt::format("motion '{}': name has {} bytes, but may have {}. Choose a shorter one",
                                  motion.name, motion.name.size(), kLongestName));
  }
  PreparedMotion result;
  result.planned = plan_motion(robot, motion, options);
  const MotionPlan plan = in_whole_batches(robot, result.planned.plan);
  const ExitPlan exits = plan_exits(robot, plan, limits_of(motion, options.limits));
  trajectory::MotionTable& table = result.table;
  table.name = motion.name;
  table.description = motion.description;
  table.robot_digest = trajectory::robot_digest(robot.directory);
  table.joint_count = plan.joint_count;
  table.on_ground = motion.starts_at_first_key;
  table.lies_on = motion.lies_on;
  TableWriter writer(robot);
  table.path = writer.way(plan);
  for (const MotionPlan& way : exits.ways) table.ways.push_back(writer.way(way));
  table.exits = exits.exits;
  for (std::size_t b = 1; b < table.exits.size(); ++b) {
    result.longest_exit_points = std::max(result.longest_exit_points, table.exit_points(b));
  }
  return result;
}

}  // namespace gaitway::motion
