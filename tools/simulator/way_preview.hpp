// Footsteps to a place before the robot walks there, as its plug-in `navigation` would plan them: from where
// the simulated robot's feet are, around what stands there now.
#pragma once

#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "gaitway/navigation/way_planner.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/world/world.hpp"

namespace gaitway::tools {

class WayPreview {
 public:
  // Throws std::invalid_argument as the planner does.
  WayPreview(const urdf::RobotModel& robot, const world::World& world);

  // `state`: of the simulation (timeline/README.md). Throws std::invalid_argument with the reason why there
  // is no way.
  [[nodiscard]] nlohmann::json plan(const std::array<double, 3>& goal, const nlohmann::json& state);

 private:
  navigation::WayPlanner planner_;
  double step_time_s_;
};

}  // namespace gaitway::tools
