// Support points of boxes, cylinders, balls and meshes.
#include "gaitway/kinematic/convex_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>

namespace gaitway::kinematic {
namespace {

constexpr int kDirections = 256;

// Evenly over the sphere: Fibonacci's lattice.
Eigen::Vector3d direction_of(int index) {
  const double z = 1.0 - (2.0 * index + 1.0) / kDirections;
  const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0)) * index;
  const double ring = std::sqrt(1.0 - z * z);
  return {ring * std::cos(turn), ring * std::sin(turn), z};
}

// The corners of a binary STL's triangles, scaled, about the middle of the mesh.
std::vector<Eigen::Vector3d> mesh_points_m(const urdf::Mesh& mesh) {
  constexpr std::size_t kHeader_bytes = 84, kTriangle_bytes = 50, kNormal_bytes = 12;
  std::ifstream in(mesh.file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::uint32_t count = 0;
  if (bytes.size() >= kHeader_bytes) std::memcpy(&count, bytes.data() + kHeader_bytes - 4, 4);
  if (count == 0 || bytes.size() < kHeader_bytes + std::size_t{count} * kTriangle_bytes) {
    input::refuse({.file = mesh.file,
                   .line = 0,
                   .field = "mesh",
                   .value = fmt::format("{} bytes", bytes.size()),
                   .rule = "must be a binary STL with at least one triangle",
                   .remedy = "Write the mesh again"});
  }
  std::vector<Eigen::Vector3d> points;
  for (std::size_t corner = 0; corner < std::size_t{3} * count; ++corner) {
    std::array<float, 3> place{};
    std::memcpy(place.data(),
                bytes.data() + kHeader_bytes + corner / 3 * kTriangle_bytes + kNormal_bytes +
                    corner % 3 * sizeof place,
                sizeof place);
    const Eigen::Vector3d unscaled(place[0], place[1], place[2]);
    points.push_back(mesh.scale.cwiseProduct(unscaled) - mesh.centre_m);
  }
  return points;
}

std::vector<Eigen::Vector3d> outermost(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> kept;
  for (int i = 0; i < kDirections; ++i) {
    const Eigen::Vector3d direction = direction_of(i);
    const Eigen::Vector3d& point = *std::ranges::max_element(
        points, {}, [&direction](const Eigen::Vector3d& candidate) { return candidate.dot(direction); });
    if (std::ranges::find(kept, point) == kept.end()) kept.push_back(point);
  }
  return kept;
}

}  // namespace

ConvexShape::ConvexShape(const urdf::Shape& shape) : kind_(shape.kind), half_m_(0.5 * shape.size_m) {
  if (kind_ == urdf::Shape::Kind::mesh) points_m_ = outermost(mesh_points_m(shape.mesh));
  for (const Eigen::Vector3d& point : points_m_) radius_m_ = std::max(radius_m_, point.norm());
  if (points_m_.empty()) {
    radius_m_ = kind_ == urdf::Shape::Kind::sphere     ? half_m_.x()
                : kind_ == urdf::Shape::Kind::cylinder ? std::hypot(half_m_.x(), half_m_.z())
                                                       : half_m_.norm();
  }
}

Eigen::Vector3d ConvexShape::furthest_m(const Eigen::Vector3d& direction) const noexcept {
  switch (kind_) {
    case urdf::Shape::Kind::sphere:
      return half_m_.x() * direction.normalized();
    case urdf::Shape::Kind::cylinder: {
      const double across = direction.head<2>().norm();
      const double share = across > 0.0 ? half_m_.x() / across : 0.0;
      return {share * direction.x(), share * direction.y(), std::copysign(half_m_.z(), direction.z())};
    }
    case urdf::Shape::Kind::box:
      return {std::copysign(half_m_.x(), direction.x()), std::copysign(half_m_.y(), direction.y()),
              std::copysign(half_m_.z(), direction.z())};
    case urdf::Shape::Kind::mesh:
      break;
  }
  return *std::ranges::max_element(
      points_m_, {}, [&direction](const Eigen::Vector3d& point) { return point.dot(direction); });
}

}  // namespace gaitway::kinematic
