// A ray tracer for planes: nearest hit, texture by value noise in the surface's own coordinates.
#include "synthetic_scene.hpp"

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gaitway::vision::testing {
namespace {

constexpr int kPlaces = 2;  // along either side of a pixel
constexpr double kFarAway_m = 60.0;

double hashed(int x, int y, unsigned seed) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U +
                    seed * 2246822519U;
  h = (h ^ (h >> 13U)) * 1274126177U;
  h ^= h >> 16U;
  return static_cast<double>(h & 0xFFFFU) / 65535.0 - 0.5;
}

double smooth_noise(double x, double y, unsigned seed) {
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const double u = x - x0, v = y - y0;
  const double top = hashed(x0, y0, seed) * (1 - u) + hashed(x0 + 1, y0, seed) * u;
  const double bottom = hashed(x0, y0 + 1, seed) * (1 - u) + hashed(x0 + 1, y0 + 1, seed) * u;
  return top * (1 - v) + bottom * v;
}

// Grains of 4 mm to 6 cm.
double texture(const Eigen::Vector2d& place_m, double contrast, unsigned seed) {
  double sum = 0.0;
  double grains = 16.0;
  for (unsigned octave = 0; octave < 5; ++octave, grains *= 2.0) {
    sum += smooth_noise(grains * place_m.x(), grains * place_m.y(), seed + octave);
  }
  return 120.0 + contrast * sum;
}

struct Bits {
  Bits() {
    apriltag_family_t* const family = tag36h11_create();
    for (std::uint32_t id = 0; id < family->ncodes; ++id) {
      image_u8_t* const image = apriltag_to_image(family, static_cast<int>(id));
      std::array<std::uint8_t, 100> tag{};
      for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 10; ++x)
          tag[static_cast<std::size_t>(10 * y + x)] = image->buf[y * image->stride + x];
      }
      image_u8_destroy(image);
      tags.push_back(tag);
    }
    tag36h11_destroy(family);
  }
  std::vector<std::array<std::uint8_t, 100>> tags;  // ten by ten cells with the white border
};

// Of the tag at a place in its frame; nothing: it is beside.
std::optional<double> tag_grey(const SceneTag& tag, const Eigen::Vector2d& place_m) {
  static const Bits bits;
  const double cell_m = tag.size_m / 8.0;
  const int x = static_cast<int>(std::floor(place_m.x() / cell_m)) + 5;
  const int y = 4 - static_cast<int>(std::floor(place_m.y() / cell_m));
  if (x < 0 || x > 9 || y < 0 || y > 9) return std::nullopt;
  const bool white = bits.tags[static_cast<std::size_t>(tag.id)][static_cast<std::size_t>(10 * y + x)] > 127;
  return white ? 215.0 : 25.0;
}

std::optional<double> board_grey(const SceneBoard& board, const Eigen::Vector2d& place_m) {
  const int x = static_cast<int>(std::floor(place_m.x() / board.square_m));
  const int y = static_cast<int>(std::floor(place_m.y() / board.square_m));
  if (x < -2 || y < -2 || x > board.columns || y > board.rows) return std::nullopt;
  const bool border = x == -2 || y == -2 || x == board.columns || y == board.rows;
  return border || (x + y) % 2 != 0 ? 220.0 : 30.0;
}

struct Hit {
  double distance = kFarAway_m;
  double grey = 190.0;  // of the sky
};

void hit_box(const SceneBox& box, const Eigen::Vector3d& from_m, const Eigen::Vector3d& along,
             double contrast, unsigned seed, Hit& hit) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(-box.yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3d from = turn * (from_m - box.middle_m), ray = turn * along;
  double near = 0.0, far = kFarAway_m;
  int axis = -1;
  for (int i = 0; i < 3; ++i) {
    const double a = (-0.5 * box.size_m[i] - from[i]) / ray[i], b = (0.5 * box.size_m[i] - from[i]) / ray[i];
    if (std::min(a, b) > near) {
      near = std::min(a, b);
      axis = i;
    }
    far = std::min(far, std::max(a, b));
  }
  if (axis < 0 || near >= far || near >= hit.distance) return;
  const Eigen::Vector3d at = from + near * ray;
  const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  const double shade = axis == 2 ? 30.0 : axis == 0 ? 0.0 : -25.0;
  hit = {near, shade + texture({at[u], at[v]}, contrast, seed + 17U * static_cast<unsigned>(axis))};
}

// A thin plate with a picture on it: a tag or a board.
template <class Plate>
void hit_plate(const Plate& plate, std::optional<double> (*grey)(const Plate&, const Eigen::Vector2d&),
               const Eigen::Vector3d& from_m, const Eigen::Vector3d& along, Hit& hit) {
  const Eigen::Vector3d from = plate.pose.inverse() * from_m;
  const Eigen::Vector3d ray = plate.pose.linear().transpose() * along;
  const double distance = -from.z() / ray.z();
  if (from.z() <= 0.0 || ray.z() >= 0.0 || distance > hit.distance) return;
  const Eigen::Vector3d at = from + distance * ray;
  if (const auto seen = grey(plate, at.head<2>())) hit = {distance, *seen};
}

}  // namespace

double Scene::grey(const Eigen::Vector3d& from_m, const Eigen::Vector3d& along) const {
  Hit hit;
  if (along.z() < 0.0 && -from_m.z() / along.z() < hit.distance) {
    hit.distance = -from_m.z() / along.z();
    const Eigen::Vector3d at = from_m + hit.distance * along;
    hit.grey = texture(at.head<2>(), ground_contrast, seed);
  }
  for (const SceneBox& box : boxes) hit_box(box, from_m, along, box_contrast, seed + 101U, hit);
  for (const SceneTag& tag : tags) hit_plate(tag, tag_grey, from_m, along, hit);
  for (const SceneBoard& board : boards) hit_plate(board, board_grey, from_m, along, hit);
  return hit.grey;
}

SceneCamera::SceneCamera(const urdf::StereoCamera& camera) : camera_(camera) {
  for (std::size_t side = 0; side < 2; ++side) {
    const urdf::Lens lens(camera.lens[side]);
    for (int y = 0; y < camera.height_px; ++y) {
      for (int x = 0; x < camera.width_px; ++x) {
        for (int place = 0; place < kPlaces * kPlaces; ++place) {
          const Eigen::Vector2d pixel(x + (place % kPlaces + 0.5) / kPlaces - 0.5,
                                      y + (place / kPlaces + 0.5) / kPlaces - 0.5);
          rays_[side].push_back(lens.unproject(pixel));
        }
      }
    }
  }
}

std::vector<std::uint8_t> SceneCamera::expose(const Scene& scene, const Way& left, std::int64_t stamp_ns,
                                              std::size_t side, const Exposure& exposure) {
  std::vector<std::uint8_t> picture;
  std::normal_distribution<double> noise(0.0, exposure.noise);
  std::size_t ray = 0;
  for (int y = 0; y < camera_.height_px; ++y) {
    const double from_middle_s = (static_cast<double>(y) / (camera_.height_px - 1) - 0.5) * camera_.readout_s;
    Eigen::Isometry3d pose = left(stamp_ns + static_cast<std::int64_t>(1e9 * from_middle_s));
    if (side == 1) pose = pose * camera_.right_in_left;
    for (int x = 0; x < camera_.width_px; ++x) {
      double sum = 0.0;
      for (int place = 0; place < kPlaces * kPlaces; ++place, ++ray) {
        const auto& direction = rays_[side][ray];
        if (!direction) continue;
        sum += scene.grey(pose.translation(),
                          pose.linear() * Eigen::Vector3d(direction->x(), direction->y(), 1.0));
      }
      const double grey = exposure.gain[side] * sum / (kPlaces * kPlaces) + noise(random_);
      picture.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(grey), 0L, 255L)));
    }
  }
  return picture;
}

TakenPair SceneCamera::take(const Scene& scene, const Way& left, std::int64_t stamp_ns, std::uint64_t number,
                            const Exposure& exposure) {
  TakenPair taken;
  taken.left = expose(scene, left, stamp_ns, 0, exposure);
  taken.right = expose(scene, left, stamp_ns, 1, exposure);
  taken.pair = {.stamp_ns = stamp_ns,
                .readout_ns = static_cast<std::int64_t>(1e9 * camera_.readout_s),
                .number = number,
                .width = camera_.width_px,
                .height = camera_.height_px,
                .left = {},
                .right = {}};
  taken.refer();
  return taken;
}

}  // namespace gaitway::vision::testing
