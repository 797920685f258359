// Boxes, cylinders, spheres and capsules as triangles.
#include <cmath>
#include <numbers>
#include <utility>

#include "surfaces.hpp"

namespace gaitway::importer {
namespace {

constexpr int kCorners = 24;  // around an axis: a circle's area is met to 1.2 %

struct Ring {
  double radius_m = 0.0, z_m = 0.0;
};

// The surface of a body that is round about z: its rings from below, closed by a point at each end.
Surface round_surface(const std::vector<Ring>& rings, double lowest_m, double highest_m) {
  Surface surface;
  surface.point_m.emplace_back(0.0, 0.0, lowest_m);
  for (const Ring& ring : rings) {
    for (int i = 0; i < kCorners; ++i) {
      const double angle_rad = 2.0 * std::numbers::pi * i / kCorners;
      surface.point_m.emplace_back(ring.radius_m * std::cos(angle_rad), ring.radius_m * std::sin(angle_rad),
                                   ring.z_m);
    }
  }
  surface.point_m.emplace_back(0.0, 0.0, highest_m);
  const int last = static_cast<int>(surface.point_m.size()) - 1;
  const int last_ring = last - kCorners;
  for (int i = 0; i < kCorners; ++i) {
    const int next = (i + 1) % kCorners;
    surface.triangle.push_back({0, 1 + next, 1 + i});
    for (int ring = 1; ring < last_ring; ring += kCorners) {
      surface.triangle.push_back({ring + i, ring + next, ring + kCorners + next});
      surface.triangle.push_back({ring + i, ring + kCorners + next, ring + kCorners + i});
    }
    surface.triangle.push_back({last, last_ring + i, last_ring + next});
  }
  return surface;
}

// Rings of half a sphere that is round about z, from its lowest to its highest.
void add_half_sphere(std::vector<Ring>& rings, double radius_m, double centre_z_m, bool is_upper) {
  constexpr int kSteps = kCorners / 4;
  for (int i = 0; i < kSteps; ++i) {
    const double angle_rad = 0.5 * std::numbers::pi * (is_upper ? i : i + 1 - kSteps) / kSteps;
    rings.push_back({radius_m * std::cos(angle_rad), centre_z_m + radius_m * std::sin(angle_rad)});
  }
}

}  // namespace

Surface box_surface(const Eigen::Vector3d& size_m) {
  Surface surface;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d side((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                               (corner & 4) != 0 ? 0.5 : -0.5);
    surface.point_m.emplace_back(side.cwiseProduct(size_m));
  }
  surface.triangle = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  surface.source = "box";
  return surface;
}

Surface cylinder_surface(double radius_m, double length_m) {
  const double half_m = 0.5 * length_m;
  Surface surface = round_surface({{radius_m, -half_m}, {radius_m, half_m}}, -half_m, half_m);
  surface.source = "cylinder";
  return surface;
}

Surface sphere_surface(double radius_m) {
  std::vector<Ring> rings;
  add_half_sphere(rings, radius_m, 0.0, false);
  rings.pop_back();  // the equator is the upper half's
  add_half_sphere(rings, radius_m, 0.0, true);
  Surface surface = round_surface(rings, -radius_m, radius_m);
  surface.source = "sphere";
  return surface;
}

Surface capsule_surface(double radius_m, double length_m) {
  const double half_m = 0.5 * length_m;
  std::vector<Ring> rings;
  add_half_sphere(rings, radius_m, -half_m, false);
  add_half_sphere(rings, radius_m, half_m, true);
  Surface surface = round_surface(rings, -half_m - radius_m, half_m + radius_m);
  surface.source = "capsule";
  return surface;
}

void move_surface(Surface& surface, const Eigen::Affine3d& pose) {
  for (Eigen::Vector3d& point : surface.point_m) {
    point = pose * point;
  }
  if (pose.linear().determinant() < 0.0) {
    for (std::array<int, 3>& corners : surface.triangle) {
      std::swap(corners[1], corners[2]);
    }
  }
}

}  // namespace gaitway::importer
