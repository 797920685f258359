// Lenses, and where the right camera is, by pairs of pictures of a board.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

#include "gaitway/urdf/lens.hpp"
#include "tools/calibrate/camera/board_pictures.hpp"

namespace gaitway::calibration {

struct StereoCalibration {
  std::array<urdf::LensParameters, 2> lens;                         // left, right
  Eigen::Isometry3d right_in_left = Eigen::Isometry3d::Identity();  // optical frames
  std::array<double, 2> lens_error_px{};  // root mean square of the corners' distances, each camera alone
  double pair_error_px = 0.0;             // both together
  std::array<double, 2> covered{};        // share of the picture that boards have reached
};

// Z. Zhang, "A flexible new technique for camera calibration", 2000, as OpenCV has it. Throws
// input::InputError with what to do for too few pairs, boards in too small a part of the picture, or corners
// that do not fit.
[[nodiscard]] StereoCalibration calibrate(const BoardPictures& pictures, const Board& board,
                                          const std::filesystem::path& folder);

// The text of a camera file with these numbers in place of its own; comments and all other keys stay.
[[nodiscard]] std::string with_calibration(const std::string& camera_yaml,
                                           const StereoCalibration& calibration, int width_px, int height_px);

}  // namespace gaitway::calibration
