// The stereo camera that a robot carries, as its camera.yaml has it: where it sits, how it sees, how fast.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "gaitway/urdf/lens.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf {

// Optical frames: x to the right in the picture, y down, z ahead; their origin is the optical centre. A pose
// `left_in_link` turns a point in the left camera's optical frame into one in the link's frame.
struct StereoCamera {
  std::string link;  // that carries it
  Eigen::Isometry3d left_in_link = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d right_in_left = Eigen::Isometry3d::Identity();
  int width_px = 0, height_px = 0;  // 320 x 240 or 640 x 480
  double rate_hz = 0.0;
  double latency_s = 0.0;   // from the stamp, the middle of the middle row's exposure, to the topic
  double exposure_s = 0.0;  // of each row
  double readout_s = 0.0;   // rolling shutter: from the first row's exposure to the last one's
  std::array<LensParameters, 2> lens;  // [Side]

  [[nodiscard]] Eigen::Isometry3d in_link(Side side) const noexcept {
    return side == Side::left ? left_in_link : left_in_link * right_in_left;
  }
  [[nodiscard]] double base_m() const noexcept { return right_in_left.translation().norm(); }
  [[nodiscard]] bool is_large() const noexcept { return width_px > 320; }  // its topic: stereo_pictures_large
};

// Throws RobotError with file, line, key, value, rule and remedy. Of a file whose link no robot is asked for.
[[nodiscard]] StereoCamera read_stereo_camera(const std::filesystem::path& file);

// <directory>/camera.yaml of the robot's folder, whose link is one of the robot's; nothing: it has no camera.
// Throws RobotError.
[[nodiscard]] std::optional<StereoCamera> stereo_camera_of(const RobotModel& model);

}  // namespace gaitway::urdf
