// A robot's camera.yaml becomes two cameras with their poses, or is refused with its place.
#include "gaitway/urdf/camera_file.hpp"

#include <gmock/gmock.h>

#include "broken_robot.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::urdf {
namespace {

using facts::kRadPerDegree;
using ::testing::HasSubstr;

constexpr const char* kSoundCamera = R"(link: head
position_m: [0.05, 0.03, 0.07]
pitch_deg: 30
size_px: [320, 240]
rate_hz: 12.5
latency_s: 0.03
exposure_s: 0.004
readout_s: 0.012
left: {fx_px: 258, fy_px: 259, cx_px: 160, cy_px: 119, distortion: [-0.28, 0.07, 0, 0, 0]}
right: {fx_px: 257, fy_px: 257, cx_px: 158, cy_px: 121}
right_from_left: {position_m: [0.06, 0, 0], rotation_deg: [0, 2, 0]}
)";

class CameraFile : public ::testing::Test {
 protected:
  void expect_refused(const std::string& from, const std::string& to,
                      std::initializer_list<const char*> said) {
    std::string text = kSoundCamera;
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    robot_.write("camera.yaml", text.replace(at, from.size(), to));
    try {
      (void)stereo_camera_of(robot_.load());
      ADD_FAILURE() << "taken: " << to;
    } catch (const RobotError& error) {
      EXPECT_THAT(error.what(), HasSubstr("camera.yaml"));
      for (const char* const words : said) EXPECT_THAT(error.what(), HasSubstr(words));
    }
  }
  test::BrokenRobot robot_;
};

TEST_F(CameraFile, gives_where_both_cameras_are_and_look) {
  robot_.write("camera.yaml", kSoundCamera);
  const auto camera = stereo_camera_of(robot_.load());
  ASSERT_TRUE(camera);
  const Eigen::Isometry3d left = camera->in_link(Side::left), right = camera->in_link(Side::right);
  EXPECT_TRUE(left.translation().isApprox(Eigen::Vector3d(0.05, 0.03, 0.07)));
  EXPECT_TRUE(right.translation().isApprox(Eigen::Vector3d(0.05, -0.03, 0.07))) << "60 mm to the right";
  const double pitch_rad = 30.0 * kRadPerDegree, turn_rad = 2.0 * kRadPerDegree;
  const Eigen::Vector3d ahead(std::cos(pitch_rad), 0.0, -std::sin(pitch_rad));
  EXPECT_TRUE((left.linear() * Eigen::Vector3d::UnitZ()).isApprox(ahead)) << "30 degrees down";
  EXPECT_TRUE((left.linear() * Eigen::Vector3d::UnitX()).isApprox(-Eigen::Vector3d::UnitY()));
  EXPECT_TRUE((right.linear() * Eigen::Vector3d::UnitZ())
                  .isApprox(ahead * std::cos(turn_rad) - Eigen::Vector3d::UnitY() * std::sin(turn_rad)))
      << "2 degrees about y, which goes down: to the right";
  EXPECT_EQ(camera->lens[0].fy_px, 259.0);
  EXPECT_EQ(camera->lens[1].cx_px, 158.0);
  EXPECT_EQ(camera->lens[0].distortion[0], -0.28);
  EXPECT_EQ(camera->lens[1].distortion[0], 0.0) << "no distortion is none";
  EXPECT_DOUBLE_EQ(camera->base_m(), 0.06);
  EXPECT_FALSE(camera->is_large());
}

TEST_F(CameraFile, may_be_left_out) {
  EXPECT_FALSE(stereo_camera_of(robot_.load()));
}

TEST_F(CameraFile, of_the_shipped_robot_has_a_base_of_60_mm) {
  const auto camera = stereo_camera_of(load_robot(std::filesystem::path(GAITWAY_URDF_DIR) / "humanoid22"));
  ASSERT_TRUE(camera);
  EXPECT_EQ(camera->link, "head");
  EXPECT_NEAR(camera->base_m(), 0.06, 1e-4);
}

TEST_F(CameraFile, says_which_key_it_does_not_know_and_which_was_meant) {
  expect_refused("readout_s", "readout_ms", {":8", "readout_ms", "Did you mean 'readout_s'?"});
  expect_refused("fx_px: 257", "f_px: 257", {":10", "f_px", "Did you mean 'fx_px'?"});
  expect_refused("rate_hz: 12.5\n", "", {"rate_hz"});
  expect_refused("link: head", "link: hed", {":1", "has no link 'hed'", "Did you mean 'head'?"});
}

TEST_F(CameraFile, refuses_what_no_camera_is) {
  expect_refused("[320, 240]", "[321, 240]", {":4", "size_px", "320 x 240 or 640 x 480"});
  expect_refused("fx_px: 258", "fx_px: .nan", {":9", "left.fx_px"});
  expect_refused("[-0.28, 0.07, 0, 0, 0]", "[-1.5, 0.07, 0, 0, 0]", {":9", "left", "turns back"});
  expect_refused("[-0.28, 0.07, 0, 0, 0]", "[-0.28, 0.07, 0, 0]", {":9", "left.distortion"});
  expect_refused("[-0.28, 0.07, 0, 0, 0]", "[-0.28, 0.07, 0.4, 0, 0]", {":9", "left.distortion[2]"});
  expect_refused("[0.06, 0, 0]", "[-0.06, 0, 0]", {":11", "right_from_left.position_m", "to the right"});
  expect_refused("rate_hz: 12.5", "rate_hz: 70", {":5", "rate_hz", "0.016 s"});
  expect_refused("latency_s: 0.03", "latency_s: 0.005", {":6", "latency_s", "0.008 s"});
  expect_refused("exposure_s: 0.004", "exposure_s: 0", {":7", "exposure_s"});
}

}  // namespace
}  // namespace gaitway::urdf
