// The world from any point of it, drawn with MuJoCo through a pinhole: what stands before a lens.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/simulator/plant.hpp"
#include "offscreen_context.hpp"
#include "physics_model.hpp"

namespace gaitway::simulator {

// Pixels through a pinhole: pixel (column, row) shows the direction (x, y) = (left + (column + 0.5) / scale,
// top + (row + 0.5) / scale) at z = 1 of the optical frame.
struct PinholeWindow {
  double left = 0.0, top = 0.0;
  double scale = 1.0;  // pixels for each unit of x and y
  int width_px = 0, height_px = 0;
};

struct GreyPicture {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> grey;  // rows from top to bottom; 0 no light .. 255 the most that is drawn
};

struct SceneLook {
  int shadow_px = 1024;                    // side of the shadow map; 0: no shadows
  int samples = 4;                         // for each pixel of an edge
  int widest_px = 1024, highest_px = 768;  // of a window
};

// The plant outlives it, and may change its world meanwhile: what is drawn changes with it. For one thread.
class SceneView {
 public:
  // What belongs to `hidden_link` is not seen: a camera looks out of it. Throws std::runtime_error naming the
  // cause where no OpenGL is to be had.
  SceneView(const Plant& plant, int hidden_link, const SceneLook& look);
  ~SceneView();
  SceneView(const SceneView&) = delete;
  SceneView& operator=(const SceneView&) = delete;

  // Of the plant's world as it is now.
  [[nodiscard]] bool is_of(const Plant& plant) const noexcept;

  // A robot in a pose (Plant::positions()): where a link is in the world.
  [[nodiscard]] Eigen::Isometry3d link_pose(std::span<const double> positions, int link);
  // `optical`: of the optical frame in the world. `sun_over`: shadows are drawn around there.
  void draw(std::span<const double> positions, const Eigen::Isometry3d& optical, const PinholeWindow& window,
            const Eigen::Vector3d& sun_over, GreyPicture& picture);

 private:
  void pose(std::span<const double> positions);
  void aim(const Eigen::Isometry3d& optical, const PinholeWindow& window, const Eigen::Vector3d& sun_over);

  std::uint32_t geometry_;
  const mjModel* plants_;  // whose tiles move on
  ModelPointer model_;     // a copy, drawn otherwise
  DataPointer data_;
  OffscreenContext offscreen_;
  mjvScene scene_;
  mjvOption option_;
  mjvCamera camera_;
  mjrContext context_;
  std::vector<std::uint8_t> rgb_;
};

}  // namespace gaitway::simulator
