// Pictures of a small world as a stereo camera takes them, ray by ray: ground, boxes and tags with texture,
// lens, rolling shutter, exposure and noise. Knows nothing of how pictures are looked at.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "gaitway/urdf/camera_file.hpp"
#include "gaitway/urdf/lens.hpp"
#include "gaitway/vision/pictures.hpp"

namespace gaitway::vision::testing {

struct SceneBox {
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
  double yaw_rad = 0.0;
};

struct SceneTag {
  int id = 0;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // z out of it, x to its reader's right, y up
  double size_m = 0.15;                                    // of the black square; with a white border
};

struct SceneBoard {
  int columns = 9,
      rows = 6;  // inner corners; its origin is the first of them, x along a row, y along a column
  double square_m = 0.025;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // z out of it
};

struct Scene {
  std::vector<SceneBox> boxes;
  std::vector<SceneTag> tags;
  std::vector<SceneBoard> boards;
  double ground_contrast = 60.0, box_contrast = 60.0;  // grey levels of the texture
  unsigned seed = 1;

  // Grey, 0 to 255, of what a ray from `from_m` meets.
  [[nodiscard]] double grey(const Eigen::Vector3d& from_m, const Eigen::Vector3d& along) const;
};

struct Exposure {
  std::array<double, 2> gain{1.0, 1.0};
  double noise = 2.0;  // grey levels
};

// A pair and the pixels that it looks at.
struct TakenPair {
  std::vector<std::uint8_t> left, right;
  PicturePair pair;
  void refer() {
    pair.left = left;
    pair.right = right;
  }
};

class SceneCamera {
 public:
  explicit SceneCamera(const urdf::StereoCamera& camera);

  // Pose of the left camera's optical frame in the world at each instant, in ns.
  using Way = std::function<Eigen::Isometry3d(std::int64_t)>;
  [[nodiscard]] TakenPair take(const Scene& scene, const Way& left, std::int64_t stamp_ns,
                               std::uint64_t number, const Exposure& exposure = {});

 private:
  std::vector<std::uint8_t> expose(const Scene& scene, const Way& left, std::int64_t stamp_ns,
                                   std::size_t side, const Exposure& exposure);

  urdf::StereoCamera camera_;
  std::array<std::vector<std::optional<Eigen::Vector2d>>, 2> rays_;  // of four places in each pixel
  std::mt19937 random_{7};
};

}  // namespace gaitway::vision::testing
