// The calibrated pair of cameras as one that sees distances: both pictures without distortion, on common
// rows.
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "gaitway/urdf/camera_file.hpp"
#include "gaitway/vision/pictures.hpp"

namespace gaitway::vision {

// Rectified pictures: a pinhole camera each, the right one moved along x by the base alone. A point at z has
// the disparity x_left - x_right = focal · base / z.
struct RectifiedGeometry {
  double focal_px = 0.0, cx_px = 0.0, cy_px = 0.0, base_m = 0.0;
  int width = 0, height = 0;

  [[nodiscard]] double disparity_px(double z_m) const noexcept { return focal_px * base_m / z_m; }
  [[nodiscard]] double distance_m(double disparity_px) const noexcept {
    return focal_px * base_m / disparity_px;
  }
  // Of the left camera.
  [[nodiscard]] Eigen::Vector3d ray(double x_px, double y_px) const noexcept {
    return {(x_px - cx_px) / focal_px, (y_px - cy_px) / focal_px, 1.0};
  }
  [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& point_m) const noexcept {
    return {cx_px + focal_px * point_m.x() / point_m.z(), cy_px + focal_px * point_m.y() / point_m.z()};
  }
};

class StereoRig {
 public:
  // From now on OpenCV has one thread in this process.
  explicit StereoRig(const urdf::StereoCamera& camera);

  // The pair's size must be the camera's. The pictures hold until the next call.
  void rectify(const PicturePair& pair);
  [[nodiscard]] const cv::Mat& left() const noexcept { return rectified_[0]; }
  [[nodiscard]] const cv::Mat& right() const noexcept { return rectified_[1]; }

  [[nodiscard]] const RectifiedGeometry& geometry() const noexcept { return geometry_; }
  // Pose of the rectified left camera's optical frame in the link that carries it.
  [[nodiscard]] const Eigen::Isometry3d& in_link() const noexcept { return in_link_; }

 private:
  RectifiedGeometry geometry_;
  Eigen::Isometry3d in_link_ = Eigen::Isometry3d::Identity();
  cv::Mat map_[2][2];  // of each camera: where each pixel comes from, and its fraction
  cv::Mat rectified_[2];
};

}  // namespace gaitway::vision
