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
  const auto check_size = [&](const char* field, const Eigen::Isometry3d& pose, const Eigen::Vector3d& size) {
    if (!(size.minCoeff() > 0.0) || size.maxCoeff() > kLargestLength_m ||
        pose.translation().norm() > kLargestLength_m) {
      complain(field, fmt::format("{:g} x {:g} x {:g} m", size.x(), size.y(), size.z()),
               fmt::format("each edge must be above 0 and at most {:g} m, and so near", kLargestLength_m),
               "Write lengths in metres");
    }
  };
  for (const BoxShape& box : link.collision) {
    check_size("collision", box.pose, box.size_m);
  }
  for (const VisualShape& shape : link.visual) {
    check_size("visual", shape.pose, shape.size_m);
  }
}

}  // namespace gaitway::urdf
