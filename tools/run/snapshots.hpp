// The poses for a run's film strip, taken while it goes on and drawn after it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/simulator/camera.hpp"
#include "gaitway/simulator/plant.hpp"

namespace gaitway::tools {

class Snapshots {
 public:
  static constexpr int kPictures = 8;

  // The first one at `from_s`. `open_end`: nobody knows how long the run is, and every second one is dropped
  // when there are too many.
  Snapshots(double from_s, double interval_s, bool open_end)
      : interval_s_(interval_s), next_s_(from_s), open_end_(open_end) {}

  // After each millisecond.
  void look(const simulator::Plant& plant);
  // What has been taken so far; before the world changes, since a pose belongs to its world.
  void draw_before_change(const simulator::Plant& plant) noexcept;
  // Throws std::runtime_error where no pictures can be drawn or written.
  void write(const simulator::Plant& plant, const std::filesystem::path& file);

 private:
  void draw(const simulator::Plant& plant);

  double interval_s_;
  double next_s_;
  bool open_end_;
  std::string failure_;
  struct Pose {
    std::vector<double> positions;
    simulator::Image image;  // without pixels: not drawn yet
  };
  std::vector<Pose> poses_;
};

}  // namespace gaitway::tools
