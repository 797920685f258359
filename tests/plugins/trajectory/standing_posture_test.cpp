// The pattern's numbers come from the robot's own description.
#include "gaitway/trajectory/standing_posture.hpp"

#include <gtest/gtest.h>

namespace gaitway::trajectory {
namespace {

TEST(StandingPosture, HumanoidStandsAsItsDescriptionSays) {
  const auto robot = urdf::load_robot(GAITWAY_ROBOTS "/humanoid22");
  const GaitParameters p = with_standing_posture({}, robot);
  EXPECT_NO_THROW(p.validate());
  EXPECT_EQ(p.hip_height_m, robot.hip_height_m);
  EXPECT_NEAR(p.foot_spacing_m, 0.100, 0.005);
  EXPECT_NEAR(p.com_height_m, 0.378, 0.02);
  EXPECT_NEAR(p.sole.length_m, 0.135, 1e-9);
  std::cout << "CoM height " << p.com_height_m << " m, CoM forward " << p.stand_com_forward_m << " m\n";
}

}  // namespace
}  // namespace gaitway::trajectory
