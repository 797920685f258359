// What a calibration leaves, drawn once for each robot.
#include "camera_mismatch.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "gaitway/facts/facts.hpp"
#include "gaitway/facts/random_stream.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/urdf/lens.hpp"

namespace gaitway::simulator {
namespace {

using urdf::Side;

constexpr std::uint64_t kMismatchStream = 0x6361'6D65'7261'0000ULL;

// How far a good calibration is off, standard deviations.
constexpr double kFocalShare = 0.001, kPrincipalPoint = 0.1 / 320.0;  // the latter of the width
constexpr double kRadial = 0.003;
constexpr double kMountPosition_m = 0.001, kMountTurn_deg = 0.2;
constexpr double kBetweenPosition_m = 0.0001, kBetweenTurn_deg = 0.02;
constexpr double kUsualScale = 1.0;     // of the mismatch
constexpr double kFarthestDrawn = 5.0;  // standard deviations: what any robot's lens may be off

Eigen::Isometry3d small_pose(facts::RandomStream& random, double position_m, double turn_deg) {
  const auto three = [&random](double deviation) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    return Eigen::Vector3d(deviation * Eigen::Vector3d(x, y, z));
  };
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = three(position_m);
  const Eigen::Vector3d turn_rad = three(turn_deg * facts::kRadPerDegree);
  if (turn_rad.norm() > 0.0) {
    pose.linear() = Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()).toRotationMatrix();
  }
  return pose;
}

urdf::LensParameters true_lens(const urdf::LensParameters& file, int width_px, facts::RandomStream& random,
                               double scale) {
  urdf::LensParameters lens = file;
  const double focal = 1.0 + scale * kFocalShare * random.normal();
  lens.fx_px *= focal;
  lens.fy_px *= focal;
  lens.cx_px += scale * kPrincipalPoint * width_px * random.normal();
  lens.cy_px += scale * kPrincipalPoint * width_px * random.normal();
  lens.distortion[0] += scale * kRadial * random.normal();
  return lens;
}

// The lens that turns back nearest to the middle, of all that may be drawn, and whether each pixel of the
// picture's border is seen from a direction.
bool sees_its_border(urdf::LensParameters lens, int width_px, int height_px, double scale) {
  const double most = kFarthestDrawn * scale;
  lens.distortion[0] -= most * kRadial;
  lens.fx_px *= 1.0 - most * kFocalShare;
  lens.fy_px *= 1.0 - most * kFocalShare;
  const double aside_px = most * kPrincipalPoint * width_px;
  const urdf::Lens worst(lens);
  const double right_px = width_px - 1.0 + aside_px, bottom_px = height_px - 1.0 + aside_px;
  const auto sees = [&worst](double x_px, double y_px) {
    return worst.unproject(Eigen::Vector2d(x_px, y_px)).has_value();
  };
  for (double x_px = -aside_px; x_px <= right_px; x_px += 1.0) {
    if (!sees(x_px, -aside_px) || !sees(x_px, bottom_px)) return false;
  }
  for (double y_px = -aside_px; y_px <= bottom_px; y_px += 1.0) {
    if (!sees(-aside_px, y_px) || !sees(right_px, y_px)) return false;
  }
  return sees(right_px, bottom_px);
}

bool sees_its_border(const urdf::StereoCamera& camera, double scale) {
  return std::ranges::all_of(urdf::kSides, [&](Side side) {
    return sees_its_border(camera.lens[urdf::index_of(side)], camera.width_px, camera.height_px, scale);
  });
}

// A robot that is off by more than is usual has a lens that is off as far as its file takes it.
double scale_of_lenses(const urdf::StereoCamera& camera, double scale) {
  while (scale > kUsualScale && !sees_its_border(camera, scale)) scale = std::max(kUsualScale, 0.9 * scale);
  return scale;
}

}  // namespace

CameraMismatch draw_camera_mismatch(const urdf::StereoCamera& camera, std::uint64_t seed, double scale) {
  facts::RandomStream random(seed, kMismatchStream);
  CameraMismatch truth;
  const double lens_scale = scale_of_lenses(camera, scale);
  for (const Side side : urdf::kSides) {
    truth.lens[urdf::index_of(side)] =
        true_lens(camera.lens[urdf::index_of(side)], camera.width_px, random, lens_scale);
  }
  truth.in_link[0] =
      camera.left_in_link * small_pose(random, scale * kMountPosition_m, scale * kMountTurn_deg);
  truth.in_link[1] = truth.in_link[0] * camera.right_in_left *
                     small_pose(random, scale * kBetweenPosition_m, scale * kBetweenTurn_deg);
  return truth;
}

void require_room_for_mismatch(const urdf::StereoCamera& camera, const std::filesystem::path& file,
                               double scale) {
  scale = std::min(scale, kUsualScale);
  for (const Side side : urdf::kSides) {
    const urdf::LensParameters& lens = camera.lens[urdf::index_of(side)];
    if (sees_its_border(lens, camera.width_px, camera.height_px, scale)) continue;
    input::refuse(
        {.file = file,
         .field = side == Side::left ? "left.distortion" : "right.distortion",
         .value = fmt::format("[{:g}]", fmt::join(lens.distortion, ", ")),
         .rule =
             fmt::format("a simulated robot's lens differs from its file by up to {:g} in k1 and {:g} % in "
                         "the focal length, and must not turn back within the picture even then",
                         kFarthestDrawn * scale * kRadial, 1e2 * kFarthestDrawn * scale * kFocalShare),
         .remedy = "Check the order k1, k2, p1, p2, k3, calibrate with corners in the picture's corners, or "
                   "simulate with a smaller mismatch"});
  }
}

}  // namespace gaitway::simulator
