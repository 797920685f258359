// Surfaces as triangles: of meshes, of the shapes that URDF knows, and moved.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "gaitway/importer/maker_robot.hpp"

namespace gaitway::importer {

struct Mesh {
  Surface surface;
  std::optional<Eigen::Vector4d> rgba;  // of most of its triangles, where the file says it
  bool says_y_up = false;               // a DAE that names y as its up-axis
};

// What becomes of a DAE that names y as its up-axis: most consumers of URDFs take its coordinates as they
// are, some turn them about x, and makers go by the one that they use.
enum class YUp : std::uint8_t { as_it_is, turned };

// STL, OBJ or DAE; DAE's unit is applied. Equal points become one. Throws std::runtime_error with the reason.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& file, YUp y_up = YUp::as_it_is);

// The most points and triangles that read_mesh() takes of one file.
inline constexpr std::size_t kMostMeshPoints = 2'000'000;

// Shapes around the origin; axes along z.
[[nodiscard]] Surface box_surface(const Eigen::Vector3d& size_m);
[[nodiscard]] Surface cylinder_surface(double radius_m, double length_m);
[[nodiscard]] Surface sphere_surface(double radius_m);
// A cylinder of that length with half a sphere on each end.
[[nodiscard]] Surface capsule_surface(double radius_m, double length_m);

// What mirrors turns the triangles around, so that they still face outwards.
void move_surface(Surface& surface, const Eigen::Affine3d& pose);

}  // namespace gaitway::importer
