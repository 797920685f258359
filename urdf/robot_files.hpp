// The files of a robot's folder, each read and checked on its own, and what must hold between them: what
// robot_loader.cpp makes one RobotModel of. All functions throw RobotError with file, line, value and rule.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

// Lines (from 1) of the elements of a URDF, by name.
struct UrdfLines {
  std::map<std::string, int> link;
  std::map<std::string, int> joint;
  // Of the shapes within each link's collision and visual elements.
  std::map<std::string, std::vector<int>> collision;
  std::map<std::string, std::vector<int>> visual;
};

// urdfdom itself neither tells lines nor minds misspelt elements. Checks that the text is well-formed XML and
// holds nothing but what this loader understands: known elements and attributes, numbers where numbers
// belong, each link and joint name once.
[[nodiscard]] UrdfLines check_urdf_syntax(const std::filesystem::path& file, const std::string& text);

// robot.urdf.
struct UrdfJoint {
  Joint joint;  // geometry and limits; link indices and the network's part are still empty
  std::string parent_link, child_link;
  double effort_limit_Nm = 0.0;
  int line = 0;
};

struct UrdfFile {
  std::filesystem::path file;
  std::string name;
  std::string base_link;
  std::vector<Link> links;  // in the order of their names
  std::vector<UrdfJoint> joints;
  UrdfLines lines;
};

[[nodiscard]] UrdfFile read_urdf_file(const std::filesystem::path& file);

// Completes a shape whose pose is that of the mesh's own frame and whose scale is known: file, size, centre.
// `field` names the element in refusals.
enum class MeshUse : std::uint8_t { collision, visual };
void read_mesh(const std::filesystem::path& urdf, int line, const std::string& field,
               const std::string& filename, MeshUse use, Shape& shape);

// robot.yaml; names of joints and links are not yet resolved.
struct NetworkJoint {
  Joint joint;  // name and what the network file says; the rest is still empty
  std::array<SensorChannel, 2> channels;
  int line = 0;
};

struct NetworkFile {
  std::filesystem::path file;
  std::vector<NetworkJoint> joints;
  std::array<std::vector<std::string>, 2> leg_joints;  // [Side]
  std::array<int, 2> leg_line{};
  std::array<Foot, 2> feet;  // [Side]; link not resolved
  std::array<std::string, 2> foot_link;
  std::array<int, 2> foot_line{};
  Imu imu;  // link not resolved
  std::string imu_link;
  int imu_line = 0;
  SensorNoise noise;
  double parts_deviation = 0.0;
  Contact contact;
  TrimSettings trim;
  NetworkSettings network;
  double physics_step_s = 0.0;
  double hip_height_m = 0.0;
  int hip_height_line = 0;
};

[[nodiscard]] NetworkFile read_network_file(const std::filesystem::path& file);

// calibration.yaml, what is known of one robot beyond what its kind's description says: puts joint zeros, the
// trunk's centre of mass, force cells' gains and the IMU's tilts into a model that has none of them yet. What
// the file does not name stays as described.
void apply_calibration_file(const std::filesystem::path& file, RobotModel& model);

// Physical mass and inertia, plausible dimensions.
void check_link(const UrdfFile& urdf, const Link& link);

// Axis, origin and limits in the URDF.
void check_geometry(const UrdfFile& urdf, const UrdfJoint& joint);

// URDF and network file together: motor and wire can do what the limits allow.
void check_drive(const UrdfFile& urdf, const UrdfJoint& geometry, const NetworkFile& network,
                 const NetworkJoint& drive);

}  // namespace gaitway::urdf
