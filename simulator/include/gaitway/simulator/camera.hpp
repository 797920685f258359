// Off-screen pictures of the simulated robot.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gaitway/simulator/plant.hpp"

namespace gaitway::simulator {

struct Image {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;  // rows from top to bottom
};

// Where the camera stands: so far from what it looks at, in a direction of it. Azimuth 90 deg and elevation
// -90 deg is a map: from above, x to the right, y up.
struct View {
  Eigen::Vector3d look_at_m = Eigen::Vector3d::Zero();
  double distance_m = 1.5;
  double azimuth_deg = 0.0, elevation_deg = 0.0;
};
inline constexpr double kFieldOfView_deg = 45.0;  // from top to bottom

// Needs EGL, but no display. The plant must outlive its camera, and may neither be moved nor assigned
// meanwhile. Several cameras may live at once; one is used by one thread at a time.
class Camera {
 public:
  // Throws std::runtime_error naming the cause where no OpenGL is to be had, std::invalid_argument for a size
  // beyond 1 x 1 to 1920 x 1080.
  Camera(const Plant& plant, int width_px, int height_px);
  ~Camera();
  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;

  // The robot in a pose (Plant::positions()), from its left and a little from the front; the camera follows
  // the robot but does not turn with it. Where something of the world stands in between it goes aside. Throws
  // std::invalid_argument for a pose of another robot.
  Image render(std::span<const double> positions);
  Image render(std::span<const double> positions, const View& view);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// Images of one size in rows of `columns`, as a PNG; an unfinished last row is filled with white. Throws
// std::runtime_error naming the file, std::invalid_argument for no image, unequal sizes or less than one
// column.
void write_film_strip(const std::string& file, std::span<const Image> images, int columns);

}  // namespace gaitway::simulator
