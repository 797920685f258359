// What a simulated robot walks in: floor, solids, things that can be pushed, tags, lights, and where it
// begins. Values alone, in the world's frame (x forward, y left, z up; the floor is z = 0); world_file.hpp
// reads them.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaitway::world {

using Colour = std::array<double, 3>;  // red, green, blue, each 0..1

// How something looks.
struct Surface {
  enum class Kind { plain, checker, noise, image };
  Kind kind = Kind::plain;
  std::array<Colour, 2> colours{};  // plain has the first one alone, noise whatever lies between the two
  double repeat_m = 0.2;            // after so much it looks the same again
  std::uint64_t seed = 1;           // of noise
  std::filesystem::path image;      // PNG
};

enum class Kind { floor, box, step, slope, tile, wall, thing };
[[nodiscard]] const char* name(Kind kind) noexcept;
// What soles are meant to stand on.
[[nodiscard]] constexpr bool is_ground(Kind kind) noexcept {
  return kind == Kind::floor || kind == Kind::step || kind == Kind::slope || kind == Kind::tile;
}

// From lowest to highest z of what a solid takes of a vertical line.
struct Interval {
  double bottom_m = 0.0, top_m = 0.0;
};

// One convex body.
struct Solid {
  enum class Shape { box, cylinder, sphere };
  Kind kind = Kind::box;
  Shape shape = Shape::box;
  std::string name;
  int line = 0;                                            // of the file
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  // of its centre
  Eigen::Vector3d size_m =
      Eigen::Vector3d::Constant(0.1);  // whole; a cylinder's axis is z, x and y are alike
  std::optional<double> friction;      // none: the floor's
  std::size_t surface = 0;             // in World::surfaces

  // Exact, however it is turned; none: the line does not meet it.
  [[nodiscard]] std::optional<Interval> on_vertical(double x_m, double y_m) const noexcept;
  // Least and greatest x, y and z.
  [[nodiscard]] std::pair<Eigen::Vector3d, Eigen::Vector3d> bounds_m() const noexcept;
};

// What can be pushed.
struct Thing {
  Solid solid;
  double mass_kg = 1.0;
};

struct Light {
  enum class Kind { sun, lamp };
  Kind kind = Kind::sun;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();   // of a lamp
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ();  // the way a sun's light goes
  Colour colour{0.7, 0.7, 0.7};                           // brightness included
};

// A tag of the family 36h11; see picture.hpp. It is seen and touches nothing.
struct Tag {
  int id = 0;
  double size_m = 0.1;  // side of the black square
  // Of its middle: z comes out of the picture, x goes to the reader's right, y up.
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

// Of the robot: of the middle between its feet, and where it looks.
struct Start {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;
  int line = 0;  // of the file; 0: it is not said there
};

struct World {
  std::filesystem::path file;
  std::string name;                          // the file's, without folder and ending
  std::optional<std::uint64_t> random_seed;  // in place of those of the file's random courses
  std::optional<double> floor_friction;      // none: the robot's own value
  std::size_t floor_surface = 0;
  std::vector<Surface> surfaces;
  std::vector<Solid> solids;
  std::vector<Thing> things;
  std::vector<Light> lights;  // none: the simulator's own
  std::vector<Tag> tags;
  Start start;

  // The floor, what stands on it and, where `with_things`, what can be pushed, where it lies at the start.
  [[nodiscard]] std::vector<Solid> all_solids(bool with_things) const;
  // Of the solid of that name in all_solids(true); -1: there is none.
  [[nodiscard]] int index_of(std::string_view solid) const;
};

// The most there may be of each.
inline constexpr std::size_t kMostSolids = 2000, kMostThings = 64, kMostTags = 128, kMostLights = 7,
                             kMostSurfaces = 64;
inline constexpr double kFarthest_m = 50.0;  // from the world's origin, along either axis

}  // namespace gaitway::world
