// A robot as its maker's URDF describes it: links with mass and surfaces, joints that turn. Fixed joints are
// merged, meshes are read, and nothing is guessed or left out without a note.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gaitway::importer {

// Triangles of one visual or collision element, in its link's frame. Boxes, cylinders and spheres are
// triangles, too.
struct Surface {
  std::vector<Eigen::Vector3d> point_m;
  std::vector<std::array<int, 3>> triangle;  // indices into point_m, counter-clockwise from outside
  std::string source;                        // "box", "cylinder", "sphere", "capsule" or the mesh's path
};

struct VisualSurface {
  Surface surface;
  Eigen::Vector4d rgba = {0.7, 0.7, 0.7, 1.0};  // 0..1
};

struct MakerLink {
  std::string name;
  int line = 0;
  int parent_joint = -1;                                    // index into MakerRobot::joints; -1 for the root
  double mass_kg = 0.0;                                     // 0: the file says nothing of it
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();          // in the link's frame
  Eigen::Matrix3d inertia_kg_m2 = Eigen::Matrix3d::Zero();  // about the CoM, axes of the link's frame
  std::vector<VisualSurface> visual;
  std::vector<Surface> collision;
  // Pose in this link of every link that was merged into it: soles, sensors and tools among them.
  std::map<std::string, Eigen::Isometry3d> frames;
};

struct MakerJoint {
  std::string name;
  int line = 0;
  int parent_link = 0, child_link = 0;                       // indices into MakerRobot::links
  Eigen::Isometry3d origin = Eigen::Isometry3d::Identity();  // in the parent link's frame, at zero
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();           // unit, in the joint's frame
  // What the file says; none: a continuous joint has no limits, and zeros stand for "unknown" in many files.
  std::optional<double> lower_rad, upper_rad;
  bool is_continuous = false;  // by its type: it has no limits, whatever else is written of them
  std::optional<double> velocity_rad_per_s, effort_Nm;
  std::optional<double> damping_Nms_per_rad, friction_Nm;
};

struct MakerRobot {
  std::filesystem::path file;
  std::string name;
  std::vector<MakerLink> links;    // links[0] is the root; parents come before children
  std::vector<MakerJoint> joints;  // joints[i] carries links[i + 1]; all turn
  std::vector<std::string> notes;  // what was done to the description, a sentence each

  [[nodiscard]] std::optional<int> joint_index(const std::string& name) const noexcept;
};

struct ReadOptions {
  // Folders in which `package://NAME/rest` is looked for, as NAME/rest and as rest; besides them the folders
  // above the URDF and those that ROS_PACKAGE_PATH names.
  std::vector<std::filesystem::path> package_folders;
};

// Reads a maker's URDF (expanded, no xacro) with the meshes that it names. Fixed joints are merged; prismatic
// and mimicking joints are held still at zero and noted; a root without mass that a fixed, floating or planar
// joint carries gives way to its child. A mesh that is not found is noted and left out. Throws
// input::InputError with file, line, element, value, rule and remedy for what is no URDF (unexpanded xacro
// among it), loops, several roots, numbers that are none.
[[nodiscard]] MakerRobot read_maker_urdf(const std::filesystem::path& file, const ReadOptions& options);

// The same robot with some joints held still: joints[i] at `held[i]` rad where that is given. Their links
// become one with the links that carry them: mass, inertia, surfaces and frames.
[[nodiscard]] MakerRobot hold_still(const MakerRobot& robot, const std::vector<std::optional<double>>& held);

// Pose of every link in the root's frame at these joint angles (MakerRobot::joints' order).
[[nodiscard]] std::vector<Eigen::Isometry3d> link_poses(const MakerRobot& robot,
                                                        const std::vector<double>& angle_rad);

// The convex hull of a surface's points, of at most `most_points` points (the farthest in evenly spread
// directions, where the hull has more). Throws std::invalid_argument for points that span no volume.
[[nodiscard]] Surface convex_hull(const Surface& surface, std::size_t most_points);

// Binary STL. Throws std::system_error naming the file.
void write_stl(const std::filesystem::path& file, const Surface& surface);

}  // namespace gaitway::importer
