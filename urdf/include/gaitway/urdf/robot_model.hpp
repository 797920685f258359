// One validated description of the robot, made from its URDF (geometry, masses, limits) and its network file
// (everything that a URDF cannot say). Every room that needs to know the robot reads this and nothing else.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <kdl/tree.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/facts/body_scale.hpp"
#include "gaitway/input/complaint.hpp"

namespace gaitway::urdf {

// What is wrong with a robot description: names file, line or field, value and rule.
using RobotError = input::InputError;

enum class Side : std::uint8_t { left = 0, right = 1 };
inline constexpr std::array kSides{Side::left, Side::right};
[[nodiscard]] constexpr std::size_t index_of(Side side) noexcept {
  return static_cast<std::size_t>(side);
}

// A surface from a file of the robot's folder.
struct Mesh {
  std::filesystem::path file;                          // binary STL, absolute
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();     // metres for one unit of the file; negative: mirrored
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();  // of its bounding box, from its own origin
};

// What a link is to the ground (collision) or in a picture (visual); it weighs nothing. A mesh touches as its
// convex hull.
struct Shape {
  enum class Kind : std::uint8_t { box, cylinder, sphere, mesh };
  Kind kind = Kind::box;
  // Of the middle of its extent, in the link's frame; a cylinder's axis is z.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // full extent along the axes of the pose
  Mesh mesh = {};                                    // of Kind::mesh
  Eigen::Vector4d rgba = Eigen::Vector4d::Ones();    // 0..1, of what is seen
};

struct Link {
  std::string name;
  int parent_joint = -1;  // index into RobotModel::joints; -1 for the base
  double mass_kg = 0.0;
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();          // in the link's frame
  Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();  // about the CoM, axes of the link's frame
  std::vector<Shape> collision;
  std::vector<Shape> visual = {};
};

struct Servo {
  double stiffness_Nm_per_rad = 0.0;
  double damping_Nms_per_rad = 0.0;
};

struct Motor {
  double torque_limit_Nm = 0.0;  // at standstill; fades to zero at speed_limit in the driving direction
  double speed_limit_rad_per_s = 0.0;
  double armature_kg_m2 = 0.0;       // reflected rotor inertia
  double damping_Nms_per_rad = 0.0;  // viscous
  double friction_Nm = 0.0;          // dry
};

struct Joint {
  std::string name;
  int parent_link = 0, child_link = 0;  // indices into RobotModel::links
  Eigen::Isometry3d origin =
      Eigen::Isometry3d::Identity();                // joint frame in the parent link's frame, at zero
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // unit, in the joint frame
  double lower_rad = 0.0, upper_rad = 0.0;
  double velocity_limit_rad_per_s = 0.0;  // that a reference may ask for
  double home_rad = 0.0;                  // in the standing posture
  // from the network file
  std::uint8_t node = 0;   // id of its local controller on the bus, 1..64, unique
  double count_rad = 0.0;  // size of a count on the wire
  double encoder_count_rad = 0.0;
  double encoder_zero_rad = 0.0;  // what the encoder says where the joint is at 0: from the calibration
  Servo servo;
  Motor motor;
  int trim_channel = -1;  // its place in the trim frame; -1: none
};

enum class SensorKind : std::uint8_t {
  none,
  force_cell,
  foot_acceleration,
  angular_velocity,
  acceleration,
  inclination,
  foot_wrench
};

// A sensor channel that travels in a joint's feedback frame.
struct SensorChannel {
  SensorKind kind = SensorKind::none;
  Side side = Side::left;  // for what sits in a foot
  int index = 0;       // cell 0..3 (front left, front right, rear left, rear right), or axis x, y, z = 0..2
                       // (inclination: roll, pitch = 0, 1; wrench: force x, y, z, torque x, y, z = 0..5)
  double scale = 1.0;  // sensor unit (N, N·m, m/s², rad/s, rad) for one count of the 16-bit channel
  double gain = 1.0;   // of the sensor, by which its readings are divided: from the calibration
};

// What a foot has to tell its load.
enum class FootSensor : std::uint8_t { cells, six_axis, none };
using Wrench = Eigen::Matrix<double, 6, 1>;  // force, torque

struct Foot {
  int link = 0;  // index of the sole-carrying link
  // Pose of the sole frame in that link: origin below the ankle axes on the ground, x forward, z up.
  Eigen::Isometry3d sole = Eigen::Isometry3d::Identity();
  Eigen::Vector2d size_m = Eigen::Vector2d::Zero();    // length (x), width (y) of the sole
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();  // of the sole rectangle, in the sole frame
  // Force cells in the sole frame: FL, FR, RL, RR. A foot without cells is spoken of as if it had them.
  std::array<Eigen::Vector2d, 4> cell_m{};
  FootSensor sensor = FootSensor::cells;
  // Of a six-axis sensor, in the foot's link. It is tared with the foot hanging level, and tells what the
  // ground does to the foot: a positive force z presses it upwards.
  Eigen::Isometry3d sensor_pose = Eigen::Isometry3d::Identity();

  // Of the sole, counter-clockwise: in its own frame, or as it lies on the ground at `pose` (x, y, yaw).
  [[nodiscard]] std::array<Eigen::Vector2d, 4> corners_m() const noexcept;
  [[nodiscard]] std::array<Eigen::Vector2d, 4> corners_m(const Eigen::Vector3d& pose) const noexcept;

  // [N], of four cells of equal stiffness under a rigid plate that carries this force at this place of the
  // sole frame: their sum and moments are the force's. One far behind the place is negative, as a preloaded
  // cell is.
  [[nodiscard]] std::array<double, 4> cell_forces_N(double force_N,
                                                    const Eigen::Vector2d& place_m) const noexcept;
  // The same of what a six-axis sensor says, in its own frame.
  [[nodiscard]] std::array<double, 4> cell_forces_N(const Wrench& sensed) const noexcept;
};

// One leg as the kinematics sees it: six joints from the base to the foot. What each does: LegJoints.
struct Leg {
  std::array<int, 6> joints{};  // indices: three of the hip, the knee, two of the ankle
};

// What an inclinometer tells. A pendulum, as an accelerometer, takes each acceleration of the body for a
// tilt; a module that fuses it with a gyro of its own tells roll and pitch against gravity.
enum class Inclinometer : std::uint8_t { fused, pendulum };

struct Imu {
  int link = 0;
  Inclinometer inclinometer = Inclinometer::fused;         // if it carries one
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // sensor frame in the link, as described

  // From the calibration: what each sensor says along the link's axes is turned by this much, so that a trunk
  // that stands upright is told to.
  struct Levelling {
    Eigen::Matrix3d gyro = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d accelerometer = Eigen::Matrix3d::Identity();
    Eigen::Matrix3d inclinometer = Eigen::Matrix3d::Identity();
  };
  Levelling levelling = {};

  // What gyro and accelerometer feel along the sensor's own axes, along the link's; roll and pitch against
  // gravity likewise. Exactly the same where the axes are.
  [[nodiscard]] Eigen::Vector3d angular_velocity_in_link(
      const Eigen::Vector3d& along_own_axes) const noexcept;
  [[nodiscard]] Eigen::Vector3d specific_force_in_link(const Eigen::Vector3d& along_own_axes) const noexcept;
  [[nodiscard]] Eigen::Vector2d tilt_in_link(const Eigen::Vector2d& own_tilt_rad) const noexcept;
};

struct SensorNoise {  // standard deviations, for the simulated robot
  double angular_velocity_rad_per_s = 0.0;
  double acceleration_m_per_s2 = 0.0;
  double inclination_rad = 0.0;
  double force_N = 0.0;
  double torque_Nm = 0.0;
};

struct Contact {  // how the feet touch the ground, for the simulated robot
  double friction = 0.0;
};

struct TrimSettings {
  double count_rad = 0.0;
  double slew_rad_per_s = 0.0;
  double limit_rad = 0.0;
};

// A message of the bus for which the network file wants something else than its profile.
struct MessageSetting {
  std::string message;  // e.g. "trajectory"
  int line = 0;         // of the network file
  std::optional<int> id;
  std::optional<double> period_s;
  std::optional<double> deadline_s;
};

// What goes over the bus. What it means is the message network's affair (msgcontroller/network_profile.hpp).
struct NetworkSettings {
  std::string profile = "full";
  int line = 0;  // of the network file; 0: it says nothing
  std::vector<MessageSetting> messages;
  // How many frames each joint has for the points after its batch, of eight points each; 0: none. Nothing: as
  // many as the gait of a body of this size needs, and the bus can carry.
  std::optional<int> tail_parts;
};

struct RobotModel {
  std::string name;
  std::filesystem::path directory;
  std::vector<Link> links;    // links[0] is the base (pelvis); parents come before children
  std::vector<Joint> joints;  // parents before children; this order is the order of every joint array
  std::vector<std::array<SensorChannel, 2>> channels;  // for each joint, what its feedback frame carries
  std::array<Foot, 2> feet;                            // [Side]
  std::array<Leg, 2> legs;                             // [Side]
  Imu imu;
  SensorNoise noise;
  // Of the simulated robot: scales what IMU, motors, servos, soles and play differ by from their description.
  double parts_deviation = 0.0;
  Contact contact;
  TrimSettings trim;
  NetworkSettings network;
  double physics_step_s = 0.001;
  double hip_height_m = 0.0;  // of the hip axes above the ground in the standing posture
  // From the calibration, and in links[imu.link].com_m already.
  Eigen::Vector3d trunk_com_offset_m = Eigen::Vector3d::Zero();
  // Same joints and links; segments bear the links' names. KDL's root segment has no inertia: the base's mass
  // is in links[0] alone.
  KDL::Tree tree;

  [[nodiscard]] double total_mass_kg() const noexcept;
  [[nodiscard]] std::vector<std::filesystem::path> mesh_files() const;  // of all shapes, each once
  [[nodiscard]] bool carries(SensorKind kind) const noexcept;           // any channel of this kind
  // An inclinometer against gravity, whatever the body does: not a pendulum.
  [[nodiscard]] bool senses_tilt() const noexcept;
  // Both feet have the same kind of sensor.
  [[nodiscard]] bool senses_load() const noexcept { return feet[0].sensor != FootSensor::none; }
  [[nodiscard]] facts::BodyScale body_scale() const noexcept { return {hip_height_m, total_mass_kg()}; }
  [[nodiscard]] int joint_index(std::string_view name) const;  // throws RobotError, names the nearest joint
  [[nodiscard]] int link_index(std::string_view name) const;
  [[nodiscard]] std::optional<int> joint_of_node(int node) const noexcept;
};

// What becomes of <directory>/calibration.yaml, if there is one.
enum class CalibrationUse : std::uint8_t { applied, left_out };

// Loads <directory>/robot.urdf, <directory>/robot.yaml and, if there is one, <directory>/calibration.yaml.
// Throws RobotError.
RobotModel load_robot(const std::filesystem::path& directory,
                      CalibrationUse calibration = CalibrationUse::applied);

// Names of the sensor channels in a network file, such as left_cell_front_right or angular_velocity_z.
//
struct NamedChannel {
  std::string name;
  SensorChannel channel;  // scale 1
};

// Every channel that a robot can have: 4 force cells or a six-axis sensor, and 3 accelerations, a foot; gyro,
// accelerometer, inclinometer.
[[nodiscard]] const std::vector<NamedChannel>& all_channels();

[[nodiscard]] std::string channel_name(const SensorChannel& channel);  // "none" for none

}  // namespace gaitway::urdf
