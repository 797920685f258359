// What of a world soles are meant to stand on, where the robot begins there, and whether it has room.
#pragma once

#include <array>
#include <vector>

#include "contact_reader.hpp"

namespace gaitway::simulator {

class WorldGround {
 public:
  explicit WorldGround(const world::World& world);

  // Of the base: at the world's start, with the soles on the ground: square on a slope, and otherwise upright
  // on ground that must be about level below them. `base_height_m`: of the base above the soles. Throws
  // input::InputError.
  [[nodiscard]] Eigen::Isometry3d start_pose(const world::World& world, const urdf::RobotModel& robot,
                                             const std::array<Eigen::Isometry3d, 2>& soles_in_base,
                                             double base_height_m) const;
  // Of a point above the ground below it. What is found to be more than `enough_m` may be less than the
  // truth.
  [[nodiscard]] double height_above_m(const Eigen::Vector3d& point_m, double enough_m) const noexcept;

 private:
  [[nodiscard]] const world::Solid* top_at(double x_m, double y_m) const noexcept;

  std::vector<world::Solid> solids_;
  double highest_m_ = 0.0;
};

// Throws std::invalid_argument for conditions that lay another ground than the world's.
void require_plain_ground(const GroundConditions& conditions, const world::World& world);

// Throws input::InputError where a link, or a thing that can be pushed, begins inside of something.
void require_room(const mjModel& model, const mjData& state, const ContactReader& contacts,
                  const world::World& world, const urdf::RobotModel& robot);

}  // namespace gaitway::simulator
