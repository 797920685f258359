// The map's obstacles as boxes on the ground, the same ones from pair to pair as long as nothing has changed.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/vision/height_map.hpp"

namespace gaitway::vision {

struct Box {
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();  // in odometry
  double yaw_rad = 0.0;                                // of the length, in [0, π/2)
  Eigen::Vector2d size_m = Eigen::Vector2d::Zero();    // along yaw, across
  double height_m = 0.0;
};

// Cells that touch belong together; what no single box suits becomes several. `eye_m`: where the camera is.
[[nodiscard]] std::vector<Box> boxes_in(const HeightMap& map, const Eigen::Vector2d& eye_m);

// Keeps what was told before where the new one is the same but for noise: who plans by it would plan anew
// each time.
class ObstacleList {
 public:
  // True: the list has changed.
  bool renew(const std::vector<Box>& seen);
  [[nodiscard]] const std::vector<Box>& boxes() const noexcept { return told_; }
  void write(Obstacles& obstacles, std::int64_t stamp_ns) const noexcept;

 private:
  std::vector<Box> told_;
};

}  // namespace gaitway::vision
