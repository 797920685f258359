// Two first guesses by homography, each refined by Gauss-Newton over the corners of both pictures.
#include "gaitway/vision/tag_pose.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace gaitway::vision {
namespace {

constexpr int kPoseIterations = 12;
constexpr double kClearlyBetter = 2.0;  // ratio of squared errors
constexpr double kNearest_m = 0.05;

std::array<Eigen::Vector3d, 4> corners_of(double size_m) {
  const double half_m = 0.5 * size_m;
  return {{{-half_m, -half_m, 0.0}, {half_m, -half_m, 0.0}, {half_m, half_m, 0.0}, {-half_m, half_m, 0.0}}};
}

struct View {
  const FoundTag* tag = nullptr;
  Eigen::Vector3d eye_m = Eigen::Vector3d::Zero();  // of the camera, in the left one's frame
};

struct Fit {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  Eigen::Matrix<double, 6, 6> normal =
      Eigen::Matrix<double, 6, 6>::Zero();  // of turn, position; 1/px² and so on
  double squared_px = 0.0;
};

// Error and Gauss-Newton's equations. False: a corner is not ahead of a camera.
bool linearise(const RectifiedGeometry& geometry, const std::vector<View>& views, double size_m, Fit& fit,
               Eigen::Matrix<double, 6, 1>& gradient) {
  fit.normal.setZero();
  gradient.setZero();
  fit.squared_px = 0.0;
  const std::array<Eigen::Vector3d, 4> corners = corners_of(size_m);
  for (const View& view : views) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Eigen::Vector3d arm = fit.pose.linear() * corners[i];
      const Eigen::Vector3d seen = arm + fit.pose.translation() - view.eye_m;
      if (seen.z() < kNearest_m) return false;
      const Eigen::Vector2d error = view.tag->corner_px[i] - geometry.project(seen);
      Eigen::Matrix<double, 2, 3> by_point;
      by_point << 1.0, 0.0, -seen.x() / seen.z(), 0.0, 1.0, -seen.y() / seen.z();
      by_point *= geometry.focal_px / seen.z();
      Eigen::Matrix3d cross;  // of the arm: a turn moves its end by turn × arm
      cross << 0.0, -arm.z(), arm.y(), arm.z(), 0.0, -arm.x(), -arm.y(), arm.x(), 0.0;
      Eigen::Matrix<double, 2, 6> jacobian;
      jacobian << -by_point * cross, by_point;
      fit.normal += jacobian.transpose() * jacobian;
      gradient += jacobian.transpose() * error;
      fit.squared_px += error.squaredNorm();
    }
  }
  return true;
}

std::optional<Fit> refined(const RectifiedGeometry& geometry, const std::vector<View>& views, double size_m,
                           const Eigen::Isometry3d& guess) {
  Fit fit{.pose = guess};
  Eigen::Matrix<double, 6, 1> gradient;
  for (int iteration = 0; iteration < kPoseIterations; ++iteration) {
    if (!linearise(geometry, views, size_m, fit, gradient)) return std::nullopt;
    Eigen::Matrix<double, 6, 6> damped = fit.normal;
    damped.diagonal() *= 1.0 + 1e-3;
    const Eigen::Matrix<double, 6, 1> change = damped.ldlt().solve(gradient);
    const double turn_rad = change.head<3>().norm();
    if (!std::isfinite(turn_rad)) return std::nullopt;
    if (turn_rad > 1e-12) {
      fit.pose.linear() =
          Eigen::AngleAxisd(turn_rad, change.head<3>() / turn_rad).toRotationMatrix() * fit.pose.linear();
    }
    fit.pose.translation() += change.tail<3>();
  }
  fit.pose.linear() = Eigen::Quaterniond(fit.pose.linear()).normalized().toRotationMatrix();
  if (!linearise(geometry, views, size_m, fit, gradient)) return std::nullopt;
  // Its face must look at the camera.
  if (fit.pose.linear().col(2).dot(fit.pose.translation()) >= 0.0) return std::nullopt;
  return fit;
}

// By the homography from the tag's plane to the picture, whose first columns are those of the rotation (Z.
// Zhang, "A flexible new technique for camera calibration", 2000); and the same seen from the other side: a
// half turn about the line of sight, and one about the tag's own normal.
std::vector<Eigen::Isometry3d> guesses(const RectifiedGeometry& geometry, const View& view, double size_m) {
  const std::array<Eigen::Vector3d, 4> corners = corners_of(size_m);
  Eigen::Matrix<double, 8, 8> equations = Eigen::Matrix<double, 8, 8>::Zero();
  Eigen::Matrix<double, 8, 1> seen;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d& on_tag = corners[static_cast<std::size_t>(i)];
    const Eigen::Vector2d& pixel = view.tag->corner_px[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < 2; ++axis) {
      const double at = geometry.ray(pixel.x(), pixel.y())[axis];
      equations.row(2 * i + axis).segment<3>(3 * axis) << on_tag.x(), on_tag.y(), 1.0;
      equations.row(2 * i + axis).tail<2>() << -at * on_tag.x(), -at * on_tag.y();
      seen[2 * i + axis] = at;
    }
  }
  const Eigen::Matrix<double, 8, 1> h = equations.fullPivLu().solve(seen);
  Eigen::Matrix3d homography;
  homography << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], 1.0;
  const double scale = 2.0 / (homography.col(0).norm() + homography.col(1).norm());
  if (!std::isfinite(scale)) return {};
  Eigen::Matrix3d turn;
  turn.col(0) = homography.col(0).normalized();
  turn.col(1) = (homography.col(1) - turn.col(0).dot(homography.col(1)) * turn.col(0)).normalized();
  turn.col(2) = turn.col(0).cross(turn.col(1));
  const Eigen::Vector3d place = scale * homography.col(2);
  Eigen::Isometry3d first = Eigen::Isometry3d::Identity(), second = first;
  first.linear() = turn;
  second.linear() = Eigen::AngleAxisd(std::numbers::pi, place.normalized()) * turn *
                    Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ());
  first.translation() = second.translation() = place + view.eye_m;
  if (!first.matrix().allFinite()) return {};
  return {first, second};
}

}  // namespace

std::optional<TagPose> tag_pose(const RectifiedGeometry& geometry, const FoundTag* left,
                                const FoundTag* right, double size_m, double corner_deviation_px,
                                double most_error_px) {
  std::vector<View> views;
  if (left != nullptr) views.push_back({left, Eigen::Vector3d::Zero()});
  if (right != nullptr) views.push_back({right, {geometry.base_m, 0.0, 0.0}});
  std::optional<Fit> best;
  double second_px2 = 1e9;
  for (const Eigen::Isometry3d& guess : guesses(geometry, views.front(), size_m)) {
    const std::optional<Fit> fit = refined(geometry, views, size_m, guess);
    if (!fit) continue;
    // Both guesses may have come to the same pose: then there is no second one.
    const bool is_other =
        best && Eigen::AngleAxisd(best->pose.linear().transpose() * fit->pose.linear()).angle() > 0.02;
    if (!best || fit->squared_px < best->squared_px) {
      if (is_other) second_px2 = best->squared_px;
      best = fit;
    } else if (is_other) {
      second_px2 = fit->squared_px;
    }
  }
  if (!best) return std::nullopt;
  const double corners = 4.0 * static_cast<double>(views.size());
  TagPose found{.pose = best->pose, .corner_error_px = std::sqrt(best->squared_px / corners)};
  if (found.corner_error_px > most_error_px) return std::nullopt;
  const double noise_px2 = 2.0 * corners * corner_deviation_px * corner_deviation_px;
  found.is_certain = second_px2 + noise_px2 > kClearlyBetter * (best->squared_px + noise_px2);
  const Eigen::Matrix<double, 6, 6> covariance =
      best->normal.inverse() * corner_deviation_px * corner_deviation_px;
  found.covariance_m2 = covariance.bottomRightCorner<3, 3>();
  return found;
}

}  // namespace gaitway::vision
