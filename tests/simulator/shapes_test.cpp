// Robots whose links are cylinders, spheres and meshes stand on them, lie on them and are seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/simulator/camera.hpp"
#include "home_servo.hpp"
#include "robots/mesh_files.hpp"
#include "urdf/broken_robot.hpp"

namespace gaitway::simulator {
namespace {

using gaitway::test::box_triangles;
using gaitway::test::stl_bytes;
using gaitway::test::write_file;

constexpr const char* kUrdf = "robot.urdf";
// humanoid22's feet; their middle is 10 mm ahead of the ankle and 35 mm below it.
constexpr const char* kFootTouches = "<box size=\"0.135 0.085 0.01\"/>";

class ShapedRobotTest : public ::testing::Test {
 protected:
  void touch_with(const std::string& geometry) {
    for (const std::string foot : {"left_foot", "right_foot"}) {
      robot_.replace(kUrdf, "<link name=\"" + foot, "<collision>", "<collision><!--" + foot + "-->");
      robot_.replace(kUrdf, "<!--" + foot + "-->", kFootTouches, geometry);
    }
  }
  void write_foot(const std::array<float, 3>& centre) const {
    write_file(robot_.folder() / "meshes/foot.stl",
               stl_bytes(box_triangles({0.135F, 0.085F, 0.01F}, centre)));
  }
  // It stands for two seconds as one with box feet does.
  void expect_stands() const {
    const urdf::RobotModel model = robot_.load();
    Plant plant(model, exact_);
    HomeServo(model).hold(plant, 2000);
    EXPECT_FALSE(plant.fallen());
    EXPECT_LT(plant.truth().trunk_tilt_rad, 0.01);
    const GroundContact& contact = plant.ground_contact();
    EXPECT_NEAR(contact.normal_force_N[0] + contact.normal_force_N[1],
                model.total_mass_kg() * facts::kGravity_m_per_s2, 0.2);
    EXPECT_LT((plant.truth().cop_m - plant.truth().com_m).head<2>().norm(), 0.002);
    for (const Eigen::Isometry3d& sole : contact.sole) EXPECT_NEAR(sole.translation().z(), 0.0, 0.001);
  }

  urdf::test::BrokenRobot robot_;
  PlantOptions exact_{.seed = 1, .mismatch = 0.0, .sensor_noise = false};
};

TEST_F(ShapedRobotTest, StandsOnMeshFeet) {
  write_foot({});
  touch_with("<mesh filename=\"meshes/foot.stl\"/>");
  expect_stands();
}

TEST_F(ShapedRobotTest, AMeshLiesWhereItsFileSaysAndNotAtItsMiddle) {
  write_foot({0.0F, 0.0F, 0.01F});  // 10 mm higher than the soles
  touch_with("<mesh filename=\"meshes/foot.stl\"/>");
  const urdf::RobotModel model = robot_.load();
  Plant plant(model, exact_);
  HomeServo(model).hold(plant, 500);
  for (const Eigen::Isometry3d& sole : plant.ground_contact().sole) {
    EXPECT_NEAR(sole.translation().z(), -0.01, 0.001) << "it has come down by as much";
  }
}

TEST_F(ShapedRobotTest, AMeshThatIsHollowBelowStandsOnTheEdgesOfItsHull) {
  std::vector<gaitway::test::Triangle> triangles = box_triangles({0.135F, 0.085F, 0.01F});
  for (gaitway::test::Triangle& triangle : triangles) {
    if (triangle[0][2] < 0.0F && triangle[1][2] < 0.0F && triangle[2][2] < 0.0F) {
      triangle = box_triangles({0.1F, 0.06F, 0.004F}).front();
    }
  }
  write_file(robot_.folder() / "meshes/foot.stl", stl_bytes(triangles));
  touch_with("<mesh filename=\"meshes/foot.stl\"/>");
  expect_stands();
}

TEST_F(ShapedRobotTest, StandsOnRoundFeet) {
  touch_with("<cylinder radius=\"0.05\" length=\"0.01\"/>");
  expect_stands();
}

TEST_F(ShapedRobotTest, LiesOnASphere) {
  robot_.replace(kUrdf, "<link name=\"trunk\"", "<collision>", "<collision><!--trunk-->");
  robot_.replace(kUrdf, "<!--trunk-->", "<box size=\"0.11 0.18 0.2\"/>", "<sphere radius=\"0.15\"/>");
  const urdf::RobotModel model = robot_.load();
  Plant plant(model, exact_);
  const std::vector<double> no_torque(model.joints.size(), 0.0);
  for (int ms = 0; ms < 4000; ++ms) plant.step(no_torque);
  const urdf::Shape& sphere =
      model.links[static_cast<std::size_t>(model.link_index("trunk"))].collision.front();
  EXPECT_GT((plant.truth().trunk * sphere.pose).translation().z(), 0.145)
      << "no point of it is in the ground";
  EXPECT_GT(plant.ground_contact().trunk_force_N, 0.0);
}

TEST_F(ShapedRobotTest, AMeshIsSeenInItsColour) {
  write_file(robot_.folder() / "meshes/flag.stl", stl_bytes(box_triangles({0.3F, 0.3F, 0.3F})));
  robot_.replace(kUrdf, "<link name=\"trunk\"", "<visual>",
                 "<visual><geometry><mesh filename=\"meshes/flag.stl\"/></geometry>"
                 "<material name=\"flag\"><color rgba=\"1 0 0 1\"/></material></visual><visual>");
  const auto red_pixels = [this](const urdf::RobotModel& model) {
    const Plant plant(model, exact_);
    Camera camera(plant, 160, 120);
    const Image image = camera.render({plant.positions().begin(), plant.positions().end()});
    int red = 0;
    for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
      red += image.rgb[i] > 100 && image.rgb[i + 1] < 40 && image.rgb[i + 2] < 40 ? 1 : 0;
    }
    return red;
  };
  EXPECT_EQ(red_pixels(humanoid22()), 0);
  EXPECT_GT(red_pixels(robot_.load()), 100);
}

}  // namespace
}  // namespace gaitway::simulator
