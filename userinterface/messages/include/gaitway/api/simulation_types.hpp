// Services that this project's own simulator has beside those of simulation_interfaces_types.hpp, in the
// style of service_types.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gaitway/api/service_types.hpp"

namespace gaitway::api::ros {

// A force [N] on a link's centre of mass for `duration` [s]. `frame`: world, or heading; empty: world.
struct LinkForce {
  std::string link;
  Vector3 force;
  double duration = 0.0;
  std::string frame;
  GAITWAY_FIELDS(link, force, duration, frame)
};
using PushLink = RosService<"gaitway_msgs/srv/PushLink", LinkForce, Outcome>;

// Times real time.
struct Speed {
  double speed = 1.0;
  GAITWAY_FIELDS(speed)
};
using SetSpeed = RosService<"gaitway_msgs/srv/SetSpeed", Speed, Outcome>;

// Simulated time [s].
GAITWAY_ONE_FIELD(Instant, double, time);
struct InstantReached {
  bool success = false;
  std::string message;
  double time = 0.0;
  GAITWAY_FIELDS(success, message, time)
};
using SeekTime = RosService<"gaitway_msgs/srv/SeekTime", Instant, InstantReached>;

// An event of a scenario without its time, as YAML in one line or as JSON.
GAITWAY_ONE_FIELD(EventText, std::string, event);
using ApplyEvent = RosService<"gaitway_msgs/srv/ApplyEvent", EventText, Outcome>;

// Footsteps to a place, and where the feet are now: `sides` 0 left, 1 right; `steps` and `feet` (left, right)
// x m, y m, yaw rad each, in the world; `duration` [s] of the walk, estimated.
struct FootstepPlan {
  bool success = false;
  std::string message;
  std::vector<std::uint8_t> sides;
  std::vector<double> steps;
  std::vector<double> feet;
  double duration = 0.0;
  GAITWAY_FIELDS(success, message, sides, steps, feet, duration)
};
using PlanFootsteps = RosService<"gaitway_msgs/srv/PlanFootsteps", Place, FootstepPlan>;

// One body of the world: `kind` box, step, slope, tile, wall or thing; `shape` box, cylinder or sphere;
// `size` whole [m], a cylinder's axis is z; `pose` of its centre; `colour` red, green, blue from 0 to 1.
struct WorldSolid {
  std::string name;
  std::string kind;
  std::string shape;
  Vector3 size;
  Pose pose;
  std::vector<double> colour;
  bool movable = false;
  GAITWAY_ROS_MESSAGE("gaitway_msgs/msg/WorldSolid", name, kind, shape, size, pose, colour, movable);
};
GAITWAY_ONE_FIELD(FirstSolid, std::uint32_t, first);
// Solids from the `first` on, as many as come in one answer, of `total`. `geometry`: that of the state.
struct WorldPart {
  bool success = false;
  std::string message;
  std::uint32_t geometry = 0;
  std::string world;
  std::uint32_t total = 0;
  std::vector<double> floor_colour;
  std::vector<WorldSolid> solids;
  GAITWAY_FIELDS(success, message, geometry, world, total, floor_colour, solids)
};
// What a real robot is to do after it was tried: of `walk` (m/s ahead, m/s to the left, rad/s; for `duration`
// s, 0: 10), `motion` and `goal` (x m, y m, yaw rad) one at most, `settings` (PLUGIN.PARAMETER=VALUE) first.
// `reason`: send it even if a simulated robot fell.
struct RobotOrder {
  std::vector<double> walk;
  double duration = 0.0;
  std::string motion;
  std::vector<double> goal;
  std::vector<std::string> settings;
  std::string reason;
  GAITWAY_FIELDS(walk, duration, motion, goal, settings, reason)
};
using SendToRobot = RosService<"gaitway_msgs/srv/SendToRobot", RobotOrder, Outcome>;

GAITWAY_ONE_FIELD(FirstByte, std::uint32_t, first);
// `total`: bytes of the whole file; `data`: some of them, from the first that was asked for, in base64.
struct PicturePart {
  bool success = false;
  std::string message;
  std::uint32_t total = 0;
  std::string data;
  GAITWAY_FIELDS(success, message, total, data)
};
using GetPicture = RosService<"gaitway_msgs/srv/GetPicture", FirstByte, PicturePart>;

using GetGeometry = RosService<"gaitway_msgs/srv/GetGeometry", FirstSolid, WorldPart>;

}  // namespace gaitway::api::ros
