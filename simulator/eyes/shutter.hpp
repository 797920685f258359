// One camera's picture of a moving head: rolling shutter, motion blur and lens, out of a few pinhole
// drawings.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/urdf/lens.hpp"
#include "scene_view.hpp"

namespace gaitway::simulator {

// The robot at an instant of a picture's time.
struct PictureInstant {
  std::int64_t at_ns = 0;
  std::vector<double> positions;                           // Plant::positions()
  Eigen::Isometry3d link = Eigen::Isometry3d::Identity();  // that carries the camera, in the world
};

// When each row is exposed.
struct ShutterTimes {
  std::int64_t middle_ns = 0;  // of the middle row's exposure
  double exposure_s = 0.0;
  double readout_s = 0.0;
  [[nodiscard]] double row_s(int row, int rows) const noexcept {  // middle of its exposure, since middle_ns
    return readout_s * (static_cast<double>(row) / (rows - 1) - 0.5);
  }
};

// Turning of the head is exact: each pixel of each row, at several instants of its exposure, looks where it
// looked then. What the head's travel and other things' motion change meanwhile is drawn at one instant for
// each band of rows; there are more bands the farther the camera travels.
class Shutter {
 public:
  Shutter(const urdf::Lens& lens, int width_px, int height_px, double oversampling);

  // `instants`: in order of time, around the whole exposure. `in_link`: of the optical frame. `light`: of
  // each pixel, row by row.
  void take(std::span<const PictureInstant> instants, const ShutterTimes& times,
            const Eigen::Isometry3d& in_link, SceneView& view, std::vector<float>& light);

  [[nodiscard]] int bands() const noexcept { return bands_; }  // of the last picture
  // Of what is drawn for a picture, at most; a head that turns faster sees the border's pixels beyond it.
  [[nodiscard]] int widest_px() const noexcept { return widest_px_; }
  [[nodiscard]] int highest_px() const noexcept { return highest_px_; }

 private:
  struct Band {
    int first_row = 0, end_row = 0;
    const PictureInstant* drawn = nullptr;
  };
  [[nodiscard]] std::vector<Band> bands_of(std::span<const PictureInstant> instants,
                                           const ShutterTimes& times, const Eigen::Isometry3d& in_link) const;
  [[nodiscard]] int blur_samples(std::span<const PictureInstant> instants, const ShutterTimes& times) const;
  void turn_rows(const Band& band, std::span<const PictureInstant> instants, const ShutterTimes& times,
                 const Eigen::Isometry3d& in_link);
  [[nodiscard]] PinholeWindow window_of(const Band& band) const;
  void sample(const Band& band, const PinholeWindow& window, std::vector<float>& light) const;

  int width_px_, height_px_;
  double scale_;                            // pixels of a drawing for each unit at z = 1
  std::vector<Eigen::Vector2f> direction_;  // of each pixel, at z = 1
  std::vector<float> vignetting_;           // of each pixel: cos^4 of its angle, the natural one
  int widest_px_ = 0, highest_px_ = 0;
  int samples_ = 1;  // in an exposure
  int bands_ = 1;
  std::vector<Eigen::Matrix3f> turn_;  // of each row of the band and sample: into the drawing's frame
  GreyPicture drawing_;
};

}  // namespace gaitway::simulator
