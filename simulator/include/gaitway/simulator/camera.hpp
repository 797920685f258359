// Off-screen pictures of the simulated robot.
#pragma once

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

// Needs EGL, but no display. Throws std::runtime_error naming the cause where no OpenGL is to be had.
class Camera {
 public:
  Camera(const Plant& plant, int width_px, int height_px);
  ~Camera();
  Camera(const Camera&) = delete;
  Camera& operator=(const Camera&) = delete;

  // The robot in a pose (Plant::positions()), from its left and a little from the front.
  Image render(std::span<const double> positions);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// Images of one size in rows of `columns`, as a PNG. Throws std::runtime_error naming the file.
void write_film_strip(const std::string& file, std::span<const Image> images, int columns);

}  // namespace gaitway::simulator
