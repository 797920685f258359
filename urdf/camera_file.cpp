// Reads a camera strictly: a lens that maps two directions to one pixel, a pair that takes longer than its
// turn and a right camera that is not on the right are refused.
#include "gaitway/urdf/camera_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"

namespace gaitway::urdf {
namespace {

using Keys = std::vector<std::string_view>;

using facts::kRadPerDegree;
constexpr input::Range kMounted_m{-2.0, 2.0, "m"};
constexpr input::Range kMounted_deg{-180.0, 180.0, "deg"};
constexpr input::Range kBetween_m{-1.0, 1.0, "m"};
constexpr input::Range kBetween_deg{-30.0, 30.0, "deg"};
constexpr input::Range kRate_hz{0.1, 100.0, "Hz"};
constexpr input::Range kLatency_s{0.0, 1.0, "s"};
constexpr input::Range kExposure_s{1e-5, 0.1, "s"};
constexpr input::Range kReadout_s{0.0, 0.1, "s"};
constexpr input::Range kRadial{-2.0, 2.0, ""};
constexpr input::Range kTangential{-0.05, 0.05, ""};
constexpr double kLeastBase_m = 0.005;
constexpr double kWidestSeen = 3.0;  // of a direction's distance from the axis at z = 1: 71.6 degrees

void read_size(const input::YamlValue& value, StereoCamera& camera) {
  const std::vector<input::YamlValue> size = value.items(2);
  camera.width_px = size[0].integer(1, 1 << 16);
  camera.height_px = size[1].integer(1, 1 << 16);
  const bool small = camera.width_px == 320 && camera.height_px == 240;
  const bool large = camera.width_px == 640 && camera.height_px == 480;
  if (!small && !large) {
    value.refuse(fmt::format("{} x {} is no size of a picture: 320 x 240 or 640 x 480", camera.width_px,
                             camera.height_px),
                 "Write [320, 240] or [640, 480]; a lens's numbers are those of that size");
  }
}

double angle_or_zero(const input::YamlValue& map, std::string_view key) {
  const auto angle = map.find(key);
  return angle ? angle->number(kMounted_deg) * kRadPerDegree : 0.0;
}

// x ahead, y left, z up to x right, y down, z ahead.
Eigen::Matrix3d optical_axes() {
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return axes;
}

Eigen::Isometry3d pose_in_link(const input::YamlValue& top) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(top.at("position_m").numbers<3>(kMounted_m).data());
  const Eigen::Quaterniond turned =
      Eigen::AngleAxisd(angle_or_zero(top, "yaw_deg"), Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(angle_or_zero(top, "pitch_deg"), Eigen::Vector3d::UnitY()) *
      Eigen::AngleAxisd(angle_or_zero(top, "roll_deg"), Eigen::Vector3d::UnitX());
  pose.linear() = turned.toRotationMatrix() * optical_axes();
  return pose;
}

Eigen::Isometry3d pose_in_left(const input::YamlValue& map) {
  map.require_map(Keys{"position_m", "rotation_deg"});
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const input::YamlValue position = map.at("position_m");
  pose.translation() = Eigen::Vector3d(position.numbers<3>(kBetween_m).data());
  if (pose.translation().x() < kLeastBase_m || pose.translation().tail<2>().norm() > pose.translation().x()) {
    position.refuse(fmt::format("the right camera must lie at least {} mm to the right of the left one, and "
                                "less ahead and below than to the right",
                                kLeastBase_m * 1e3),
                    "x goes to the right in the left camera's picture, y down, z ahead");
  }
  if (const auto rotation = map.find("rotation_deg")) {
    const Eigen::Vector3d turn_rad =
        Eigen::Vector3d(rotation->numbers<3>(kBetween_deg).data()) * kRadPerDegree;
    if (turn_rad.norm() > 0.0) {
      pose.linear() = Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()).toRotationMatrix();
    }
  }
  return pose;
}

// Whether each of a grid of places over the picture is seen from one direction, and that one at the place.
bool sees_its_picture(const LensParameters& parameters, int width_px, int height_px) {
  constexpr int kParts = 16;
  constexpr double kSame_px = 1e-6;
  const Lens lens(parameters);
  for (int row = 0; row <= kParts; ++row) {
    for (int column = 0; column <= kParts; ++column) {
      const Eigen::Vector2d pixel(-0.5 + static_cast<double>(width_px * column) / kParts,
                                  -0.5 + static_cast<double>(height_px * row) / kParts);
      const auto direction = lens.unproject(pixel);
      if (!direction || direction->norm() > kWidestSeen) return false;
      const auto back = lens.project(direction->homogeneous());
      if (!back || (*back - pixel).norm() > kSame_px) return false;
    }
  }
  return true;
}

LensParameters read_lens(const input::YamlValue& map, const StereoCamera& camera) {
  map.require_map(Keys{"fx_px", "fy_px", "cx_px", "cy_px", "distortion"});
  const double width = camera.width_px, height = camera.height_px;
  LensParameters lens;
  lens.fx_px = map.at("fx_px").number({0.2 * width, 10.0 * width, "px"});
  lens.fy_px = map.at("fy_px").number({0.2 * width, 10.0 * width, "px"});
  lens.cx_px = map.at("cx_px").number({0.0, width, "px"});
  lens.cy_px = map.at("cy_px").number({0.0, height, "px"});
  if (const auto distortion = map.find("distortion")) {
    const std::vector<input::YamlValue> numbers = distortion->items(lens.distortion.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      lens.distortion[k] = numbers[k].number(k == 2 || k == 3 ? kTangential : kRadial);
    }
  }
  if (!sees_its_picture(lens, camera.width_px, camera.height_px)) {
    map.refuse(
        "the distortion turns back, or sees more than 71 degrees aside, within the picture: a pixel must "
        "be seen from one direction",
        "Check the order k1, k2, p1, p2, k3 and that the numbers are those of this size of picture");
  }
  return lens;
}

void read_times(const input::YamlValue& top, StereoCamera& camera) {
  const input::YamlValue rate = top.at("rate_hz");
  camera.rate_hz = rate.number(kRate_hz);
  camera.latency_s = top.at("latency_s").number(kLatency_s);
  camera.exposure_s = top.at("exposure_s").number(kExposure_s);
  camera.readout_s = top.at("readout_s").number(kReadout_s);
  if (camera.exposure_s + camera.readout_s > 1.0 / camera.rate_hz) {
    rate.refuse(
        fmt::format("a picture takes {:g} s to expose and read out, longer than the {:g} s between two",
                    camera.exposure_s + camera.readout_s, 1.0 / camera.rate_hz),
        "Lower rate_hz, exposure_s or readout_s");
  }
  if (camera.latency_s < 0.5 * (camera.exposure_s + camera.readout_s)) {
    top.at("latency_s")
        .refuse(fmt::format(
                    "the last row is exposed {:g} s after the stamp, the middle of the middle row's exposure",
                    0.5 * (camera.exposure_s + camera.readout_s)),
                "A picture comes later than its last row: raise latency_s");
  }
}

}  // namespace

StereoCamera read_stereo_camera(const std::filesystem::path& file) {
  const input::YamlValue top = input::YamlValue::read(file);
  top.require_map(Keys{"link", "position_m", "pitch_deg", "roll_deg", "yaw_deg", "size_px", "rate_hz",
                       "latency_s", "exposure_s", "readout_s", "left", "right", "right_from_left"});
  StereoCamera camera;
  camera.link = top.at("link").text();
  camera.left_in_link = pose_in_link(top);
  camera.right_in_left = pose_in_left(top.at("right_from_left"));
  read_size(top.at("size_px"), camera);
  read_times(top, camera);
  camera.lens = {read_lens(top.at("left"), camera), read_lens(top.at("right"), camera)};
  return camera;
}

std::optional<StereoCamera> stereo_camera_of(const RobotModel& model) {
  const std::filesystem::path file = model.directory / "camera.yaml";
  if (!std::filesystem::exists(file)) return std::nullopt;
  StereoCamera camera = read_stereo_camera(file);
  std::vector<std::string> known;
  std::transform(model.links.begin(), model.links.end(), std::back_inserter(known),
                 [](const Link& link) { return link.name; });
  if (std::find(known.begin(), known.end(), camera.link) == known.end()) {
    input::YamlValue::read(file).at("link").refuse(
        fmt::format("the robot '{}' has no link '{}'", model.name, camera.link),
        input::suggest(camera.link, known));
  }
  return camera;
}

}  // namespace gaitway::urdf
