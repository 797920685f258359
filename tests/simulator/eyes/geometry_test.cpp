// What stands somewhere is seen at the pixel that the camera file's lens and pose say.
#include <gtest/gtest.h>

#include "eyes_fixture.hpp"

namespace gaitway::simulator {
namespace {

using urdf::Side;
constexpr world::Colour kBlack{0.0, 0.0, 0.0};

TEST_F(EyesTest, ABallLandsWhereTheLensSaysInBothPictures) {
  const PlantOptions how = options(kBright);
  Plant robot(model_, how);
  const std::vector<Eigen::Vector3d> places{{1.0, 0.0, 0.6},  {1.0, 0.45, 0.45}, {1.0, -0.45, 0.75},
                                            {2.0, 0.9, 0.9},  {2.0, -0.6, 0.15}, {0.6, 0.1, 0.40},
                                            {3.0, -1.3, 1.0}, {3.0, 0.6, 0.4}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double diameter_m = 0.05 * places[i].x();
    robot.put(ball("ball " + std::to_string(i), places[i], diameter_m), kBlack, std::nullopt);
  }
  const auto seeing = see(how);
  seeing->wait(robot, 60);
  ASSERT_EQ(seeing->camera.newest().number, 1U) << seeing->camera.failure();
  for (const Eigen::Vector3d& place : places) {
    for (const Side side : urdf::kSides) {
      const Eigen::Vector2d told = pixel_of(robot, place, side);
      const Blob seen = dark_around(seeing->camera.newest(), side, told, 12.0);
      EXPECT_GT(seen.pixels, 40) << place.transpose();
      EXPECT_LT((seen.centre - told).norm(), 0.5)
          << place.transpose() << ": seen at " << seen.centre.transpose() << ", not at " << told.transpose();
    }
  }
}

// A pinhole would see the edges of the picture farther out: the ball at the side tells the distortion from
// none.
TEST_F(EyesTest, WithoutItsDistortionTheLensWouldBeWrongByPixels) {
  const PlantOptions how = options(kBright);
  Plant robot(model_, how);
  const Eigen::Vector3d place(1.0, 0.5, 0.4);
  robot.put(ball("ball", place, 0.05), kBlack, std::nullopt);
  const auto seeing = see(how);
  seeing->wait(robot, 60);
  urdf::LensParameters straight = file_of_camera_.lens[0];
  straight.distortion = {};
  const Eigen::Isometry3d optical = head_pose(robot) * file_of_camera_.in_link(Side::left);
  const Eigen::Vector2d by_pinhole = urdf::Lens(straight).project(optical.inverse() * place).value();
  const Blob seen = dark_around(seeing->camera.newest(), Side::left, by_pinhole, 25.0);
  EXPECT_GT((seen.centre - by_pinhole).norm(), 5.0);
}

// What is near lies farther left in the right picture: disparity = focal length * base / distance.
TEST_F(EyesTest, TheBaseIsThatOfTheFile) {
  const PlantOptions how = options(kBright);
  Plant robot(model_, how);
  const auto seeing = see(how);
  const Eigen::Isometry3d optical = head_pose(robot) * file_of_camera_.in_link(Side::left);
  const Eigen::Vector3d place = optical * Eigen::Vector3d(0.03, 0.0, 1.0);
  robot.put(ball("ball", place, 0.05), kBlack, std::nullopt);
  seeing->wait(robot, 60);
  const Blob left = dark_around(seeing->camera.newest(), Side::left, {168, 119}, 15.0);
  const Blob right = dark_around(seeing->camera.newest(), Side::right, {150, 119}, 25.0);
  const double straight_px = file_of_camera_.lens[0].fx_px * 0.060;
  EXPECT_GT(left.centre.x() - right.centre.x(), straight_px - 4.0);  // the principal points differ, too
  EXPECT_LT(left.centre.x() - right.centre.x(), straight_px + 4.0);
}

TEST_F(EyesTest, ALargePictureShowsTheSameTwiceAsLarge) {
  file_of_camera_.width_px *= 2;
  file_of_camera_.height_px *= 2;
  for (urdf::LensParameters& lens : file_of_camera_.lens) {
    lens.fx_px *= 2.0;
    lens.fy_px *= 2.0;
    lens.cx_px = 2.0 * lens.cx_px + 0.5;
    lens.cy_px = 2.0 * lens.cy_px + 0.5;
  }
  const PlantOptions how = options(kBright);
  Plant robot(model_, how);
  const Eigen::Vector3d place(1.0, 0.3, 0.45);
  robot.put(ball("ball", place, 0.05), kBlack, std::nullopt);
  const auto seeing = see(how);
  EXPECT_EQ(seeing->camera.topic(), "stereo_pictures_large");
  seeing->wait(robot, 60);
  ASSERT_EQ(seeing->camera.newest().grey[0].size(), 640U * 480U);
  const Eigen::Vector2d told = pixel_of(robot, place, Side::left);
  EXPECT_LT((dark_around(seeing->camera.newest(), Side::left, told, 24.0).centre - told).norm(), 0.7);
}

TEST_F(EyesTest, TheHeadThatCarriesTheCameraIsNotSeen) {
  file_of_camera_.left_in_link.translation() = Eigen::Vector3d(0.0, 0.03, 0.07);  // within the shell
  const PlantOptions how = options(kBright);
  Plant robot(model_, how);
  const auto seeing = see(how);
  seeing->wait(robot, 140);
  EXPECT_GT(mean(seeing->camera.newest().grey[0]), 50.0);
}

}  // namespace
}  // namespace gaitway::simulator
