// Pictures of the simulated robot, and film strips of them.
#include "gaitway/simulator/camera.hpp"

#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <algorithm>
#include <thread>

#include "home_servo.hpp"

namespace gaitway::simulator {
namespace {

constexpr int kWidth_px = 160, kHeight_px = 120;

class CameraTest : public ::testing::Test {
 protected:
  urdf::RobotModel model_ = humanoid22();
  Plant plant_{model_, {.seed = 1, .mismatch = 0.0, .sensor_noise = false}};
  std::vector<double> pose_{plant_.positions().begin(), plant_.positions().end()};
};

std::size_t different_bytes(const Image& a, const Image& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    count += std::abs(a.rgb[i] - b.rgb[i]) > 8 ? 1U : 0U;
  }
  return count;
}

// Darkest byte of the picture's lower half.
int darkest_of_the_ground(const Image& image) {
  return *std::min_element(image.rgb.begin() + static_cast<std::ptrdiff_t>(image.rgb.size() / 2),
                           image.rgb.end());
}

TEST_F(CameraTest, SeesTheRobotUprightInTheMiddle) {
  Camera camera(plant_, kWidth_px, kHeight_px);
  const Image image = camera.render(pose_);
  ASSERT_EQ(image.rgb.size(), static_cast<std::size_t>(3 * kWidth_px * kHeight_px));
  const auto blueness = [&](int y) {
    const auto* pixel = &image.rgb[static_cast<std::size_t>(3 * kWidth_px * y)];
    return pixel[2] - pixel[0];
  };
  EXPECT_GT(blueness(2), 20) << "the sky is above";
  EXPECT_LT(blueness(kHeight_px - 3), 20) << "the ground is below";
  std::vector<double> away = pose_;
  away[2] += 50.0;  // out of sight
  EXPECT_GT(different_bytes(image, camera.render(away)), 1000U);
}

TEST_F(CameraTest, FollowsTheRobot) {
  Camera camera(plant_, kWidth_px, kHeight_px);
  const Image here = camera.render(pose_);
  std::vector<double> far = pose_;
  far[0] += 30.0;  // a whole number of tiles: the picture is the same, with its shadow
  far[1] -= 20.0;
  const Image there = camera.render(far);
  EXPECT_LT(different_bytes(here, there), here.rgb.size() / 50);
  EXPECT_NEAR(darkest_of_the_ground(here), darkest_of_the_ground(there), 10);
}

TEST_F(CameraTest, SeveralLiveAtOnceAndOnOtherThreads) {
  Camera first(plant_, kWidth_px, kHeight_px);
  const Image before = first.render(pose_);
  {
    Camera second(plant_, 80, 60);
    EXPECT_EQ(second.render(pose_).rgb.size(), 3U * 80U * 60U);
  }
  Image after;
  std::thread([&] { after = first.render(pose_); }).join();
  EXPECT_LT(different_bytes(before, after), 50U);  // the software renderer may differ in a pixel on an edge
}

TEST_F(CameraTest, RefusesSizesAndPosesThatItCannotDraw) {
  EXPECT_THROW(Camera(plant_, 0, 120), std::invalid_argument);
  EXPECT_THROW(Camera(plant_, 4000, 120), std::invalid_argument);
  Camera camera(plant_, kWidth_px, kHeight_px);
  pose_.pop_back();
  EXPECT_THROW((void)camera.render(pose_), std::invalid_argument);
}

class FilmStripTest : public ::testing::Test {
 protected:
  ~FilmStripTest() override { std::filesystem::remove(file_); }
  static Image plain(int width_px, int height_px, std::uint8_t grey) {
    return {width_px, height_px,
            std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width_px * height_px), grey)};
  }
  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("gaitway_film_strip_" + std::to_string(getpid()) + ".png");
};

TEST_F(FilmStripTest, PutsItsImagesInRows) {
  write_film_strip(file_.string(), std::vector<Image>{plain(4, 2, 10), plain(4, 2, 20), plain(4, 2, 30)}, 2);
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&png, file_.c_str()), 0);
  png.format = PNG_FORMAT_RGB;
  ASSERT_EQ(png.width, 8U);
  ASSERT_EQ(png.height, 4U);
  std::vector<std::uint8_t> rgb(8U * 4U * 3U);
  ASSERT_NE(png_image_finish_read(&png, nullptr, rgb.data(), 0, nullptr), 0);
  const auto grey = [&](std::size_t x, std::size_t y) { return static_cast<int>(rgb[3 * (8 * y + x)]); };
  EXPECT_EQ(grey(0, 0), 10);
  EXPECT_EQ(grey(7, 1), 20);
  EXPECT_EQ(grey(3, 2), 30);
  EXPECT_EQ(grey(4, 3), 255);
}

TEST_F(FilmStripTest, RefusesWhatIsNoStripAndNamesTheFileThatItCannotWrite) {
  EXPECT_THROW(write_film_strip(file_.string(), {}, 2), std::invalid_argument);
  EXPECT_THROW(write_film_strip(file_.string(), std::vector<Image>{plain(4, 2, 1)}, 0),
               std::invalid_argument);
  EXPECT_THROW(write_film_strip(file_.string(), std::vector<Image>{plain(4, 2, 1), plain(2, 4, 1)}, 2),
               std::invalid_argument);
  try {
    write_film_strip("/no-such-folder/strip.png", std::vector<Image>{plain(4, 2, 1)}, 1);
    FAIL() << "wrote into a folder that does not exist";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/no-such-folder/strip.png"), std::string::npos);
  }
}

}  // namespace
}  // namespace gaitway::simulator
