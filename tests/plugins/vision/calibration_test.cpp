// `gaitway calibrate camera`: what is found from ray-traced boards, against the camera that took them.
#include <gtest/gtest.h>
#include <png.h>

#include <unistd.h>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "gaitway/input/complaint.hpp"
#include "standing_robot.hpp"
#include "synthetic_scene.hpp"
#include "tools/calibrate/camera/board_pictures.hpp"
#include "tools/calibrate/camera/stereo_calibration.hpp"

namespace gaitway::vision::testing {
namespace {

namespace fs = std::filesystem;

class CameraCalibration : public ::testing::Test {
 protected:
  CameraCalibration()
      : folder(fs::temp_directory_path() / ("gaitway_board_" + std::to_string(getpid()))),
        camera(StandingRobot().camera()) {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~CameraCalibration() override { fs::remove_all(folder); }

  void write(const std::string& name, const TakenPair& taken) {
    std::vector<std::uint8_t> both;
    const auto width = static_cast<std::size_t>(camera.width_px);
    for (std::size_t y = 0; y < static_cast<std::size_t>(camera.height_px); ++y) {
      for (const auto* half : {&taken.left, &taken.right}) {
        both.insert(both.end(), half->begin() + static_cast<std::ptrdiff_t>(y * width),
                    half->begin() + static_cast<std::ptrdiff_t>((y + 1) * width));
      }
    }
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(2 * camera.width_px);
    image.height = static_cast<png_uint_32>(camera.height_px);
    image.format = PNG_FORMAT_GRAY;
    ASSERT_NE(png_image_write_to_file(&image, (folder / name).c_str(), 0, both.data(), 0, nullptr), 0);
  }

  // The board in the picture's parts in turn, tilted each time another way; the camera looks along x.
  void take_boards(int count) {
    Eigen::Isometry3d eye = Eigen::Isometry3d::Identity();
    eye.linear().col(0) = -Eigen::Vector3d::UnitY();
    eye.linear().col(1) = -Eigen::Vector3d::UnitZ();
    eye.linear().col(2) = Eigen::Vector3d::UnitX();
    eye.translation().z() = 1.0;
    SceneCamera eyes(camera);
    for (int i = 0; i < count; ++i) {
      Scene scene;
      SceneBoard board;
      const double z_m = 0.36 + 0.05 * (i % 3);
      const Eigen::Vector3d middle_m(0.09 * (i % 3 - 1) * z_m / 0.4 + 0.02,
                                     0.075 * (i / 3 % 3 - 1) * z_m / 0.4, z_m);
      const Eigen::Matrix3d tilt = (Eigen::AngleAxisd(0.35 * std::sin(1.9 * i), Eigen::Vector3d::UnitX()) *
                                    Eigen::AngleAxisd(0.4 * std::cos(1.3 * i), Eigen::Vector3d::UnitY()))
                                       .toRotationMatrix();
      Eigen::Isometry3d in_eye = Eigen::Isometry3d::Identity();
      in_eye.linear() =
          tilt * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()).toRotationMatrix();
      in_eye.translation() = middle_m - in_eye.linear() * Eigen::Vector3d(4.0 * 0.025, 2.5 * 0.025, 0.0);
      board.pose = eye * in_eye;
      scene.boards.push_back(board);
      write(std::to_string(100 + i) + ".png", eyes.take(
                                                  scene, [&](std::int64_t) { return eye; }, 0, 1));
    }
  }

  fs::path folder;
  urdf::StereoCamera camera;
};

TEST_F(CameraCalibration, FindsTheCameraThatTookThePictures) {
  take_boards(18);
  const calibration::Board board;
  const calibration::BoardPictures pictures = calibration::find_boards(folder, board);
  EXPECT_GE(pictures.pairs.size(), 12U);
  const calibration::StereoCalibration found = calibration::calibrate(pictures, board, folder);
  EXPECT_LT(found.pair_error_px, 0.3);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(found.lens[i].fx_px, camera.lens[i].fx_px, 2.5);
    EXPECT_NEAR(found.lens[i].cx_px, camera.lens[i].cx_px, 2.5);
    EXPECT_NEAR(found.lens[i].cy_px, camera.lens[i].cy_px, 2.5);
    EXPECT_NEAR(found.lens[i].distortion[0], camera.lens[i].distortion[0], 0.03);
  }
  EXPECT_LT((found.right_in_left.translation() - camera.right_in_left.translation()).norm(), 0.001);
  const Eigen::AngleAxisd off(found.right_in_left.linear().transpose() * camera.right_in_left.linear());
  EXPECT_LT(std::abs(off.angle()), 0.005);
}

TEST_F(CameraCalibration, TheFileKeepsWhatElseItSays) {
  calibration::StereoCalibration found;
  found.lens[0].fx_px = 111.0;
  found.lens[1].fx_px = 222.0;
  const std::string text = calibration::with_calibration(
      "# mine\nlink: head  # where\nsize_px: [320, 240]  # of it\nleft: {fx_px: 1}\nright:\n  fx_px: 1\n  "
      "fy_px: 2\nrate_hz: 12.5\n",
      found, 320, 240);
  EXPECT_TRUE(
      text.starts_with("# mine\nlink: head  # where\nsize_px: [320, 240]  # of it\nleft: {fx_px: 111.000"))
      << text;
  EXPECT_NE(text.find("right: {fx_px: 222.000"), std::string::npos);
  EXPECT_EQ(text.find("fy_px: 2\n"), std::string::npos) << "the old lines of a key go with it";
  EXPECT_NE(text.find("rate_hz: 12.5\n"), std::string::npos);
  EXPECT_NE(text.find("right_from_left: {"), std::string::npos);
}

TEST_F(CameraCalibration, SaysWhatIsWrongWithThePictures) {
  const calibration::Board board;
  EXPECT_THROW((void)calibration::find_boards(folder, board), input::InputError) << "no pictures";
  EXPECT_THROW((void)calibration::find_boards(folder, {8, 6, 0.025}), input::InputError) << "upside down";
  take_boards(2);
  const calibration::BoardPictures pictures = calibration::find_boards(folder, board);
  EXPECT_THROW((void)calibration::calibrate(pictures, board, folder), input::InputError) << "too few";
  std::ofstream(folder / "000.png") << "no PNG";
  EXPECT_THROW((void)calibration::find_boards(folder, board), input::InputError);
}

}  // namespace
}  // namespace gaitway::vision::testing
