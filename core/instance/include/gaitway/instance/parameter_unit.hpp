// Units as people write them behind a number: SI units with the usual prefixes, and units of the robot's own
// body, so that one configuration suits bodies of any size.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace gaitway::core {

// What a body measures lengths, times and forces in.
struct BodyUnits {
  double hip_height_m = 0.0;  // h: of the hip axes above the ground in the standing posture
  double mass_kg = 0.0;       // W is its weight

  [[nodiscard]] double time_s() const noexcept;    // T = sqrt(h / gravity)
  [[nodiscard]] double weight_N() const noexcept;  // W
};

// Of the robot described in that folder. Throws what loading it throws.
[[nodiscard]] BodyUnits body_units_of(const std::filesystem::path& robot_directory);

// A unit taken apart: how much of SI's unit it is, and the powers that say of what kind.
struct UnitMeasure {
  double size = 1.0;
  double metres = 0.0, seconds = 0.0, kilograms = 0.0, radians = 0.0;
  bool of_body = false;  // h, T or W stands in it

  [[nodiscard]] bool is_like(const UnitMeasure& other) const noexcept;
};

// "m/s^2", "deg", "rad/(m*s)", "h/T", "1/T", "W*h": names with `*`, `/`, `^` and brackets, from left to
// right. Names: m, cm, mm, s, ms, us, kg, N, Nm, rad, mrad, deg, 1; of the body h (hip height), T
// (sqrt(h/gravity)) and W (weight). Nothing for any other text. Without `body`, units of the body are
// measured with sizes of 1.
[[nodiscard]] std::optional<UnitMeasure> measure_of(std::string_view unit, const BodyUnits* body);

// "h*T^-1" for a speed: how a unit of this kind is written in units of the body.
[[nodiscard]] std::string in_body_units(const UnitMeasure& measure);

}  // namespace gaitway::core
