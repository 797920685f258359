// Depths that are known: balls, boxes along their axes, and turned boxes by their separating axes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "gaitway/kinematic/convex_shape.hpp"

namespace gaitway::kinematic {
namespace {

using Kind = urdf::Shape::Kind;

ConvexShape shape(Kind kind, const Eigen::Vector3d& size_m) {
  urdf::Shape shape;
  shape.kind = kind;
  shape.size_m = size_m;
  return ConvexShape(shape);
}
Eigen::Isometry3d at(const Eigen::Vector3d& place_m) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = place_m;
  return pose;
}

TEST(Penetration, OfBallsIsWhatTheirRadiiHaveLeftOfTheirDistance) {
  const ConvexShape large = shape(Kind::sphere, Eigen::Vector3d::Constant(0.2)),
                    small = shape(Kind::sphere, Eigen::Vector3d::Constant(0.1));
  const Eigen::Vector3d way = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
  for (const double distance : {0.01, 0.05, 0.1, 0.14, 0.149}) {
    const double depth = penetration_m({&large, at(Eigen::Vector3d::Zero())}, {&small, at(distance * way)});
    EXPECT_LE(depth, 0.15 - distance + 1e-6) << distance;
    EXPECT_GE(depth, 0.95 * (0.15 - distance)) << distance;
  }
  EXPECT_EQ(penetration_m({&large, at(Eigen::Vector3d::Zero())}, {&small, at(0.151 * way)}), 0.0);
}

TEST(Penetration, OfBoxesAlongTheirAxesIsTheLeastOverlap) {
  const ConvexShape box = shape(Kind::box, {0.2, 0.1, 0.4});
  EXPECT_NEAR(penetration_m({&box, at(Eigen::Vector3d::Zero())}, {&box, at({0.17, 0.02, 0.1})}), 0.03, 1e-6);
  EXPECT_NEAR(penetration_m({&box, at(Eigen::Vector3d::Zero())}, {&box, at({0.05, 0.06, 0.1})}), 0.04, 1e-6);
  EXPECT_NEAR(penetration_m({&box, at(Eigen::Vector3d::Zero())}, {&box, at(Eigen::Vector3d::Zero())}), 0.1,
              1e-6)
      << "in the same place";
  EXPECT_EQ(penetration_m({&box, at(Eigen::Vector3d::Zero())}, {&box, at({0.2001, 0.0, 0.0})}), 0.0);
  EXPECT_NEAR(penetration_m({&box, at(Eigen::Vector3d::Zero())}, {&box, at({0.2, 0.0, 0.0})}), 0.0, 1e-6)
      << "they touch";
}

TEST(Penetration, OfAStandingCylinderInAFloorIsItsDepthThere) {
  const ConvexShape floor = shape(Kind::box, {2.0, 2.0, 0.2}), post = shape(Kind::cylinder, {0.1, 0.1, 0.3});
  EXPECT_NEAR(penetration_m({&post, at({0.1, 0.2, 0.24})}, {&floor, at(Eigen::Vector3d::Zero())}), 0.01,
              1e-5);
  Eigen::Isometry3d lying = at({0.1, 0.2, 0.14});
  lying.linear() = Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitX()).toRotationMatrix();
  EXPECT_NEAR(penetration_m({&post, lying}, {&floor, at(Eigen::Vector3d::Zero())}), 0.01, 1e-5);
  lying.translation().z() = 0.151;
  EXPECT_EQ(penetration_m({&post, lying}, {&floor, at(Eigen::Vector3d::Zero())}), 0.0);
}

// Of two boxes the depth is the least overlap over their 15 axes (S. Gottschalk, M. C. Lin, D. Manocha,
// 1996).
double overlap_m(const Eigen::Vector3d& half_a, const Eigen::Isometry3d& a, const Eigen::Vector3d& half_b,
                 const Eigen::Isometry3d& b) {
  std::vector<Eigen::Vector3d> axes;
  for (int i = 0; i < 3; ++i) {
    axes.emplace_back(a.linear().col(i));
    axes.emplace_back(b.linear().col(i));
    for (int j = 0; j < 3; ++j) axes.emplace_back(a.linear().col(i).cross(b.linear().col(j)));
  }
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Vector3d axis : axes) {
    if (axis.norm() < 1e-9) continue;
    axis.normalize();
    const double reach = half_a.dot((a.linear().transpose() * axis).cwiseAbs()) +
                         half_b.dot((b.linear().transpose() * axis).cwiseAbs());
    least = std::min(least, reach - std::abs(axis.dot(a.translation() - b.translation())));
  }
  return std::max(0.0, least);
}

TEST(Penetration, OfTurnedBoxesIsThatOfTheirSeparatingAxes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> side(0.02, 0.3), place(-0.2, 0.2), turn(-1.0, 1.0);
  int apart = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Eigen::Vector3d first(side(random), side(random), side(random)),
        second(side(random), side(random), side(random));
    std::array<Eigen::Isometry3d, 2> pose;
    for (Eigen::Isometry3d& one : pose) {
      one = at({place(random), place(random), place(random)});
      one.linear() = Eigen::Quaterniond(turn(random), turn(random), turn(random), turn(random))
                         .normalized()
                         .toRotationMatrix();
    }
    const ConvexShape a = shape(Kind::box, first), b = shape(Kind::box, second);
    const double expected = overlap_m(0.5 * first, pose[0], 0.5 * second, pose[1]);
    EXPECT_NEAR(penetration_m({&a, pose[0]}, {&b, pose[1]}), expected, 1e-5) << "trial " << trial;
    EXPECT_NEAR(penetration_m({&b, pose[1]}, {&a, pose[0]}), expected, 1e-5)
        << "the other way round, " << trial;
    apart += expected == 0.0 ? 1 : 0;
  }
  EXPECT_GT(apart, 200) << "both cases are met";
  EXPECT_LT(apart, 1800);
}

TEST(Penetration, OfAMeshIsThatOfItsHull) {
  const auto file = std::filesystem::temp_directory_path() / "gaitway_penetration_test.stl";
  std::ofstream out(file, std::ios::binary);
  out << std::string(80, '\0');
  const std::uint32_t count = 2;
  out.write(reinterpret_cast<const char*>(&count), 4);
  // A tetrahedron's four corners, as two triangles have them; about its bounding box's middle.
  const std::array<float, 18> corners{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  for (std::size_t t = 0; t < 2; ++t) {
    out << std::string(12, '\0');
    out.write(reinterpret_cast<const char*>(corners.data() + 9 * t), 36);
    out << std::string(2, '\0');
  }
  out.close();
  urdf::Shape mesh;
  mesh.kind = Kind::mesh;
  mesh.mesh = {.file = file, .scale = Eigen::Vector3d::Ones(), .centre_m = Eigen::Vector3d::Constant(0.5)};
  const ConvexShape tetrahedron(mesh);
  const ConvexShape box = shape(Kind::box, Eigen::Vector3d::Ones());
  // Its foot is at z = -0.5 of its own frame.
  EXPECT_NEAR(penetration_m({&tetrahedron, at({0.0, 0.0, 0.98})}, {&box, at(Eigen::Vector3d::Zero())}), 0.02,
              1e-5);
  // Its slanted side is 0.5 * sqrt(3) * (1 - 2/3) from the middle of the box that it fills: beyond it there
  // is nothing.
  EXPECT_EQ(
      penetration_m({&tetrahedron, at(Eigen::Vector3d::Zero())}, {&box, at(Eigen::Vector3d::Constant(0.51))}),
      0.0);
  std::filesystem::remove(file);
  EXPECT_THROW(ConvexShape{mesh}, urdf::RobotError);
}

}  // namespace
}  // namespace gaitway::kinematic
