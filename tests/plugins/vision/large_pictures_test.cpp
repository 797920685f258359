// 640 x 480: what is seen, and what is wrong with the cameras, as with pictures of half that size.
#include <gtest/gtest.h>

#include <algorithm>

#include "watching_robot.hpp"

namespace gaitway::vision::testing {
namespace {

class LargePictures : public ::testing::Test {
 protected:
  LargePictures() { robot.scene.boxes.push_back({{1.1, 0.1, 0.1}, {0.2, 0.3, 0.2}, 0.0}); }
  WatchingRobot robot{{}, WatchingRobot::Pictures::large};
};

TEST_F(LargePictures, ShowABoxAndATag) {
  robot.head_pitch_rad(0.15);
  robot.scene.tags.push_back(facing_tag(7, {1.4, -0.35, 0.45}, 0.2));
  robot.watch(5);
  EXPECT_EQ(robot.vision().fault(), Fault::none);
  const auto box = std::ranges::find_if(robot.vision().obstacles(), [](const Box& one) {
    return (one.middle_m - Eigen::Vector2d(1.1, 0.1)).norm() < 0.05;
  });
  ASSERT_NE(box, robot.vision().obstacles().end());
  EXPECT_NEAR(box->height_m, 0.2, 0.03);
  SeenTargets seen{};
  robot.vision().write(seen);
  ASSERT_EQ(seen.count, 1U);
  EXPECT_NEAR(seen.position[0][0], 1.4, 0.01);
  EXPECT_NEAR(seen.position[0][1], -0.35, 0.01);
}

TEST_F(LargePictures, ExchangedCamerasAreSaid) {
  robot.spoil = [](TakenPair& taken) {
    std::swap(taken.left, taken.right);
    taken.refer();
  };
  robot.watch(8);
  EXPECT_EQ(robot.vision().fault(), Fault::cameras_exchanged);
}

class LargePicturesOfATurnedCamera : public LargePictures,
                                     public ::testing::WithParamInterface<Eigen::Vector3d> {};

TEST_P(LargePicturesOfATurnedCamera, SaySo) {
  robot.turn_right_camera(GetParam());
  robot.watch(8);
  EXPECT_EQ(robot.vision().fault(), Fault::cameras_misaligned);
}

INSTANTIATE_TEST_SUITE_P(EachAxis, LargePicturesOfATurnedCamera,
                         ::testing::Values(Eigen::Vector3d(-1, 0, 0), Eigen::Vector3d(0, 1, 0),
                                           Eigen::Vector3d(0, 0, 1.5)));

}  // namespace
}  // namespace gaitway::vision::testing
