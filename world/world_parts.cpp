// Reads what stands in a world: boxes, steps, slopes, tiles, walls, and things that can be pushed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gaitway/facts/random_stream.hpp"
#include "gaitway/input/complaint.hpp"
#include "world_reader.hpp"

namespace gaitway::world {
namespace {

using input::YamlValue;
using Keys = std::vector<std::string_view>;

constexpr int kMostSteps = 100;
constexpr input::Range kBottom_m{-1.0, 10.0, "m"};

// A box of ground, from below the floor up to `top_m`.
void add_ground(WorldReader& reader, const YamlValue& map, Solid solid, const Eigen::Isometry3d& place,
                double from_m, double to_m, double width_m, double top_m) {
  set_box(solid, place, {(from_m + to_m) / 2.0, 0.0, -kBuried_m},
          {to_m - from_m, width_m, top_m + kBuried_m});
  reader.add(map, std::move(solid));
}

void read_staircase(WorldReader& reader, const YamlValue& map) {
  map.require_map(Keys{"name", "position_m", "yaw_deg", "count", "rise_m", "run_m", "width_m", "top_m",
                       "down", "friction", "surface"});
  const Solid step = reader.solid_of(map, Kind::step, reader.name_of(map, "steps"));
  const Eigen::Isometry3d place = place_of(map);
  const int count = map.at("count").integer(1, kMostSteps);
  const double rise_m = map.at("rise_m").number({0.001, 0.5, "m"});
  const double run_m = map.at("run_m").number({0.01, 10.0, "m"});
  const double width_m = map.at("width_m").number(kLength_m);
  const double top_m = number_or(map, "top_m", kLength_m, run_m);
  const int treads = flag_of(map, "down") ? 2 * count - 1 : count;
  double from_m = 0.0;
  for (int i = 0; i < treads; ++i) {
    const double to_m = from_m + (i == count - 1 ? top_m : run_m);
    Solid tread = step;
    tread.name += fmt::format(" tread {}", i + 1);
    if (i % 2 == 1 && !map.find("surface")) tread.surface = kSecondStepSurface;
    const int above = std::min(i, 2 * (count - 1) - i) + 1;
    add_ground(reader, map, std::move(tread), place, from_m, to_m, width_m, above * rise_m);
    from_m = to_m;
  }
}

// A slab whose upper face rises from the floor, and that is so thick that nothing is hollow below it.
Solid slab(Solid solid, const Eigen::Isometry3d& place, double length_m, double rise_m, double width_m) {
  const double along_m = std::hypot(length_m, rise_m);
  const double thickness_m = (rise_m + kBuried_m) * along_m / length_m;
  const Eigen::AngleAxisd up(-std::atan2(rise_m, length_m), Eigen::Vector3d::UnitY());
  solid.size_m = {along_m, width_m, thickness_m};
  solid.pose = place * Eigen::Translation3d(length_m / 2.0, 0.0, rise_m / 2.0) * up *
               Eigen::Translation3d(0.0, 0.0, -thickness_m / 2.0);
  return solid;
}

void read_slope(WorldReader& reader, const YamlValue& map) {
  map.require_map(Keys{"name", "position_m", "yaw_deg", "length_m", "rise_m", "width_m", "top_m", "down",
                       "friction", "surface"});
  Solid solid = reader.solid_of(map, Kind::slope, reader.name_of(map, "slope"));
  const std::string name = solid.name;
  const Eigen::Isometry3d place = place_of(map);
  const double length_m = map.at("length_m").number({0.02, 2.0 * kFarthest_m, "m"});
  const YamlValue rise = map.at("rise_m");
  const double rise_m = rise.number(kHeight_m);
  if (rise_m > length_m) rise.refuse("is steeper than 45 degrees", "Make it lower, or length_m longer");
  const double width_m = map.at("width_m").number(kLength_m);
  const double top_m = number_or(map, "top_m", kLength_m, 0.0);
  reader.add(map, slab(solid, place, length_m, rise_m, width_m));
  if (top_m > 0.0) {
    solid.name = name + " top";
    add_ground(reader, map, solid, place, length_m, length_m + top_m, width_m, rise_m);
  }
  if (flag_of(map, "down")) {
    solid.name = name + " down";
    const Eigen::AngleAxisd back(std::numbers::pi, Eigen::Vector3d::UnitZ());
    reader.add(map, slab(solid, place * Eigen::Translation3d(2.0 * length_m + top_m, 0.0, 0.0) * back,
                         length_m, rise_m, width_m));
  }
}

void read_tile_field(WorldReader& reader, const YamlValue& map) {
  map.require_map(
      Keys{"name", "position_m", "yaw_deg", "size_m", "tile_m", "height_m", "seed", "friction", "surface"});
  const Solid tile = reader.solid_of(map, Kind::tile, reader.name_of(map, "tiles"));
  const Eigen::Isometry3d place = place_of(map);
  const YamlValue size = map.at("size_m");
  const std::array<double, 2> sides_m = size.numbers<2>(kLength_m);
  const double tile_m = map.at("tile_m").number({0.02, 10.0, "m"});
  const double height_m = map.at("height_m").number({0.001, 0.5, "m"});
  const auto seed = map.find("seed");
  facts::RandomStream random(
      static_cast<std::uint64_t>(seed ? seed->integer(0, std::numeric_limits<int>::max()) : 1),
      0x7469'6C65'73ULL);
  constexpr double kRounding = 1e-9;
  const int columns = static_cast<int>(sides_m[0] / tile_m + kRounding);
  const int rows = static_cast<int>(sides_m[1] / tile_m + kRounding);
  if (columns < 1 || rows < 1) size.refuse("has no room for one tile", "Make it larger, or tile_m smaller");
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      Solid one = tile;
      one.name += fmt::format(" {},{}", column + 1, row + 1);
      const double x_m = (column - (columns - 1) / 2.0) * tile_m, y_m = (row - (rows - 1) / 2.0) * tile_m;
      set_box(one, place, {x_m, y_m, -kBuried_m}, {tile_m, tile_m, kBuried_m + height_m * random.uniform()});
      reader.add(map, std::move(one));
    }
  }
}

struct Door {
  double from_m = 0.0, to_m = 0.0,
         height_m = 0.0;  // along the wall; a door as high as the wall has no lintel
};

std::vector<Door> read_doors(const YamlValue& wall, double length_m, double height_m) {
  std::vector<Door> doors;
  const auto list = wall.find("doors");
  if (!list) return doors;
  for (const YamlValue& map : list->items()) {
    map.require_map(Keys{"at_m", "width_m", "height_m"});
    const double at_m = map.at("at_m").number({0.0, 2.0 * kFarthest_m, "m"});
    const double half_m = map.at("width_m").number(kLength_m) / 2.0;
    const Door door{at_m - half_m, at_m + half_m,
                    number_or(map, "height_m", {0.01, height_m, "m, the wall's height"}, height_m)};
    if (door.from_m < (doors.empty() ? 0.0 : doors.back().to_m) || door.to_m > length_m) {
      map.refuse(fmt::format("reaches beyond the wall of {:g} m, or into the door before it", length_m),
                 "Give doors in the order of at_m, the distance of their middle from from_m");
    }
    doors.push_back(door);
  }
  return doors;
}

void read_wall(WorldReader& reader, const YamlValue& map) {
  map.require_map(Keys{"name", "from_m", "to_m", "height_m", "thickness_m", "doors", "friction", "surface"});
  const Solid wall = reader.solid_of(map, Kind::wall, reader.name_of(map, "wall"));
  const Eigen::Vector2d from(map.at("from_m").numbers<2>(kPosition_m).data());
  const Eigen::Vector2d way = Eigen::Vector2d(map.at("to_m").numbers<2>(kPosition_m).data()) - from;
  const double length_m = way.norm();
  if (length_m < kLength_m.lowest) map.at("to_m").refuse("is where the wall begins", "Make the wall longer");
  const double height_m = map.at("height_m").number(kHeight_m);
  const double thickness_m = number_or(map, "thickness_m", {0.005, 5.0, "m"}, 0.05);
  const std::vector<Door> doors = read_doors(map, length_m, height_m);
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation().head<2>() = from;
  place.linear() = Eigen::AngleAxisd(std::atan2(way.y(), way.x()), Eigen::Vector3d::UnitZ()).matrix();
  const auto add = [&](const std::string& name, double begin_m, double end_m, double bottom_m) {
    if (end_m - begin_m < 1e-6 || height_m - bottom_m < 1e-6) return;
    Solid piece = wall;
    piece.name = name;
    set_box(piece, place, {(begin_m + end_m) / 2.0, 0.0, bottom_m},
            {end_m - begin_m, thickness_m, height_m - bottom_m});
    reader.add(map, std::move(piece));
  };
  double begin_m = 0.0;
  for (std::size_t i = 0; i < doors.size(); ++i) {
    add(fmt::format("{} part {}", wall.name, i + 1), begin_m, doors[i].from_m, 0.0);
    add(fmt::format("{} lintel {}", wall.name, i + 1), doors[i].from_m, doors[i].to_m, doors[i].height_m);
    begin_m = doors[i].to_m;
  }
  add(doors.empty() ? wall.name : fmt::format("{} part {}", wall.name, doors.size() + 1), begin_m, length_m,
      0.0);
}

// The size of a thing by its shape, which takes other keys than the others.
void read_shape(const YamlValue& map, Solid& solid) {
  static const std::vector<std::string> kShapes{"box", "cylinder", "sphere"};  // as Solid::Shape
  const auto shape = map.find("shape");
  const auto found = shape ? std::ranges::find(kShapes, shape->text()) : kShapes.begin();
  if (found == kShapes.end()) {
    shape->refuse("must be box, cylinder or sphere", input::suggest(shape->text(), kShapes));
  }
  solid.shape = static_cast<Solid::Shape>(found - kShapes.begin());
  const bool is_box = solid.shape == Solid::Shape::box, is_cylinder = solid.shape == Solid::Shape::cylinder;
  for (const auto& [key, fits] :
       {std::pair{"size_m", is_box}, std::pair{"diameter_m", !is_box}, std::pair{"height_m", is_cylinder}}) {
    if (const auto value = map.find(key); value && !fits) {
      value->refuse(fmt::format("does not belong to a {}", *found),
                    "A box has size_m, a cylinder diameter_m and height_m, a sphere diameter_m");
    }
  }
  if (is_box) {
    solid.size_m = box_size(map.at("size_m"));
    return;
  }
  solid.size_m.setConstant(map.at("diameter_m").number({0.01, 5.0, "m"}));
  if (is_cylinder) solid.size_m.z() = map.at("height_m").number({0.005, 5.0, "m"});
}

void read_thing(WorldReader& reader, const YamlValue& map) {
  map.require_map(Keys{"name", "shape", "size_m", "diameter_m", "height_m", "mass_kg", "position_m",
                       "yaw_deg", "bottom_m", "friction", "surface"});
  Thing thing;
  thing.solid = reader.solid_of(map, Kind::thing, reader.name_of(map, "thing"));
  read_shape(map, thing.solid);
  thing.mass_kg = map.at("mass_kg").number({0.001, 1000.0, "kg"});
  const double bottom_m = number_or(map, "bottom_m", {0.0, 10.0, "m"}, 0.0);
  thing.solid.pose = place_of(map) * Eigen::Translation3d(0.0, 0.0, bottom_m + thing.solid.size_m.z() / 2.0);
  reader.add(map, std::move(thing));
}

void read_box(WorldReader& reader, const YamlValue& map) {
  map.require_map(Keys{"name", "position_m", "yaw_deg", "size_m", "bottom_m", "friction", "surface"});
  Solid box = reader.solid_of(map, Kind::box, reader.name_of(map, "box"));
  set_box(box, place_of(map), {0.0, 0.0, number_or(map, "bottom_m", kBottom_m, 0.0)},
          box_size(map.at("size_m")));
  reader.add(map, std::move(box));
}

void read_each(WorldReader& reader, const YamlValue& list, void (*read)(WorldReader&, const YamlValue&)) {
  for (const YamlValue& map : list.items()) read(reader, map);
}

}  // namespace

void read_boxes(WorldReader& reader, const YamlValue& list) {
  read_each(reader, list, read_box);
}
void read_steps(WorldReader& reader, const YamlValue& list) {
  read_each(reader, list, read_staircase);
}
void read_slopes(WorldReader& reader, const YamlValue& list) {
  read_each(reader, list, read_slope);
}
void read_tiles(WorldReader& reader, const YamlValue& list) {
  read_each(reader, list, read_tile_field);
}
void read_walls(WorldReader& reader, const YamlValue& list) {
  read_each(reader, list, read_wall);
}
void read_things(WorldReader& reader, const YamlValue& list) {
  read_each(reader, list, read_thing);
}

}  // namespace gaitway::world
