// Sums and look-ups in a robot model.
#include "gaitway/urdf/robot_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

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

}  // namespace gaitway::urdf
