// What can be spawned into a simulated world, and the URIs that say it:
// gaitway:SHAPE?size=X,Y,Z&mass=KG&colour=R,G,B.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/simulation_interfaces_types.hpp"

namespace gaitway::api {

// No body that can be spawned; the text names the part, its value and the rule.
class SpawnableError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct SpawnableBody {
  std::string shape;                   // box, cylinder or sphere
  std::array<double, 3> size_m{};      // whole; a cylinder's axis is z
  std::optional<double> mass_kg;       // nothing: it stands fast
  std::array<double, 3> colour_rgb{};  // 0 to 1
};

inline constexpr double kLeastSize_m = 0.01, kLargestSize_m = 5.0, kLeastMass_kg = 0.001,
                        kLargestMass_kg = 1000.0;

// Whether the URI is of this form at all, whatever follows.
[[nodiscard]] bool is_spawnable_uri(std::string_view uri) noexcept;
// Throws SpawnableError. Parts that are left out: the size of 0.1 m, a colour of the shape's own.
[[nodiscard]] SpawnableBody spawnable_of(std::string_view uri);

// One of each shape, with what it says of itself.
[[nodiscard]] std::vector<ros::simulation::Spawnable> spawnables();

}  // namespace gaitway::api
