// What the readers of a world file's sections share: the world that grows, names that are given once, and the
// bounds that hold for every part.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/input/yaml_value.hpp"
#include "gaitway/world/world.hpp"

namespace gaitway::world {

inline constexpr input::Range kPosition_m{-kFarthest_m, kFarthest_m, "m"};
inline constexpr input::Range kLength_m{0.002, 2.0 * kFarthest_m, "m"};
inline constexpr input::Range kHeight_m{0.001, 10.0, "m"};
inline constexpr input::Range kAngle_deg{-360.0, 360.0, "deg"};
inline constexpr input::Range kFriction{0.01, 5.0, ""};
// Ground begins below the floor: a solid of a millimetre would be too thin to stand on.
inline constexpr double kBuried_m = 0.05;

// Surfaces of parts that name none: one for each kind, and a second one for every other step, so that one
// sees where the next begins.
inline constexpr std::size_t kSecondStepSurface = 7, kUsualSurfaces = 8;

class WorldReader {
 public:
  // With the usual surfaces.
  explicit WorldReader(const std::filesystem::path& file);

  void add_surface(const input::YamlValue& value, const std::string& surface_name, Surface surface);
  // What a part's `surface` names, or its kind's own.
  [[nodiscard]] std::size_t surface_of(const input::YamlValue& part, Kind kind) const;
  // What a part's `name` says, or its kind and a number.
  [[nodiscard]] std::string name_of(const input::YamlValue& part, const char* what);
  // A solid with a part's name, surface and friction, its place still open.
  [[nodiscard]] Solid solid_of(const input::YamlValue& part, Kind kind, const std::string& part_name) const;

  // Refuse at `part` what is one too many, too far away, or has a name that is taken.
  void add(const input::YamlValue& part, Solid solid);
  void add(const input::YamlValue& part, Thing thing);

  World world;

 private:
  void check(const input::YamlValue& part, const Solid& solid);

  std::vector<std::string> surface_names_;  // of the file, behind those of the kinds
  std::map<std::string, int> lines_;        // of every name
  std::map<std::string, int> counts_;       // of parts without a name
};

[[nodiscard]] double number_or(const input::YamlValue& map, std::string_view key, const input::Range& range,
                               double otherwise);
[[nodiscard]] bool flag_of(const input::YamlValue& map, std::string_view key);  // `key: true`
// On the floor, turned about the vertical: of a map's `position_m` and `yaw_deg`.
[[nodiscard]] Eigen::Isometry3d place_of(const input::YamlValue& map);
// Length, width and height of a box.
[[nodiscard]] Eigen::Vector3d box_size(const input::YamlValue& value);
// A box whose lower face's middle is at (x, y, bottom) of a place.
void set_box(Solid& solid, const Eigen::Isometry3d& place, const Eigen::Vector3d& bottom_m,
             const Eigen::Vector3d& size_m);

void read_boxes(WorldReader& reader, const input::YamlValue& list);
void read_steps(WorldReader& reader, const input::YamlValue& list);
void read_slopes(WorldReader& reader, const input::YamlValue& list);
void read_tiles(WorldReader& reader, const input::YamlValue& list);
void read_walls(WorldReader& reader, const input::YamlValue& list);
void read_things(WorldReader& reader, const input::YamlValue& list);
// After all others: it keeps off them and off the start.
void read_random(WorldReader& reader, const input::YamlValue& list);

}  // namespace gaitway::world
