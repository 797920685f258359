// Mass, inertia and shapes of one link.
#include "robot_files.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>

#include "gaitway/input/complaint.hpp"

namespace gaitway::urdf {
namespace {

constexpr double kLargestMass_kg = 200.0;
constexpr double kLargestLength_m = 2.0;
constexpr double kLargestGyrationRadius_m = 1.0;

void check_shapes(const UrdfFile& urdf, const std::string& link, const char* use,
                  const std::map<std::string, std::vector<int>>& lines, const std::vector<Shape>& shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Shape& shape = shapes[i];
    const bool is_mesh = shape.kind == Shape::Kind::mesh;  // it may be flat
    if (shape.size_m.minCoeff() > (is_mesh ? -1.0 : 0.0) && shape.size_m.maxCoeff() <= kLargestLength_m &&
        shape.pose.translation().norm() <= kLargestLength_m) {
      continue;
    }
    input::refuse(
        {urdf.file, lines.at(link).at(i), fmt::format("link '{}' {}", link, use),
         fmt::format("{:g} x {:g} x {:g} m, {:g} m away", shape.size_m.x(), shape.size_m.y(),
                     shape.size_m.z(), shape.pose.translation().norm()),
         fmt::format("each edge must be above 0 and at most {:g} m, and so near", kLargestLength_m),
         is_mesh ? "Choose the mesh's scale so that lengths are in metres" : "Write lengths in metres"});
  }
}

}  // namespace

void check_link(const UrdfFile& urdf, const Link& link) {
  const auto complain = [&](const std::string& field, const std::string& value, const std::string& rule,
                            const std::string& remedy) {
    input::refuse({urdf.file, urdf.lines.link.at(link.name), fmt::format("link '{}' {}", link.name, field),
                   value, rule, remedy});
  };
  if (!(link.mass_kg > 0.0 && link.mass_kg <= kLargestMass_kg)) {
    complain("mass", fmt::format("{:g} kg", link.mass_kg),
             fmt::format("must be above 0 and at most {:g} kg", kLargestMass_kg),
             "Write the mass in kilograms");
  }
  if (link.com_m.norm() > kLargestLength_m) {
    complain("inertial origin", fmt::format("{:g} m from the link's origin", link.com_m.norm()),
             fmt::format("must be at most {:g} m", kLargestLength_m), "Write lengths in metres");
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(link.inertia_kg_m2, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d principal = solver.eigenvalues();  // ascending
  const std::string value =
      fmt::format("principal moments {:g}, {:g}, {:g} kg·m²", principal[0], principal[1], principal[2]);
  if (!(principal[0] > 0.0)) {
    complain("inertia", value, "must be positive definite",
             "All three principal moments are above 0; check signs and units");
  }
  if (principal[0] + principal[1] < principal[2] * (1.0 - 1e-9)) {
    complain("inertia", value, "two principal moments together are never less than the third",
             "No body has such an inertia; check ixx, iyy, izz");
  }
  if (principal[2] > link.mass_kg * kLargestGyrationRadius_m * kLargestGyrationRadius_m) {
    complain("inertia", value,
             fmt::format("its radius of gyration must be at most {:g} m", kLargestGyrationRadius_m),
             "Write the inertia in kg·m²");
  }
  check_shapes(urdf, link.name, "collision", urdf.lines.collision, link.collision);
  check_shapes(urdf, link.name, "visual", urdf.lines.visual, link.visual);
}

}  // namespace gaitway::urdf
