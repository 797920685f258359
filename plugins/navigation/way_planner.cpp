// The planner of a robot in a world.
#include "gaitway/navigation/way_planner.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "gaitway/navigation/robot_limits.hpp"

namespace gaitway::navigation {
namespace {

constexpr const char* kSeenName = "seen";

planning::Limits shared(planning::Limits limits, const StepShares& shares) {
  limits.max_step_forward_m *= shares.forward;
  limits.max_step_backward_m *= shares.forward;
  limits.max_step_turn_rad *= shares.turn;
  limits.max_foot_spacing_m =
      limits.foot_spacing_m + shares.side * (limits.max_foot_spacing_m - limits.foot_spacing_m);
  return limits;
}

planning::Planner planner_for(const urdf::RobotModel& robot, const StepShares& shares) {
  const planning::Limits limits = limits_of(robot);
  return {shared(limits, shares), cell_for(limits)};
}

// Whether each of them is one of those, as far as cameras tell boxes apart from one picture to the next.
bool all_known(const std::vector<WayPlanner::SeenBox>& boxes, const std::vector<WayPlanner::SeenBox>& those) {
  constexpr double kSamePlace_m = 0.03, kSameSize_m = 0.04;
  return std::ranges::all_of(boxes, [&](const WayPlanner::SeenBox& box) {
    return std::ranges::any_of(those, [&](const WayPlanner::SeenBox& other) {
      // How far a corner has gone with a turn counts, not the turn itself: a small box's is not well seen.
      const double corner_m = 0.5 * box.size_m.head<2>().norm() * planning::turn_rad(box.pose, other.pose);
      return planning::way_m(box.pose, other.pose) + corner_m < kSamePlace_m &&
             (box.size_m - other.size_m).cwiseAbs().maxCoeff() < kSameSize_m;
    });
  });
}

// False: nothing that was seen is so near that it could hold the robot's place.
bool leave_out_nearest_seen(world::World& world, const planning::Request& request) {
  constexpr double kMightHold_m = 1.0;
  const planning::Pose start = planning::middle_of(request.left, request.right);
  const auto distance_m = [&](const world::Solid& solid) {
    if (solid.name != kSeenName) return std::numeric_limits<double>::infinity();
    const Eigen::Vector3d there = solid.pose.inverse() * Eigen::Vector3d(start.x_m, start.y_m, 0.0);
    return (there.cwiseAbs() - 0.5 * solid.size_m).head<2>().cwiseMax(0.0).norm();
  };
  const auto nearest = std::ranges::min_element(world.solids, {}, distance_m);
  if (nearest == world.solids.end() || distance_m(*nearest) > kMightHold_m) return false;
  world.solids.erase(nearest);
  return true;
}

}  // namespace

WayPlanner::WayPlanner(const urdf::RobotModel& robot, world::World world, const StepShares& shares)
    : planner_(planner_for(robot, shares)),
      world_(std::move(world)),
      with_seen_(std::make_shared<world::World>(world_)) {}

bool WayPlanner::see(const Obstacles& obstacles, const planning::Pose& odometry) {
  const std::uint32_t count = std::min(obstacles.count, static_cast<std::uint32_t>(kMaxObstacles));
  std::vector<SeenBox> boxes;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double* const place = obstacles.place[i];
    const Eigen::Vector3d size_m(obstacles.size[i][0], obstacles.size[i][1], obstacles.size[i][2]);
    if (!std::isfinite(place[0] + place[1] + place[2]) || !(size_m.array() > 0.0).all()) continue;
    const planning::Pose pose{place[0], place[1], place[2]};
    boxes.push_back({obstacles.frame == obstacles::frame::odometry ? odometry.compose(pose) : pose, size_m});
  }
  if (all_known(boxes, seen_) && all_known(seen_, boxes)) return false;
  auto with_seen = std::make_shared<world::World>(world_);
  for (const SeenBox& box : boxes) {
    world::Solid solid;
    solid.kind = world::Kind::box;
    solid.name = kSeenName;
    solid.size_m = box.size_m;
    solid.pose = Eigen::Translation3d(box.pose.x_m, box.pose.y_m, 0.5 * box.size_m.z()) *
                 Eigen::AngleAxisd(box.pose.yaw_rad, Eigen::Vector3d::UnitZ());
    with_seen->solids.push_back(std::move(solid));
  }
  seen_ = std::move(boxes);
  with_seen_ = std::move(with_seen);
  return true;
}

planning::Plan WayPlanner::plan_in(const world::World& world, const planning::Request& request) const {
  const planning::Pose start = planning::middle_of(request.left, request.right);
  const planning::GroundMap map = planning::ground_map(
      world, planning::grid_over(world, start, request.goal, planner_.cell_m()), planner_.limits().height_m);
  return planner_.plan(map, request);
}

std::function<planning::Plan()> WayPlanner::job(const planning::Request& request) const {
  return [this, world = with_seen_, request,
          previous = std::vector<planning::Footstep>(request.previous.begin(), request.previous.end())] {
    planning::Request own = request;
    own.previous = previous;
    planning::Plan plan = plan_in(*world, own);
    // Where the robot stands nothing else does: a box there was seen wrongly, or has been left behind by an
    // odometry that has slipped.
    world::World less = *world;
    while (plan.reason == planning::Reason::start_in_obstacle && leave_out_nearest_seen(less, own)) {
      plan = plan_in(less, own);
    }
    return plan;
  };
}

}  // namespace gaitway::navigation
