// Whether one step can be made where it is: ground under the sole, room for the body, and a free way for the
// foot in the air.
#pragma once

#include <optional>

#include "gaitway/planning/limits.hpp"
#include "step_lattice.hpp"
#include "terrain.hpp"

namespace gaitway::planning {

// A foot on the ground.
struct Standing {
  Pose pose;
  double height_m = 0.0;
};

class StepCheck {
 public:
  StepCheck(const Limits& limits, const StepLattice& lattice, const Terrain& terrain) noexcept
      : limits_(limits), lattice_(lattice), terrain_(terrain) {}

  // How high a sole stands there; none: it is not wholly on level ground that can be walked up to, or its
  // toes or sides touch something higher.
  [[nodiscard]] std::optional<double> height_at(const Place& place) const noexcept;
  [[nodiscard]] std::optional<double> height_at(const Pose& foot) const;
  // The same without any rule: of whatever is under the middle of the sole.
  [[nodiscard]] double surface_below_m(const Pose& foot) const noexcept;

  // The bands, a bit each, in whose way there is anything that a step from there may reach.
  [[nodiscard]] unsigned crowded_bands(const Cell& stance) const noexcept;
  // In the bands that are `crowded`; without it in all.
  [[nodiscard]] bool has_room(const Place& stance, Side side, std::size_t landing,
                              unsigned crowded = ~0U) const noexcept;
  // Of a step from or to anywhere; `clearance_m` may be less than the limits'.
  [[nodiscard]] bool has_room(const Pose& stance, Side side, const Pose& landing, double clearance_m) const;
  // Of a robot that stands there, on both feet.
  [[nodiscard]] bool has_room(const Pose& left, const Pose& right, double clearance_m) const;

  // The foot gets from one place to the other, past or over what lies in between. `off_ground`: its first
  // place is where the robot stands already, so what touches the sole there is left behind.
  [[nodiscard]] bool can_swing(const Standing& from, const Standing& to, bool leaves_start) const noexcept;

  [[nodiscard]] bool is_step_height(double from_m, double to_m) const noexcept;

 private:
  [[nodiscard]] bool is_on_map(const Points& points) const noexcept;
  [[nodiscard]] bool is_free(std::size_t band, const Points& points, double margin_m) const;

  const Limits& limits_;
  const StepLattice& lattice_;
  const Terrain& terrain_;
};

}  // namespace gaitway::planning
