// Dead reckoning over feet that stand: a robot whose legs take steps, by its kinematics alone.
#include "gaitway/zmp/foot_odometry.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "synthetic_robot.hpp"

namespace gaitway::zmp {
namespace {

class FootOdometryTest : public testing::Test {
 protected:
  // The trunk turned by `yaw_rad` since the start; joints by their names.
  void pose(double yaw_rad, std::initializer_list<std::pair<const char*, double>> joints = {}) {
    std::vector<double> position_rad = test::home_posture(test::humanoid());
    for (const auto& [name, angle_rad] : joints) {
      position_rad[static_cast<std::size_t>(test::humanoid().joint_index(name))] += angle_rad;
    }
    Attitude attitude;
    attitude.yaw_rad = yaw_rad;
    kinematics.update(position_rad, attitude);
  }
  [[nodiscard]] Eigen::Vector2d middle_m() const {
    return 0.5 * (odometry.foot(urdf::Side::left).place_m + odometry.foot(urdf::Side::right).place_m);
  }

  SupportKinematics kinematics{test::humanoid()};
  FootOdometry odometry;
};

TEST_F(FootOdometryTest, BeginsMidwayBetweenTheSolesAlongTheirHeading) {
  pose(0.7);
  odometry.update(kinematics, urdf::Side::right);
  EXPECT_LT(middle_m().norm(), 1e-12);
  EXPECT_NEAR(odometry.foot(urdf::Side::left).yaw_rad, 0.0, 1e-12);
  EXPECT_GT(odometry.foot(urdf::Side::left).place_m.y(), 0.03);
  EXPECT_NEAR(odometry.foot(urdf::Side::left).place_m.x(), 0.0, 1e-9);
  EXPECT_NEAR(odometry.base().place_m.y(), 0.0, 1e-9);
}

// A leg that swings ahead moves its own foot; the load goes over, and the other leg follows: both have gone.
TEST_F(FootOdometryTest, AStepMovesTheFootThatDoesNotBearTheLoad) {
  pose(0.0);
  odometry.update(kinematics, urdf::Side::left);
  const Eigen::Vector2d left_m = odometry.foot(urdf::Side::left).place_m;
  pose(0.0, {{"right_hip_pitch", -0.2}});
  odometry.update(kinematics, urdf::Side::left);
  const double step_m = odometry.foot(urdf::Side::right).place_m.x();
  EXPECT_GT(step_m, 0.03);
  EXPECT_EQ(odometry.foot(urdf::Side::left).place_m, left_m);
  odometry.update(kinematics, urdf::Side::right);  // the load has gone over; nothing moves
  EXPECT_NEAR(odometry.foot(urdf::Side::right).place_m.x(), step_m, 1e-12);
  pose(0.0);
  odometry.update(kinematics, urdf::Side::right);
  EXPECT_NEAR(odometry.foot(urdf::Side::left).place_m.x(), step_m, 1e-9) << "the left foot was drawn up";
  EXPECT_NEAR(middle_m().x(), step_m, 1e-9);
}

// By the attitude's yaw, over more than a turn.
TEST_F(FootOdometryTest, TurnsOnTheStanceFootAndIsNotWrapped) {
  pose(0.0);
  odometry.update(kinematics, urdf::Side::left);
  const Eigen::Vector2d left_m = odometry.foot(urdf::Side::left).place_m;
  for (int i = 1; i <= 100; ++i) {
    pose(0.1 * i);
    odometry.update(kinematics, urdf::Side::left);
  }
  EXPECT_NEAR(odometry.foot(urdf::Side::left).yaw_rad, 10.0, 1e-9);
  EXPECT_NEAR(odometry.base().yaw_rad, 10.0, 1e-9);
  EXPECT_EQ(odometry.foot(urdf::Side::left).place_m, left_m);
  const Eigen::Vector2d beside = Eigen::Rotation2Dd(10.0) * Eigen::Vector2d(0.0, -2.0 * left_m.y());
  EXPECT_LT((odometry.foot(urdf::Side::right).place_m - left_m - beside).norm(), 1e-9);
}

}  // namespace
}  // namespace gaitway::zmp
