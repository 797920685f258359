// The shipped robot is loaded as its figures say.
#include <gtest/gtest.h>
#include "gaitway/urdf/robot_model.hpp"
namespace gaitway::urdf {
TEST(Humanoid22, Loads) {
  const RobotModel robot = load_robot(std::filesystem::path(GAITWAY_URDF_DIR) / "humanoid22");
  EXPECT_EQ(robot.joints.size(), 22u);
  EXPECT_NEAR(robot.total_mass_kg(), 6.84, 1e-12);
}
}  // namespace gaitway::urdf
