// The physical robot in MuJoCo: bodies, contact, motors and what its sensors read. Knows nothing of the
// network.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "gaitway/simulator/conditions.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/world/world.hpp"

namespace gaitway::simulator {

struct PlantOptions {
  std::uint64_t seed = 1;
  // Scales what the planner does not know: link masses 5 %, trunk CoM 6/4/6 mm, joint zeros 0.4° (all σ), and
  // what the parts of a robot differ by whose description says so (docs/simulator.md).
  double mismatch = 1.0;
  bool sensor_noise = true;
  Conditions conditions = {};
  // What it walks in; none: an endless floor. A world has its own ground: slopes, tiles and steps of the
  // conditions are refused then.
  std::optional<world::World> world = std::nullopt;
  // Where the joints begin, in the order of RobotModel::joints, rad; empty: in the home posture. The robot
  // stands on the sole that is lower when it is level.
  std::vector<double> start_rad = {};
};

// What the sensors read, in SI units, sensor frames; noise included.
struct PlantSensors {
  std::vector<std::int32_t> encoder_count;  // each joint; zero error of the mismatch included
  std::vector<double> motor_torque_Nm;      // each joint: the truth, as it is applied behind the gear
  // Each joint, by its current sensor: what the motor gives before its gear, by the nominal torque constant.
  std::vector<double> motor_current_Nm;
  Eigen::Vector3d angular_velocity_rad_per_s = Eigen::Vector3d::Zero();  // trunk gyro
  // Trunk accelerometer: specific force (+g on z at rest), averaged over the step.
  Eigen::Vector3d acceleration_m_per_s2 = Eigen::Vector3d::Zero();
  // Trunk roll and pitch (rotation about z, then y, then x): against gravity of a fused inclinometer; of a
  // pendulum against apparent gravity, and late.
  Eigen::Vector2d inclination_rad = Eigen::Vector2d::Zero();
  // [Side][cell], as a rigid plate loads four cells: sum and moments are the contact's. A cell far behind the
  // centre of pressure reads negative, as a preloaded cell does.
  std::array<std::array<double, 4>, 2> force_N{};
  // [Side]: of feet that have a six-axis sensor: what the foot does to the leg above it, in the sensor's
  // frame, less its weight while it hangs level.
  std::array<urdf::Wrench, 2> foot_wrench{urdf::Wrench::Zero(), urdf::Wrench::Zero()};
  // [Side]: the same at the origin of the sole frame.
  std::array<Eigen::Vector3d, 2> foot_acceleration_m_per_s2{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
};

// What happens between each foot and the ground: the truth, for reports and tests alone.
struct GroundContact {
  std::array<Eigen::Isometry3d, 2> sole{Eigen::Isometry3d::Identity(),
                                        Eigen::Isometry3d::Identity()};  // in the world
  std::array<double, 2> normal_force_N{};
  // Centre of pressure of each foot in its own sole frame; valid where the force is > 0.
  std::array<Eigen::Vector2d, 2> foot_cop_m{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  // Of the links that are no feet: what a robot that has fallen lies on.
  double body_force_N = 0.0;     // normal, of all of them
  double hardest_force_N = 0.0;  // normal, of the link that is hit hardest
  double trunk_force_N = 0.0;    // normal, of the link with the IMU
};

// A link that touches something otherwise than by standing: anything but a sole on floor, step, slope or
// tile. Or another link: a robot that hits itself.
struct BodyContact {
  static constexpr int kFloor = -1, kNoLink = -1;
  int link = 0;              // index in RobotModel::links
  int solid = kFloor;        // index in the world's all_solids(true); nothing of two links
  double force_N = 0.0;      // normal, of all points where the two touch
  int other_link = kNoLink;  // that `link`, which has the lower index, touches in place of a solid

  [[nodiscard]] bool is_within_robot() const noexcept { return other_link != kNoLink; }
};

struct PlantTruth {
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();   // pelvis in the world
  Eigen::Isometry3d trunk = Eigen::Isometry3d::Identity();  // link with the IMU, in the world
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d cop_m = Eigen::Vector3d::Zero();  // of both feet together, in the world
  double trunk_tilt_rad = 0.0;                      // against the vertical
};

// Of one IMU.
struct ImuTruth {
  Eigen::Matrix3d mounting = Eigen::Matrix3d::Identity();  // from the description's axes to its own
  // What the sensor tells of the true value in its own axes: this times it, and more.
  Eigen::Matrix3d gyro_sensitivity = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d gyro_per_acceleration_s_per_m = Eigen::Matrix3d::Zero();  // of the specific force
  Eigen::Matrix3d accelerometer_sensitivity = Eigen::Matrix3d::Identity();
  Eigen::Vector3d accelerometer_zero_m_per_s2 = Eigen::Vector3d::Zero();
  Eigen::Vector2d inclinometer_zero_rad = Eigen::Vector2d::Zero();
  Eigen::Vector2d inclinometer_cross_axis = Eigen::Vector2d::Zero();  // share of the other angle
};

// Of one joint's motor, drive and servo: factors on what the description says, 1 and 0 for an ideal one.
struct JointTruth {
  double torque_constant_factor = 1.0;
  double friction_factor = 1.0, damping_factor = 1.0;  // dry, viscous
  double current_gain = 1.0, current_offset_Nm = 0.0;  // of its current sensor
  double servo_stiffness_factor = 1.0, servo_damping_factor = 1.0;
};

// What the seed has drawn of the body, and its description does not say: for reports and tests alone.
struct BodyTruth {
  std::vector<double> encoder_zero_rad;                          // of each joint
  Eigen::Vector3d trunk_com_offset_m = Eigen::Vector3d::Zero();  // from the description's
  std::vector<double> play_factor;               // of each joint, on the condition's width of its play
  std::array<double, 2> sole_time_factor{1, 1};  // [Side], on a contact's time constant
  std::vector<double> link_mass_kg;
  std::array<std::array<double, 4>, 2> cell_gain{};               // [Side]; 0: a dead one
  Eigen::Vector3d gyro_bias_rad_per_s = Eigen::Vector3d::Zero();  // as it is by now
  ImuTruth imu;
  std::vector<JointTruth> joints;
};

// A bare replay of recorded torques.
struct Replay {
  double wall_s = 0.0;
  std::vector<double> positions;  // at the end, as Plant::positions()
};

// Depends on nothing but its options and commands: the same give the same motion to the bit. Not thread-safe.
class Plant {
 public:
  // Stands in the posture of the start, soles on the ground, at the world's start. Throws std::runtime_error
  // where MuJoCo refuses robot or world, input::InputError where the robot has no room at the start, and
  // std::invalid_argument for a world with conditions of another ground, and for a start with another number
  // of joints, or one that is not finite or beyond its limits.
  Plant(const urdf::RobotModel& robot, const PlantOptions& options);
  ~Plant();
  Plant(Plant&&) noexcept;
  Plant& operator=(Plant&&) noexcept;

  // Advances one physics step. `command_Nm`: torque asked of each motor. The motor gives at most its limit,
  // fading to zero at its speed limit when it drives in the direction of motion; braking it gives the full
  // limit. With a mismatch its torque constant is another one, its gear loses torque, heat and a sagging
  // supply lower its limits. What is applied is rounded to single precision. Throws std::invalid_argument for
  // a wrong number of torques or one that is not finite.
  void step(std::span<const double> command_Nm);

  [[nodiscard]] const PlantSensors& sensors() const noexcept;  // of the present instant
  [[nodiscard]] PlantTruth truth() const;
  [[nodiscard]] BodyTruth body_truth() const;
  [[nodiscard]] const GroundContact& ground_contact() const noexcept;
  // Of the last step, each pair of link and solid, and of links, once.
  [[nodiscard]] std::span<const BodyContact> body_contacts() const noexcept;
  [[nodiscard]] const std::optional<world::World>& world() const noexcept;
  // The world's all_solids(true) as they lie now; nothing without a world.
  [[nodiscard]] std::vector<world::Solid> solids() const;
  [[nodiscard]] bool fallen()
      const noexcept;  // trunk tilt > 50°, base < 0.2 m above the ground below it, or not a number
  [[nodiscard]] double time_s() const noexcept;
  // Hash input: qpos and qvel, bit for bit.
  [[nodiscard]] std::span<const double> positions() const noexcept;
  [[nodiscard]] std::span<const double> velocities() const noexcept;

  // A constant force at a body's (link's) centre of mass, in the world frame, that gives the impulse along
  // the direction (of any length) in the duration, rounded to steps. Begins with the next step; several may
  // overlap. A thing of the world may be pushed, too, by its name. Throws std::invalid_argument for an
  // unknown body, a direction of no length, or a duration that is not positive.
  void push(std::string_view body, const Eigen::Vector3d& direction, double impulse_Ns, double duration_s);

  // From the next step on, for a duration that is rounded to steps, each motor gives at most this part of
  // what it could: its supply sags. A newer sag takes an older one's place. Throws std::invalid_argument for
  // a factor that is not within [0, 1], or a duration that is not positive.
  void weaken_motors(double torque_factor, double duration_s);

  // Changes of the world while the robot is in it; what moves there goes on as it did. From the next step on.
  // All throw std::invalid_argument, with name, rule and remedy, and nothing has changed: without a world,
  // for a name that is taken, or that nothing has, and where the solid would lie inside the robot.
  //
  // `mass_kg`: none: it stands fast.
  void put(const world::Solid& solid, const world::Colour& colour, std::optional<double> mass_kg);
  // What was put there, or a thing of the world; it comes to rest.
  void move(std::string_view name, const Eigen::Isometry3d& pose);
  // What was put there.
  void remove(std::string_view name);
  // Solids that were put there, as they lie now.
  [[nodiscard]] std::vector<world::Solid> put_solids() const;
  // Rises with each of these changes.
  [[nodiscard]] std::uint32_t geometry() const noexcept;

  // The same model from the same start, fed the given torques (motor_torque_Nm, one row for each step,
  // row-major) and nothing else: no sensors, no contacts read. Without pushes it ends where the recorded run
  // did, to the bit; pushes are not replayed, tiles stay where they lie. The plant itself does not move.
  [[nodiscard]] Replay replay(std::span<const float> applied_torque_Nm) const;
  // Its wall time alone.
  [[nodiscard]] double replay_wall_s(std::span<const float> applied_torque_Nm) const;

  struct Implementation;
  [[nodiscard]] const Implementation& implementation() const noexcept {
    return *implementation_;
  }  // for the camera

 private:
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace gaitway::simulator
