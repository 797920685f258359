// The planner of a robot in a world.
#include "gaitway/navigation/way_planner.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "gaitway/navigation/robot_limits.hpp"

namespace gaitway::navigation {
namespace {

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

}  // namespace

WayPlanner::WayPlanner(const urdf::RobotModel& robot, world::World world, const StepShares& shares)
    : planner_(planner_for(robot, shares)),
      world_(std::move(world)),
      with_seen_(std::make_shared<world::World>(world_)) {}

bool WayPlanner::see(const Obstacles& obstacles) {
  const std::uint32_t count = std::min(obstacles.count, static_cast<std::uint32_t>(kMaxObstacles));
  const bool same = count == seen_.count &&
                    std::memcmp(obstacles.place, seen_.place, sizeof seen_.place) == 0 &&
                    std::memcmp(obstacles.size, seen_.size, sizeof seen_.size) == 0;
  if (same) return false;
  seen_ = obstacles;
  seen_.count = count;
  auto with_seen = std::make_shared<world::World>(world_);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double* const place = obstacles.place[i];
    const Eigen::Vector3d size_m(obstacles.size[i][0], obstacles.size[i][1], obstacles.size[i][2]);
    if (!std::isfinite(place[0] + place[1] + place[2]) || !(size_m.array() > 0.0).all()) continue;
    world::Solid solid;
    solid.kind = world::Kind::box;
    solid.name = "seen";
    solid.size_m = size_m;
    solid.pose = Eigen::Translation3d(place[0], place[1], 0.5 * size_m.z()) *
                 Eigen::AngleAxisd(place[2], Eigen::Vector3d::UnitZ());
    with_seen->solids.push_back(std::move(solid));
  }
  with_seen_ = std::move(with_seen);
  return true;
}

std::function<planning::Plan()> WayPlanner::job(const planning::Request& request) const {
  return [this, world = with_seen_, request,
          previous = std::vector<planning::Footstep>(request.previous.begin(), request.previous.end())] {
    planning::Request own = request;
    own.previous = previous;
    const double cell_m = planner_.cell_m();
    const planning::Pose start = planning::middle_of(own.left, own.right);
    const planning::GroundMap map = planning::ground_map(
        *world, planning::grid_over(*world, start, own.goal, cell_m), planner_.limits().height_m);
    return planner_.plan(map, own);
  };
}

}  // namespace gaitway::navigation
