// What the physics engine's contacts mean: the load on the soles, and what else of the robot touches what.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "gaitway/simulator/plant.hpp"
#include "physics_model.hpp"

namespace gaitway::simulator {

Eigen::Isometry3d body_pose(const mjData& data, int body);  // in the world

class ContactReader {
 public:
  // `world` may be none.
  ContactReader(const mjModel& model, const urdf::RobotModel& robot,
                const std::optional<world::World>& world);

  // The same robot in a model with another world.
  void follow(const mjModel& model, const std::optional<world::World>& world);
  // A link that a solid reaches into by more than so much; -1: none.
  [[nodiscard]] int link_inside(const mjModel& model, const mjData& data, int solid, double deepest_m) const;

  // Of the state's last step.
  void read(const mjModel& model, const mjData& data);

  [[nodiscard]] const GroundContact& ground() const noexcept { return ground_; }
  [[nodiscard]] const std::vector<BodyContact>& body() const noexcept { return body_; }
  // Which solid a geometry is; BodyContact::kFloor if none.
  [[nodiscard]] int solid_of(int geom) const { return solid_of_geom_[static_cast<std::size_t>(geom)]; }
  // What of the robot a contact is of.
  struct Links {
    int link = BodyContact::kNoLink;        // the lower of two
    int other_link = BodyContact::kNoLink;  // the robot touches itself
  };
  [[nodiscard]] Links links_in(const mjModel& model, const mjContact& contact) const;

 private:
  [[nodiscard]] bool is_on_sole(const mjModel& model, const mjContact& contact, std::size_t foot) const;
  void add_body_contact(const BodyContact& contact);
  void add_link_force(int link, double force_N);

  int links_;
  int trunk_link_;
  std::array<int, 2> foot_link_;
  std::array<Eigen::Isometry3d, 2> sole_in_foot_;
  bool has_world_ = false;
  std::vector<int> solid_of_geom_;
  std::vector<bool> is_ground_;       // of each solid
  std::vector<double> link_force_N_;  // of the links that are no feet
  GroundContact ground_;
  std::vector<BodyContact> body_;
};

}  // namespace gaitway::simulator
