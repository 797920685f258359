// The rectangle on which a foot stands, found from the foot's surfaces.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "gaitway/importer/maker_robot.hpp"

namespace gaitway::importer {

struct FoundSole {
  // Of the sole frame in the foot's link: origin below the ankle, x forward, z up, the ground at z = 0.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  Eigen::Vector2d size_m = Eigen::Vector2d::Zero();    // length (x), width (y)
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();  // of the rectangle, in the sole frame
  std::string source;                                  // how it was found
};

// The largest level rectangle, its edges along and across the base's x axis, that lies within what the foot
// touches the ground with in the zero posture. The ground is the plane through the largest face of the foot's
// convex hull that looks down within 35 deg; what lies less than a hundredth of the foot's length above it
// touches it. `base_to_foot`: the foot link's pose in the base frame at zero; `ankle_m`: the ankle's centre
// in the foot link. Throws std::invalid_argument that says what is missing: no surface, none that looks down,
// a sole that is no longer than `least_m`.
[[nodiscard]] FoundSole find_sole(const MakerLink& foot, const Eigen::Isometry3d& base_to_foot,
                                  const Eigen::Vector3d& ankle_m, double least_m);

// For a foot whose surfaces give none: of the size that feet have on legs of this length, as deep below the
// ankle as a frame whose name has "sole" in it, or a tenth of the legs' length. Says so in `source`.
[[nodiscard]] FoundSole guess_sole(const MakerLink& foot, const Eigen::Isometry3d& base_to_foot,
                                   const Eigen::Vector3d& ankle_m, double leg_length_m);

}  // namespace gaitway::importer
