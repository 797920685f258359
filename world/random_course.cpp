// Scatters boxes by a seed: each is drawn until it lies in its region, off the start and off what is there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gaitway/facts/random_stream.hpp"
#include "world_reader.hpp"

namespace gaitway::world {
namespace {

using input::YamlValue;
using Keys = std::vector<std::string_view>;

constexpr int kMostBoxes = 500;
constexpr int kDraws = 1000;  // for one box, before the region counts as full

// A solid as seen from above: a rectangle.
struct Footprint {
  Eigen::Vector2d centre_m, along, half_m;

  [[nodiscard]] Eigen::Vector2d across() const { return {-along.y(), along.x()}; }
  // Half of its width as seen along a direction.
  [[nodiscard]] double reach_m(const Eigen::Vector2d& direction) const {
    return half_m.x() * std::abs(along.dot(direction)) + half_m.y() * std::abs(across().dot(direction));
  }
  [[nodiscard]] double distance_m(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d from = point - centre_m;
    const Eigen::Vector2d local(along.dot(from), across().dot(from));
    return (local.cwiseAbs() - half_m).cwiseMax(0.0).norm();
  }
};

Footprint footprint(const Solid& solid) {
  Eigen::Vector2d along = solid.pose.linear().col(0).head<2>();
  along = along.norm() > 1e-9 ? along.normalized() : Eigen::Vector2d::UnitX();
  Footprint result{solid.pose.translation().head<2>(), along, {}};
  const Eigen::Vector3d half = solid.size_m / 2.0;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d direction = axis == 0 ? result.along : result.across();
    const Eigen::Vector3d in_solid =
        solid.pose.linear().transpose() * Eigen::Vector3d(direction.x(), direction.y(), 0.0);
    result.half_m[axis] = solid.shape == Solid::Shape::box ? in_solid.cwiseAbs().dot(half) : half.maxCoeff();
  }
  return result;
}

// Whether a line between them leaves both a gap, on one of the four directions of their sides.
bool are_apart(const Footprint& a, const Footprint& b, double gap_m) {
  const Eigen::Vector2d between = b.centre_m - a.centre_m;
  for (const Eigen::Vector2d& direction : {a.along, a.across(), b.along, b.across()}) {
    if (std::abs(between.dot(direction)) >= a.reach_m(direction) + b.reach_m(direction) + gap_m) return true;
  }
  return false;
}

struct Circle {
  Eigen::Vector2d centre_m;
  double radius_m;
};

struct Course {
  int boxes = 0;
  Eigen::Vector2d from_m, to_m;
  Eigen::Vector3d smallest_m, largest_m;
  std::vector<Circle> clear;
  double gap_m = 0.0;
  std::optional<double> mass_kg;  // of boxes that can be pushed
};

Course read_course(const YamlValue& map, const Start& start) {
  map.require_map(Keys{"name", "seed", "boxes", "from_m", "to_m", "smallest_m", "largest_m", "keep_out_m",
                       "clear", "gap_m", "mass_kg", "friction", "surface"});
  Course course;
  course.boxes = map.at("boxes").integer(1, kMostBoxes);
  course.from_m = Eigen::Vector2d(map.at("from_m").numbers<2>(kPosition_m).data());
  course.to_m = Eigen::Vector2d(map.at("to_m").numbers<2>(kPosition_m).data());
  if (!((course.to_m - course.from_m).minCoeff() > 0.0)) {
    map.at("to_m").refuse("must be beyond from_m along both axes",
                          "from_m is the region's corner with the least x and y, to_m the one with the most");
  }
  course.smallest_m = box_size(map.at("smallest_m"));
  course.largest_m = box_size(map.at("largest_m"));
  if ((course.largest_m - course.smallest_m).minCoeff() < 0.0) {
    map.at("largest_m").refuse("must be no smaller than smallest_m", "Swap what is the other way round");
  }
  course.clear.push_back(
      {start.position_m, number_or(map, "keep_out_m", {0.0, 2.0 * kFarthest_m, "m"}, 0.5)});
  if (const auto clear = map.find("clear")) {
    for (const YamlValue& circle : clear->items()) {
      circle.require_map(Keys{"position_m", "radius_m"});
      course.clear.push_back({Eigen::Vector2d(circle.at("position_m").numbers<2>(kPosition_m).data()),
                              circle.at("radius_m").number(kLength_m)});
    }
  }
  course.gap_m = number_or(map, "gap_m", {0.0, 10.0, "m"}, 0.05);
  if (const auto mass = map.find("mass_kg")) course.mass_kg = mass->number({0.001, 1000.0, "kg"});
  return course;
}

Solid draw(const Course& course, facts::RandomStream& random, Solid solid) {
  Eigen::Vector3d size_m;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    size_m[axis] =
        course.smallest_m[axis] + random.uniform() * (course.largest_m[axis] - course.smallest_m[axis]);
  }
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    place.translation()[axis] =
        course.from_m[axis] + random.uniform() * (course.to_m[axis] - course.from_m[axis]);
  }
  place.linear() =
      Eigen::AngleAxisd(2.0 * std::numbers::pi * random.uniform(), Eigen::Vector3d::UnitZ()).matrix();
  set_box(solid, place, Eigen::Vector3d::Zero(), size_m);
  return solid;
}

bool fits(const Solid& solid, const Course& course, const std::vector<Footprint>& taken) {
  const auto [least_m, greatest_m] = solid.bounds_m();
  if ((least_m.head<2>() - course.from_m).minCoeff() < 0.0 ||
      (course.to_m - greatest_m.head<2>()).minCoeff() < 0.0) {
    return false;
  }
  const Footprint own = footprint(solid);
  return std::ranges::all_of(
             course.clear,
             [&own](const Circle& circle) { return own.distance_m(circle.centre_m) >= circle.radius_m; }) &&
         std::ranges::all_of(taken,
                             [&](const Footprint& other) { return are_apart(own, other, course.gap_m); });
}

void scatter(WorldReader& reader, const YamlValue& map, std::uint64_t number) {
  constexpr std::uint64_t kStream = 0x636F'7572'7365'0000ULL;
  const Course course = read_course(map, reader.world.start);
  const auto own_seed =
      static_cast<std::uint64_t>(map.at("seed").integer(0, std::numeric_limits<int>::max()));
  facts::RandomStream random(reader.world.random_seed.value_or(own_seed), kStream + number);
  const Kind kind = course.mass_kg ? Kind::thing : Kind::box;
  const Solid like = reader.solid_of(map, kind, reader.name_of(map, "random"));
  std::vector<Footprint> taken;
  for (const Solid& solid : reader.world.all_solids(true)) taken.push_back(footprint(solid));
  for (int i = 0; i < course.boxes; ++i) {
    Solid solid;
    int draws = 0;
    do {
      if (++draws > kDraws) {
        map.at("boxes").refuse(
            fmt::format("only {} find room in the region, with gaps of {:g} m between them", i, course.gap_m),
            "Ask for fewer or smaller ones, or for a larger region");
      }
      solid = draw(course, random, like);
    } while (!fits(solid, course, taken));
    solid.name += fmt::format(" box {}", i + 1);
    taken.push_back(footprint(solid));
    if (course.mass_kg) {
      reader.add(map, Thing{.solid = std::move(solid), .mass_kg = *course.mass_kg});
    } else {
      reader.add(map, std::move(solid));
    }
  }
}

}  // namespace

void read_random(WorldReader& reader, const YamlValue& list) {
  std::uint64_t number = 0;
  for (const YamlValue& map : list.items()) scatter(reader, map, number++);
}

}  // namespace gaitway::world
