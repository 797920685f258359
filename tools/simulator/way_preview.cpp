// The plug-in's planner, asked from outside.
#include "tools/simulator/way_preview.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/navigation/robot_limits.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;

planning::Pose pose_from(const json& numbers) {
  return {numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>()};
}

Obstacles obstacles_from(const json& list) {
  Obstacles obstacles{};
  for (const json& one : list) {
    if (obstacles.count == kMaxObstacles) break;
    for (std::size_t i = 0; i < 3; ++i) {
      obstacles.place[obstacles.count][i] = one.at("place").at(i).get<double>();
      obstacles.size[obstacles.count][i] = one.at("size").at(i).get<double>();
    }
    ++obstacles.count;
  }
  return obstacles;
}

}  // namespace

WayPreview::WayPreview(const urdf::RobotModel& robot, const world::World& world)
    : planner_(robot, world, navigation::StepShares{}), step_time_s_(navigation::step_time_s(robot)) {}

json WayPreview::plan(const std::array<double, 3>& goal, const json& state) {
  static_cast<void>(planner_.see(obstacles_from(state.at("obstacles")), {}));
  const json& feet = state.at("feet");
  const planning::Plan plan = planner_.job({.left = pose_from(feet.at(0)),
                                            .right = pose_from(feet.at(1)),
                                            .goal = {goal[0], goal[1], planning::wrapped(goal[2])}})();
  if (!plan.found()) throw std::invalid_argument(plan.explanation);
  json steps = json::array();
  for (const planning::Footstep& step : plan.steps) {
    steps.push_back({{"side", step.side == planning::Side::left ? 0 : 1},
                     {"pose", {step.pose.x_m, step.pose.y_m, step.pose.yaw_rad}},
                     {"height", step.height_m}});
  }
  return {
      {"steps", steps}, {"feet", feet}, {"seconds", static_cast<double>(plan.steps.size()) * step_time_s_}};
}

}  // namespace gaitway::tools
