// What Plant and Camera share of MuJoCo: model, state, and what was drawn for this one robot.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "contact_reader.hpp"
#include "gaitway/facts/random_stream.hpp"
#include "gaitway/simulator/plant.hpp"
#include "imu_model.hpp"
#include "motor_model.hpp"
#include "physics_model.hpp"
#include "world_ground.hpp"

namespace gaitway::simulator {

struct ActivePush {
  int body = 0;
  Eigen::Vector3d force_N = Eigen::Vector3d::Zero();
  long remaining_steps = 0;
};

// Of a world's things, in their order.
[[nodiscard]] std::vector<int> bodies_of_things(const mjModel& model,
                                                const std::optional<world::World>& world);

struct Plant::Implementation {
  Implementation(const urdf::RobotModel& robot, const PlantOptions& options);

  void draw_sensor_faults();
  void set_home(const std::vector<double>& start_rad);
  void reset(mjData* state) const;
  // Friction and play of the joints and the soles' compliance as they were drawn, in a model that has those
  // of the description.
  void set_drawn(mjModel& target) const;
  void apply_motors(std::span<const double> command_Nm);
  [[nodiscard]] std::vector<JointTruth> joint_truth() const;
  void apply_pushes();
  void read_sensors(bool first);
  void read_foot(std::size_t foot);
  void read_wrench(std::size_t foot);
  [[nodiscard]] urdf::Wrench weight_on_sensor(std::size_t foot) const;
  // The same state in a world with other solids. Throws std::invalid_argument where `newcomer` would lie
  // inside the robot, and nothing has changed.
  void change_world(world::World next, std::string_view newcomer);
  [[nodiscard]] world::World& changeable_world();  // throws std::invalid_argument where there is none
  [[nodiscard]] world::World world_as_it_lies() const;

  urdf::RobotModel robot;
  facts::RandomStream mismatch_random, build_random, noise_random, condition_random;
  bool noise;
  ModelMismatch mismatch;
  Conditions conditions;
  Eigen::Quaterniond ground;  // ground_rotation()
  std::optional<world::World> world;
  std::optional<WorldGround> world_ground;  // of the world
  std::vector<double> zero_error_rad;
  Eigen::Vector3d gyro_bias_rad_per_s = Eigen::Vector3d::Zero();
  std::array<std::array<double, 4>, 2> cell_gain{};
  ModelPointer model;
  ImuModel imu_model;
  TileField tiles;
  std::vector<int> position_address, velocity_address;  // of each joint, in qpos and qvel
  DataPointer data;
  std::array<int, 2> foot_body{};
  int trunk_body = 0;
  std::vector<double> home;  // qpos at the start
  PlantSensors sensors;
  ContactReader contacts;
  std::vector<int> thing_body;
  std::vector<std::string> put_names;  // of solids that came later
  std::size_t own_surfaces = 0;        // of the world as it was given
  std::uint32_t geometry = 1;
  std::array<Eigen::Vector3d, 3> last_velocity_m_per_s{};  // of IMU, left sole, right sole
  std::vector<ActivePush> pushes;
  MotorModel motors;
  ServoFactors servos;                        // in the joints' electronics: for body_truth() alone
  std::vector<double> motor_speed_rad_per_s;  // of each joint, in this step
  double supply_factor = 1.0;                 // of the motors' torque, for so many steps
  long sagging_steps = 0;
};

}  // namespace gaitway::simulator
