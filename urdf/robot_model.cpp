// Sums and look-ups in a robot model.
#include "gaitway/urdf/robot_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "gaitway/geometry/tilt.hpp"
#include "gaitway/input/complaint.hpp"

namespace gaitway::urdf {
namespace {

// Index of the entry with this name; throws RobotError naming the nearest.
template <typename Entry>
int index_of(const std::vector<Entry>& entries, std::string_view name, const std::string& robot,
             std::string_view what) {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [name](const Entry& entry) { return entry.name == name; });
  if (found != entries.end()) {
    return static_cast<int>(found - entries.begin());
  }
  std::vector<std::string> names;
  for (const Entry& entry : entries) {
    names.push_back(entry.name);
  }
  throw RobotError(
      fmt::format("robot '{}' has no {} '{}'. {}", robot, what, name, input::suggest(name, names)));
}

}  // namespace

std::array<Eigen::Vector2d, 4> Foot::corners_m() const noexcept {
  std::array<Eigen::Vector2d, 4> corners;
  const std::array<Eigen::Vector2d, 4> share{{{0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}}};
  for (std::size_t i = 0; i < 4; ++i) corners[i] = centre_m + size_m.cwiseProduct(share[i]);
  return corners;
}

std::array<Eigen::Vector2d, 4> Foot::corners_m(const Eigen::Vector3d& pose) const noexcept {
  auto corners = corners_m();
  for (auto& corner : corners) corner = pose.head<2>() + Eigen::Rotation2Dd(pose.z()) * corner;
  return corners;
}

// f_i = F/4 + a·(x_i − x_c) + b·(y_i − y_c)
std::array<double, 4> Foot::cell_forces_N(double force_N, const Eigen::Vector2d& place_m) const noexcept {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& cell : cell_m) {
    centre += cell / 4.0;
  }
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& cell : cell_m) {
    spread += (cell - centre) * (cell - centre).transpose();
  }
  const Eigen::Vector2d slope = spread.inverse() * (force_N * (place_m - centre));
  std::array<double, 4> forces_N{};
  for (std::size_t i = 0; i < cell_m.size(); ++i) {
    forces_N[i] = force_N / 4.0 + slope.dot(cell_m[i] - centre);
  }
  return forces_N;
}

std::array<double, 4> Foot::cell_forces_N(const Wrench& sensed) const noexcept {
  const Eigen::Isometry3d in_sole = sole.inverse() * sensor_pose;
  const Eigen::Vector3d force_N = in_sole.linear() * sensed.head<3>();
  const Eigen::Vector3d torque_Nm =
      in_sole.linear() * sensed.tail<3>() + in_sole.translation().cross(force_N);
  if (force_N.z() == 0.0) return {};
  return cell_forces_N(force_N.z(), Eigen::Vector2d(-torque_Nm.y(), torque_Nm.x()) / force_N.z());
}

bool RobotModel::carries(SensorKind kind) const noexcept {
  return std::ranges::any_of(
      channels, [kind](const auto& joint) { return joint[0].kind == kind || joint[1].kind == kind; });
}

bool RobotModel::senses_tilt() const noexcept {
  return carries(SensorKind::inclination) && imu.inclinometer == Inclinometer::fused;
}

double RobotModel::total_mass_kg() const noexcept {
  double mass_kg = 0.0;
  for (const Link& link : links) {
    mass_kg += link.mass_kg;
  }
  return mass_kg;
}

std::vector<std::filesystem::path> RobotModel::mesh_files() const {
  std::set<std::filesystem::path> files;
  for (const Link& link : links) {
    for (const std::vector<Shape>* shapes : {&link.collision, &link.visual}) {
      for (const Shape& shape : *shapes) {
        if (shape.kind == Shape::Kind::mesh) files.insert(shape.mesh.file);
      }
    }
  }
  return {files.begin(), files.end()};
}

int RobotModel::joint_index(std::string_view joint_name) const {
  return index_of(joints, joint_name, name, "joint");
}

int RobotModel::link_index(std::string_view link_name) const {
  return index_of(links, link_name, name, "link");
}

std::optional<int> RobotModel::joint_of_node(int node) const noexcept {
  const auto found =
      std::find_if(joints.begin(), joints.end(), [node](const Joint& joint) { return joint.node == node; });
  if (found == joints.end()) {
    return std::nullopt;
  }
  return static_cast<int>(found - joints.begin());
}

Eigen::Vector3d Imu::angular_velocity_in_link(const Eigen::Vector3d& along_own_axes) const noexcept {
  return levelling.gyro * (pose.linear() * along_own_axes);
}

Eigen::Vector3d Imu::specific_force_in_link(const Eigen::Vector3d& along_own_axes) const noexcept {
  return levelling.accelerometer * (pose.linear() * along_own_axes);
}

Eigen::Vector2d Imu::tilt_in_link(const Eigen::Vector2d& own_tilt_rad) const noexcept {
  const Eigen::Matrix3d turn = levelling.inclinometer * pose.linear();
  if (turn.isIdentity(0.0)) return own_tilt_rad;
  return geometry::tilt_at_rest(turn * geometry::up_at_tilt(own_tilt_rad));
}

}  // namespace gaitway::urdf
