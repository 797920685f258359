// A robot's stereo camera (urdf/camera_file.hpp). Whatever the text: it is refused with urdf::RobotError and
// nothing else, or gives two cameras that see each pixel of their pictures from one direction, in time.
#include "gaitway/urdf/camera_file.hpp"

#include <cmath>
#include <cstdint>
#include <span>

#include "fuzz_input.hpp"
#include "memory_file.hpp"

namespace gaitway::fuzz {
namespace {

void check_lens(const urdf::StereoCamera& camera, const urdf::LensParameters& parameters) {
  const urdf::Lens lens(parameters);
  for (const double u : {0.0, 0.5 * camera.width_px, camera.width_px - 1.0}) {
    for (const double v : {0.0, 0.5 * camera.height_px, camera.height_px - 1.0}) {
      const auto direction = lens.unproject({u, v});
      require(direction && direction->allFinite(), "every pixel is seen from a direction");
      const auto back = lens.project(direction->homogeneous());
      require(back && (*back - Eigen::Vector2d(u, v)).norm() < 1e-6, "which is seen at that pixel");
    }
  }
}

}  // namespace

void camera_file(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(Input(bytes).rest_as_text());
  urdf::StereoCamera camera;
  try {
    camera = urdf::read_stereo_camera(file.path());
  } catch (const urdf::RobotError&) {
    return;
  }
  for (const urdf::Side side : {urdf::Side::left, urdf::Side::right}) {
    const Eigen::Isometry3d pose = camera.in_link(side);
    require(pose.matrix().allFinite() && std::abs(pose.linear().determinant() - 1.0) < 1e-9,
            "a pose turns and does not stretch");
    check_lens(camera, camera.lens[urdf::index_of(side)]);
  }
  require(camera.base_m() > 0.0, "two cameras are in two places");
  require(camera.exposure_s > 0.0 && camera.exposure_s + camera.readout_s <= 1.0 / camera.rate_hz,
          "a picture is taken before the next one");
  require(camera.latency_s >= 0.5 * (camera.exposure_s + camera.readout_s), "and comes after its last row");
}

}  // namespace gaitway::fuzz
