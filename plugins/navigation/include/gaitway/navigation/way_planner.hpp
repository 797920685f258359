// What the navigator plans with: the robot's limits, its map, and what has been seen since on top of that.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/planning/planner.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/world/world.hpp"

namespace gaitway::navigation {

// Of the gait's own limits, what planned steps take: a way is followed exactly, so something must be left for
// corrections and pushes.
struct StepShares {
  double forward = 0.6, side = 0.6, turn = 0.6;
};

class WayPlanner {
 public:
  struct SeenBox {
    planning::Pose pose;  // of its middle, in the world
    Eigen::Vector3d size_m;
  };
  // Takes some 100 ms. Throws std::invalid_argument as planning::Planner does.
  WayPlanner(const urdf::RobotModel& robot, world::World world, const StepShares& shares);

  // Boxes that stand where the map does not have them; `odometry`: pose of that frame in the world. Whether
  // that is news: boxes that have moved by less than cameras can tell are the same.
  bool see(const Obstacles& obstacles, const planning::Pose& odometry);

  // All that there is to it, for whichever thread: it may outlive later news, but not this.
  [[nodiscard]] std::function<planning::Plan()> job(const planning::Request& request) const;
  [[nodiscard]] const planning::Limits& limits() const noexcept { return planner_.limits(); }

 private:
  [[nodiscard]] planning::Plan plan_in(const world::World& world, const planning::Request& request) const;

  planning::Planner planner_;
  world::World world_;                             // as it was given
  std::shared_ptr<const world::World> with_seen_;  // and with what has been seen
  std::vector<SeenBox> seen_;
};

}  // namespace gaitway::navigation
