// The lens of a camera: which pixel a direction is seen at, and back. Whoever draws pictures and whoever
// measures in them has the same definition of it.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>

namespace gaitway::urdf {

// Pinhole and distortion as OpenCV has them ("Camera Calibration and 3D Reconstruction"; the model is that of
// D. C. Brown, "Close-range camera calibration", 1971). The middle of the upper left pixel is (0, 0).
struct LensParameters {
  double fx_px = 0.0, fy_px = 0.0;     // focal length
  double cx_px = 0.0, cy_px = 0.0;     // principal point
  std::array<double, 5> distortion{};  // k1, k2, p1, p2, k3: radial 1, 2, tangential 1, 2, radial 3
};

class Lens {
 public:
  explicit Lens(const LensParameters& parameters);

  // Pixel of a point in the optical frame (x right, y down, z ahead). Nothing: it lies behind the camera, or
  // so far aside that the distortion polynomial has turned back there and says nothing about a lens any more.
  [[nodiscard]] std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point_m) const noexcept;

  // The direction that is seen at a pixel, as (x, y) of its point at z = 1: Newton's method on the
  // distortion. Nothing: no direction is.
  [[nodiscard]] std::optional<Eigen::Vector2d> unproject(const Eigen::Vector2d& pixel) const noexcept;

  // Where (x, y) at z = 1 comes to lie by the distortion.
  [[nodiscard]] Eigen::Vector2d distort(const Eigen::Vector2d& direction) const noexcept;

  // Distance from the axis at z = 1 up to which the radial polynomial rises; infinity: it always does.
  [[nodiscard]] double largest_radius() const noexcept { return largest_radius_; }
  [[nodiscard]] const LensParameters& parameters() const noexcept { return parameters_; }

 private:
  LensParameters parameters_;
  double largest_radius_;
};

}  // namespace gaitway::urdf
