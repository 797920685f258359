// MuJoCo's model of the robot and the ground, built from the RobotModel alone: one truth for planner and
// physics.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/simulator/conditions.hpp"
#include "gaitway/simulator/self_collision.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/world/world.hpp"

namespace gaitway::simulator {

inline constexpr int kLargestPictureWidth_px = 1920, kLargestPictureHeight_px = 1080;
inline constexpr std::array<double, 3> kSunDirection{-0.35, -0.45,
                                                     -1.0};  // the way its light goes, in the world

// How the simulated robot differs from its description.
struct ModelMismatch {
  std::vector<double> mass_factor;  // each link's; inertia likewise
  Eigen::Vector3d trunk_com_offset_m = Eigen::Vector3d::Zero();
  std::vector<double> play_factor;  // of each joint, on the width of its play, if it has one
  std::array<double, 2> sole_time_factor{1,
                                         1};  // [Side], on the time in which a contact gives way and recovers
};

struct ModelDeleter {
  void operator()(mjModel* model) const noexcept { mj_deleteModel(model); }
};
struct DataDeleter {
  void operator()(mjData* data) const noexcept { mj_deleteData(data); }
};
using ModelPointer = std::unique_ptr<mjModel, ModelDeleter>;
using DataPointer = std::unique_ptr<mjData, DataDeleter>;

// Body i + 1 of the model is link i; a hinge has its joint's name. What can be pushed in the world comes
// behind the robot. Links collide with each other, but for neighbours and what touches at home: the latter
// costs a second compilation. Throws std::runtime_error with the compiler's words.
ModelPointer build_physics_model(const urdf::RobotModel& robot, const ModelMismatch& mismatch,
                                 const Conditions& conditions, const std::optional<world::World>& world);

// Of a solid's geometry, and of a thing's body.
[[nodiscard]] std::string world_name(const world::Solid& solid);
// All of a world but its things. `friction`: of what names none.
void add_world(mjSpec* spec, const world::World& world, double friction);
void add_things(mjSpec* spec, const world::World& world, double friction);
// A foot's shapes: on ground and solids of the world their springs count as much as the ground's, and the
// friction is that of what they stand on.
void make_equal_to_ground(mjsBody* foot, const world::World& world, double friction);

// Of the ground's frame in the world; the identity where the ground is level. The ground's z is its normal.
[[nodiscard]] Eigen::Quaterniond ground_rotation(const GroundConditions& ground);

// The pairs that touch, of those that the model does not leave out. Changes the model only while it looks.
[[nodiscard]] std::vector<LinkPair> touching_at_home(mjModel& model, const urdf::RobotModel& robot);
// These never touch each other.
void leave_out(mjSpec* spec, const urdf::RobotModel& robot, const std::vector<LinkPair>& pairs);

// Adds the ground's shapes to the world body.
void add_ground(mjSpec* spec, const GroundConditions& ground, double friction);

// Tiles of random height. There are only as many as lie around the robot; they move on with it, and each
// place has its height by the seed alone.
class TileField {
 public:
  TileField(const mjModel& model, const GroundConditions& ground, std::uint64_t seed);

  // Lays the tiles around a point of the world that has moved on by a tile or more.
  void follow(mjModel& model, const Eigen::Vector3d& point_m);

 private:
  [[nodiscard]] double height_m(std::int64_t column, std::int64_t row) const noexcept;

  Eigen::Quaterniond rotation_;
  double largest_m_;
  std::uint64_t seed_;
  std::vector<int> geoms_;             // column by column; empty: no tiles
  std::int64_t column_ = 0, row_ = 0;  // of the tile below the robot
  bool laid_ = false;
};

}  // namespace gaitway::simulator
