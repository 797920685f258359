// A quintic in the coordinates of StanceMap for each batch's end and each duration, checked as a motion is.
#include "gaitway/motion/motion_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/body_load.hpp"
#include "gaitway/motion/motion_limits.hpp"
#include "gaitway/motion/motion_path.hpp"
#include "gaitway/motion/stance_map.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "segment_cost.hpp"

namespace gaitway::motion {
namespace {

constexpr std::size_t kBatch = kBatchPoints, kLongestTail = kMaxTailPoints;
constexpr std::array kDurations_s{0.3, 0.4, 0.5, 0.65, 0.8, 1.0, 1.25, 1.5, 1.8};
constexpr double kHalt_s = 0.3;  // in which joints on the ground come to rest

class ExitPlanner {
 public:
  ExitPlanner(const urdf::RobotModel& robot, const MotionPlan& plan, const MotionLimits& limits)
      : robot_(robot), plan_(plan), limits_(limits), map_(robot), sampler_(robot), kinematics_(robot) {}

  // Of a robot that stands on both feet at `point`.
  std::optional<MotionPlan> way_home(std::size_t point) {
    if (!both_stand_around(point)) return std::nullopt;
    Segment segment{.standing = true, .contact = Contact::both, .from = coordinates(point), .to = home()};
    Knot start{Eigen::VectorXd(), Eigen::VectorXd(), {0}}, end;
    const Eigen::VectorXd before = coordinates(point - 1), after = coordinates(point + 1);
    start.velocity = (after - before) / (2.0 * facts::kSlot_s);
    start.acceleration = (after - 2.0 * segment.from + before) / (facts::kSlot_s * facts::kSlot_s);
    for (const double duration_s : kDurations_s) {
      segment.duration_s = duration_s;
      std::optional<MotionPlan> way = way_along(segment, start, end, point);
      if (way && check_plan(robot_, *way, limits_).broken() == nullptr) return cut(*std::move(way), point);
    }
    return std::nullopt;
  }

  // The joints stop where they are, within what the motion may use of their range.
  [[nodiscard]] MotionPlan halt(std::size_t point) const {
    MotionPlan way{.name = plan_.name, .joint_count = plan_.joint_count};
    const std::size_t before = point == 0 ? 0 : point - 1;
    const JointLimits joints(robot_, limits_);
    const auto points = static_cast<std::size_t>(std::lround(kHalt_s / facts::kSlot_s));
    for (std::size_t k = 1; k <= whole(points); ++k) {
      const double time_s = std::min(static_cast<double>(k) * facts::kSlot_s, kHalt_s);
      for (std::size_t j = 0; j < plan_.joint_count; ++j) {
        const double now = plan_.reference(point)[j],
                     speed = (now - plan_.reference(before)[j]) / facts::kSlot_s;
        const trajectory::Quintic halting({now, speed, 0.0}, {now + 0.5 * speed * kHalt_s, 0.0, 0.0},
                                          kHalt_s);
        const auto index = static_cast<Eigen::Index>(j);
        way.joint_rad.push_back(
            std::clamp(halting.at(time_s).position, joints.lower_rad[index], joints.upper_rad[index]));
      }
      way.contact.push_back(Contact::none);
      way.pelvis.push_back(plan_.pelvis[point]);
    }
    way.reference_rad = way.joint_rad;
    return way;
  }

 private:
  static std::size_t whole(std::size_t points) { return (points + kBatch - 1) / kBatch * kBatch; }

  [[nodiscard]] bool both_stand_around(std::size_t point) const {
    if (point == 0 || point + 1 >= plan_.point_count()) return false;
    const auto here = plan_.contact.begin() + static_cast<std::ptrdiff_t>(point);
    return std::all_of(here - 1, here + 2, [](Contact contact) { return contact == Contact::both; });
  }

  Eigen::VectorXd coordinates_of(std::span<const double> joints, const Eigen::Isometry3d& pelvis) {
    kinematics_.compute(joints);
    return map_.coordinates(
        pelvis,
        {pelvis * kinematics_.sole_pose(urdf::Side::left), pelvis * kinematics_.sole_pose(urdf::Side::right)},
        Eigen::Map<const Eigen::VectorXd>(joints.data(), static_cast<Eigen::Index>(joints.size())));
  }
  Eigen::VectorXd coordinates(std::size_t point) {
    return coordinates_of(plan_.point(point), plan_.pelvis[point]);
  }

  // The motion ends at home, standing.
  Eigen::VectorXd home() { return coordinates(plan_.point_count() - 1); }

  // The motion up to the point at which the way leaves it: what is checked, and what the servos lag behind,
  // begins there.
  [[nodiscard]] MotionPlan beginning(std::size_t point) const {
    MotionPlan way{.name = plan_.name, .joint_count = plan_.joint_count};
    const auto points = static_cast<std::ptrdiff_t>(point + 1);
    way.joint_rad.assign(plan_.joint_rad.begin(),
                         plan_.joint_rad.begin() + points * static_cast<std::ptrdiff_t>(plan_.joint_count));
    way.contact.assign(plan_.contact.begin(), plan_.contact.begin() + points);
    way.pelvis.assign(plan_.pelvis.begin(), plan_.pelvis.begin() + points);
    return way;
  }

  std::optional<MotionPlan> way_along(const Segment& segment, const Knot& start, const Knot& end,
                                      std::size_t point) {
    MotionPlan way = beginning(point);
    const std::vector<trajectory::Quintic> spline = polynomials(segment, start, end);
    BodyPosture posture;
    const auto points = static_cast<std::size_t>(std::lround(segment.duration_s / facts::kSlot_s));
    for (std::size_t k = 1; k <= whole(points + kRestPoints); ++k) {
      const double time_s = std::min(static_cast<double>(k) * facts::kSlot_s, segment.duration_s);
      if (sampler_.posture(segment, spline, time_s, posture) > 0.0) return std::nullopt;
      way.joint_rad.insert(way.joint_rad.end(), posture.joint_rad.begin(), posture.joint_rad.end());
      way.contact.push_back(Contact::both);
      way.pelvis.push_back(posture.pelvis);
    }
    way.reference_rad = leading_references(robot_, way);
    return way;
  }

  // Without the points that belong to the motion.
  static MotionPlan cut(MotionPlan way, std::size_t point) {
    const auto points = static_cast<std::ptrdiff_t>(point + 1);
    const std::ptrdiff_t rows = points * static_cast<std::ptrdiff_t>(way.joint_count);
    way.joint_rad.erase(way.joint_rad.begin(), way.joint_rad.begin() + rows);
    way.reference_rad.erase(way.reference_rad.begin(), way.reference_rad.begin() + rows);
    way.contact.erase(way.contact.begin(), way.contact.begin() + points);
    way.pelvis.erase(way.pelvis.begin(), way.pelvis.begin() + points);
    return way;
  }

  const urdf::RobotModel& robot_;
  const MotionPlan& plan_;
  MotionLimits limits_;
  StanceMap map_;
  SegmentSampler sampler_;
  urdf::ForwardKinematics kinematics_;
};

}  // namespace

ExitPlan plan_exits(const urdf::RobotModel& robot, const MotionPlan& plan, const MotionLimits& limits) {
  ExitPlanner planner(robot, plan, limits);
  const std::size_t batches = (plan.point_count() - 1) / kBatch;
  ExitPlan result;
  result.exits.resize(batches + 1);
  std::vector<std::size_t> length(batches + 1, 0);
  for (std::size_t b = batches; b-- > 0;) {
    const std::size_t point = b * kBatch;
    trajectory::MotionExit& exit = result.exits[b];
    exit = result.exits[b + 1];
    ++exit.go_on_batches;
    length[b] = length[b + 1] + kBatch;
    std::optional<MotionPlan> way =
        plan.contact[point] == Contact::none ? planner.halt(point) : planner.way_home(point);
    if (way && (way->point_count() < length[b] || plan.contact[point] == Contact::none)) {
      length[b] = way->point_count();
      exit = {0, static_cast<std::int32_t>(result.ways.size())};
      result.ways.push_back(*std::move(way));
    }
    if (b > 0 && length[b] > kLongestTail) {
      throw MotionError(fmt::format(
          "motion '{}': from {:.2f} s on it takes {:.2f} s until the robot can stand at rest, but a safe "
          "tail lasts {:.2f} s "
          "at most. Put both feet down in between, or be quicker there",
          plan.name, static_cast<double>(point) * facts::kSlot_s,
          static_cast<double>(length[b]) * facts::kSlot_s,
          static_cast<double>(kLongestTail) * facts::kSlot_s));
    }
  }
  return result;
}

}  // namespace gaitway::motion
