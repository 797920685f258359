// Reads a world file's top, and what is no solid: floor, start, surfaces, lights, tags.
#include "gaitway/world/world_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "gaitway/facts/facts.hpp"
#include "gaitway/world/picture.hpp"
#include "world_reader.hpp"

namespace gaitway::world {
namespace {

using input::YamlValue;
using Keys = std::vector<std::string_view>;

using facts::kRadPerDegree;
constexpr input::Range kShare{0.0, 1.0, ""};

Surface plain(double red, double green, double blue) {
  return {.kind = Surface::Kind::plain, .colours = {Colour{red, green, blue}}, .image = {}};
}

// By Kind; behind them the second one of steps.
std::array<Surface, kUsualSurfaces> usual_surfaces() {
  const Surface floor{.kind = Surface::Kind::checker,
                      .colours = {Colour{0.86, 0.86, 0.86}, Colour{0.76, 0.76, 0.76}},
                      .repeat_m = 0.2,
                      .image = {}};
  return {floor,
          plain(0.80, 0.55, 0.35),
          plain(0.62, 0.68, 0.74),
          plain(0.66, 0.72, 0.62),
          plain(0.70, 0.70, 0.76),
          plain(0.90, 0.88, 0.82),
          plain(0.30, 0.50, 0.78),
          plain(0.50, 0.57, 0.64)};
}

Colour colour_of(const YamlValue& value) {
  return value.numbers<3>(kShare);
}

std::array<Colour, 2> two_colours(const YamlValue& value) {
  const std::vector<YamlValue> both = value.items(2);
  return {colour_of(both[0]), colour_of(both[1])};
}

std::filesystem::path image_file(const YamlValue& value) {
  std::filesystem::path file = value.file().parent_path() / value.text();
  std::error_code unknown;
  if (file.extension() != ".png" || !std::filesystem::is_regular_file(file, unknown)) {
    value.refuse("must be a PNG file that is there", "Its path counts from the world file's folder");
  }
  return file;
}

Surface read_surface(const YamlValue& map) {
  using SurfaceKind = Surface::Kind;
  map.require_map(Keys{"plain", "checker", "noise", "image", "repeat_m", "seed"});
  Surface surface;
  int kinds = 0;
  if (const auto value = map.find("plain"); value && ++kinds > 0) surface.colours[0] = colour_of(*value);
  for (const auto& [key, kind] :
       {std::pair{"checker", SurfaceKind::checker}, std::pair{"noise", SurfaceKind::noise}}) {
    if (const auto value = map.find(key)) {
      ++kinds;
      surface.kind = kind;
      surface.colours = two_colours(*value);
    }
  }
  if (const auto value = map.find("image")) {
    ++kinds;
    surface.kind = SurfaceKind::image;
    surface.image = image_file(*value);
  }
  if (kinds != 1) {
    map.refuse("a surface has exactly one of plain, checker, noise, image", "Write one of them");
  }
  const auto repeat = map.find("repeat_m");
  if (repeat && surface.kind == SurfaceKind::plain) {
    repeat->refuse("does not belong to a plain surface", "Leave it out");
  }
  surface.repeat_m = repeat ? repeat->number({0.01, 100.0, "m"}) : surface.repeat_m;
  if (const auto seed = map.find("seed")) {
    if (surface.kind != SurfaceKind::noise) seed->refuse("belongs to noise", "Leave it out");
    surface.seed = static_cast<std::uint64_t>(seed->integer(0, std::numeric_limits<int>::max()));
  }
  return surface;
}

Eigen::Vector3d point_of(const YamlValue& value) {
  return Eigen::Vector3d(value.numbers<3>(kPosition_m).data());
}

Light read_light(const YamlValue& map) {
  map.require_map(Keys{"sun", "lamp", "colour"});
  const auto sun = map.find("sun"), lamp = map.find("lamp");
  if (sun.has_value() == lamp.has_value()) {
    map.refuse("a light has exactly one of sun, lamp",
               "sun: the direction that its light goes, e.g. [-0.3, -0.4, -1]; lamp: where it is");
  }
  Light light;
  if (lamp) {
    light.kind = Light::Kind::lamp;
    light.position_m = point_of(*lamp);
  } else {
    light.direction = Eigen::Vector3d(sun->numbers<3>({-1e3, 1e3, ""}).data());
    if (!(light.direction.norm() > 1e-6)) sun->refuse("must not be zero", "Write e.g. [-0.3, -0.4, -1]");
    light.direction.normalize();
  }
  if (const auto colour = map.find("colour")) light.colour = colour_of(*colour);
  return light;
}

Tag read_tag(const YamlValue& map) {
  map.require_map(Keys{"id", "size_m", "position_m", "yaw_deg", "pitch_deg"});
  Tag tag;
  tag.id = map.at("id").integer(0, kTags - 1);
  tag.size_m = map.at("size_m").number({0.01, 5.0, "m"});
  const double yaw = number_or(map, "yaw_deg", kAngle_deg, 0.0) * kRadPerDegree;
  const double pitch = number_or(map, "pitch_deg", {-90.0, 90.0, "deg"}, 0.0) * kRadPerDegree;
  const Eigen::Vector3d ahead(std::cos(yaw), std::sin(yaw), 0.0);
  const Eigen::Vector3d out = std::cos(pitch) * ahead + std::sin(pitch) * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d up = std::cos(pitch) * Eigen::Vector3d::UnitZ() - std::sin(pitch) * ahead;
  tag.pose.linear() << up.cross(out), up, out;
  tag.pose.translation() = point_of(map.at("position_m"));
  return tag;
}

template <class Value, class Read>
void read_all(const YamlValue& list, std::size_t most, std::vector<Value>& into, Read read) {
  const std::vector<YamlValue> items = list.items();
  if (items.size() > most) {
    list.refuse(fmt::format("a world has at most {}", most), "Leave some out");
  }
  for (const YamlValue& item : items) into.push_back(read(item));
}

void read_floor(WorldReader& reader, const YamlValue& map) {
  map.require_map(Keys{"friction", "surface"});
  if (const auto friction = map.find("friction")) reader.world.floor_friction = friction->number(kFriction);
  reader.world.floor_surface = reader.surface_of(map, Kind::floor);
}

Start read_start(const YamlValue& map) {
  map.require_map(Keys{"position_m", "yaw_deg"});
  Start start{.line = map.line()};
  if (const auto position = map.find("position_m")) {
    start.position_m = Eigen::Vector2d(position->numbers<2>(kPosition_m).data());
  }
  start.yaw_rad = number_or(map, "yaw_deg", kAngle_deg, 0.0) * kRadPerDegree;
  return start;
}

}  // namespace

WorldReader::WorldReader(const std::filesystem::path& file) {
  world.file = file;
  world.name = file.stem().string();
  const auto surfaces = usual_surfaces();
  world.surfaces.assign(surfaces.begin(), surfaces.end());
}

void WorldReader::add_surface(const YamlValue& value, const std::string& surface_name, Surface surface) {
  if (surface_names_.size() >= kMostSurfaces) {
    value.refuse(fmt::format("a world has at most {} surfaces", kMostSurfaces), "Leave some out");
  }
  surface_names_.push_back(surface_name);
  world.surfaces.push_back(std::move(surface));
}

std::size_t WorldReader::surface_of(const YamlValue& part, Kind kind) const {
  const auto named = part.find("surface");
  if (!named) return static_cast<std::size_t>(kind);
  const auto found = std::ranges::find(surface_names_, named->text());
  if (found == surface_names_.end()) {
    named->refuse("the world has no such surface", input::suggest(named->text(), surface_names_));
  }
  return kUsualSurfaces + static_cast<std::size_t>(found - surface_names_.begin());
}

std::string WorldReader::name_of(const YamlValue& part, const char* what) {
  const auto given = part.find("name");
  if (!given) return fmt::format("{} {}", what, ++counts_[what]);
  constexpr std::size_t kLongest = 40;
  const std::string text = given->text();
  const auto fits = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == ' ' || c == '_' || c == '-' || c == '.';
  };
  if (text.empty() || text.size() > kLongest || !std::ranges::all_of(text, fits)) {
    given->refuse(fmt::format("a name is 1 to {} letters, digits, blanks, '_', '-', '.'", kLongest),
                  "Choose another one");
  }
  return text;
}

Solid WorldReader::solid_of(const YamlValue& part, Kind kind, const std::string& part_name) const {
  Solid solid;
  solid.kind = kind;
  solid.name = part_name;
  solid.line = part.line();
  solid.surface = surface_of(part, kind);
  if (const auto friction = part.find("friction")) solid.friction = friction->number(kFriction);
  return solid;
}

void WorldReader::check(const YamlValue& part, const Solid& solid) {
  const auto [least_m, greatest_m] = solid.bounds_m();
  if (least_m.minCoeff() < -kFarthest_m || greatest_m.maxCoeff() > kFarthest_m) {
    part.refuse(fmt::format("the world is too large: '{}' reaches further than {} m from its origin",
                            solid.name, kFarthest_m),
                "Move it, or make it smaller");
  }
  const auto [taken, is_new] = lines_.emplace(solid.name, solid.line);
  if (!is_new) {
    part.refuse(fmt::format("the name '{}' is that of line {}, too", solid.name, taken->second),
                "Give every part a name of its own, or none");
  }
}

void WorldReader::add(const YamlValue& part, Solid solid) {
  if (world.solids.size() >= kMostSolids) {
    part.refuse(fmt::format("the world is too large: it has more than {} solids; each step, tile and piece "
                            "of a wall is one",
                            kMostSolids),
                "Make fewer of them, or larger ones");
  }
  check(part, solid);
  world.solids.push_back(std::move(solid));
}

void WorldReader::add(const YamlValue& part, Thing thing) {
  if (world.things.size() >= kMostThings) {
    part.refuse(fmt::format("the world is too large: at most {} things can be pushed", kMostThings),
                "Leave some out, or let them stand fast as boxes");
  }
  check(part, thing.solid);
  world.things.push_back(std::move(thing));
}

double number_or(const YamlValue& map, std::string_view key, const input::Range& range, double otherwise) {
  const auto value = map.find(key);
  return value ? value->number(range) : otherwise;
}

bool flag_of(const YamlValue& map, std::string_view key) {
  const auto value = map.find(key);
  if (value && value->text() != "true") value->refuse("must be true", "Leave it out if it is not");
  return value.has_value();
}

Eigen::Isometry3d place_of(const YamlValue& map) {
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
  place.translation().head<2>() = Eigen::Vector2d(map.at("position_m").numbers<2>(kPosition_m).data());
  const double yaw = number_or(map, "yaw_deg", kAngle_deg, 0.0) * kRadPerDegree;
  place.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return place;
}

Eigen::Vector3d box_size(const YamlValue& value) {
  const std::vector<YamlValue> sides = value.items(3);
  return {sides[0].number(kLength_m), sides[1].number(kLength_m), sides[2].number(kHeight_m)};
}

void set_box(Solid& solid, const Eigen::Isometry3d& place, const Eigen::Vector3d& bottom_m,
             const Eigen::Vector3d& size_m) {
  solid.shape = Solid::Shape::box;
  solid.size_m = size_m;
  solid.pose = place * Eigen::Translation3d(bottom_m + Eigen::Vector3d(0.0, 0.0, size_m.z() / 2.0));
}

World read_world(const std::filesystem::path& file, std::optional<std::uint64_t> random_seed) {
  const YamlValue top = YamlValue::read(file);
  top.require_map(Keys{"floor", "start", "surfaces", "boxes", "steps", "slopes", "tiles", "walls", "things",
                       "lights", "tags", "random"});
  WorldReader reader(file);
  World& world = reader.world;
  world.random_seed = random_seed;
  if (const auto surfaces = top.find("surfaces")) {
    for (const auto& [name, value] : surfaces->entries()) {
      reader.add_surface(value, name, read_surface(value));
    }
  }
  if (const auto floor = top.find("floor")) read_floor(reader, *floor);
  if (const auto start = top.find("start")) world.start = read_start(*start);
  constexpr std::array<std::pair<const char*, void (*)(WorldReader&, const YamlValue&)>, 7> kParts{
      {{"boxes", read_boxes},
       {"steps", read_steps},
       {"slopes", read_slopes},
       {"tiles", read_tiles},
       {"walls", read_walls},
       {"things", read_things},
       {"random", read_random}}};
  for (const auto& [key, read] : kParts) {
    if (const auto list = top.find(key)) read(reader, *list);
  }
  if (const auto lights = top.find("lights")) read_all(*lights, kMostLights, world.lights, read_light);
  if (const auto tags = top.find("tags")) read_all(*tags, kMostTags, world.tags, read_tag);
  return std::move(reader.world);
}

}  // namespace gaitway::world
