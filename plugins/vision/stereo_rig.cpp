// Rectification after J.-Y. Bouguet: both cameras are turned by half of what parts them, then onto the base.
#include "gaitway/vision/stereo_rig.hpp"

#include <array>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/imgproc.hpp>

namespace gaitway::vision {
namespace {

cv::Mat matrix_of(const urdf::LensParameters& lens) {
  return (cv::Mat_<double>(3, 3) << lens.fx_px, 0.0, lens.cx_px, 0.0, lens.fy_px, lens.cy_px, 0.0, 0.0, 1.0);
}

}  // namespace

StereoRig::StereoRig(const urdf::StereoCamera& camera) {
  cv::setNumThreads(1);  // before OpenCV has started any: they would outlive the plug-in
  const cv::Size size(camera.width_px, camera.height_px);
  const Eigen::Isometry3d left_in_right = camera.right_in_left.inverse();
  const Eigen::Matrix3d rotation = left_in_right.linear();
  const Eigen::Vector3d translation = left_in_right.translation();
  cv::Mat right_from_left, base;
  cv::eigen2cv(rotation, right_from_left);
  cv::eigen2cv(translation, base);

  std::array<cv::Mat, 2> matrix, distortion, turn, projection;
  for (std::size_t i = 0; i < 2; ++i) {
    matrix[i] = matrix_of(camera.lens[i]);
    distortion[i] = cv::Mat(camera.lens[i].distortion, true);
  }
  cv::Mat reprojection;
  cv::stereoRectify(matrix[0], distortion[0], matrix[1], distortion[1], size, right_from_left, base, turn[0],
                    turn[1], projection[0], projection[1], reprojection, cv::CALIB_ZERO_DISPARITY, 0.0);
  for (std::size_t i = 0; i < 2; ++i) {
    cv::initUndistortRectifyMap(matrix[i], distortion[i], turn[i], projection[i], size, CV_16SC2, map_[i][0],
                                map_[i][1]);
  }
  geometry_ = {.focal_px = projection[0].at<double>(0, 0),
               .cx_px = projection[0].at<double>(0, 2),
               .cy_px = projection[0].at<double>(1, 2),
               .base_m = -projection[1].at<double>(0, 3) / projection[1].at<double>(0, 0),
               .width = size.width,
               .height = size.height};
  Eigen::Matrix3d rectified_from_left;
  cv::cv2eigen(turn[0], rectified_from_left);
  in_link_ = camera.left_in_link;
  in_link_.linear() = camera.left_in_link.linear() * rectified_from_left.transpose();
}

void StereoRig::rectify(const PicturePair& pair) {
  const std::array pixels{pair.left, pair.right};
  for (std::size_t i = 0; i < 2; ++i) {
    // OpenCV has no picture of constant pixels; it only reads these.
    const cv::Mat picture(pair.height, pair.width, CV_8UC1, const_cast<std::uint8_t*>(pixels[i].data()));
    cv::remap(picture, rectified_[i], map_[i][0], map_[i][1], cv::INTER_LINEAR);
  }
}

}  // namespace gaitway::vision
