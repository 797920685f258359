// Where a tag is, by its corners in one picture or in both.
#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "gaitway/vision/stereo_rig.hpp"
#include "gaitway/vision/tag_finder.hpp"

namespace gaitway::vision {

// In the frame of the rectified left camera. The tag's frame: z comes out of it, x goes to its reader's
// right, y up; its origin is its middle.
struct TagPose {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();  // of the position
  double corner_error_px = 0.0;                             // root mean square
  bool is_certain = true;  // false: its mirror image about the line of sight suits the corners as well
};

// `left`, `right`: the same tag in either picture, or null where it was not found; not both. `size_m`: side
// of the black square. Four corners in one picture have two solutions (G. Schweighofer and A. Pinz, "Robust
// pose estimation from a planar target", 2006); both are refined over all corners that were seen, and the
// better one is taken. Nothing: none lies in front of the camera with its face to it, and within
// `most_error_px`.
[[nodiscard]] std::optional<TagPose> tag_pose(const RectifiedGeometry& geometry, const FoundTag* left,
                                              const FoundTag* right, double size_m,
                                              double corner_deviation_px, double most_error_px);

}  // namespace gaitway::vision
