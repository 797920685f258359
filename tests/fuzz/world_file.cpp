// Worlds as users write them (world/world_file.hpp). Whatever the text: it is refused with input::InputError
// and nothing else, or gives no more than a world may have, each part with a place, a size and a name of its
// own, random boxes off the start, and heights that are numbers.
#include "gaitway/world/world_file.hpp"

#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <string>

#include "fuzz_input.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/world/height_grid.hpp"
#include "gaitway/world/picture.hpp"
#include "memory_file.hpp"

namespace gaitway::fuzz {
namespace {

void check_solid(const world::World& world, const world::Solid& solid) {
  const auto [least_m, greatest_m] = solid.bounds_m();
  require(least_m.allFinite() && greatest_m.allFinite() && least_m.minCoeff() >= -world::kFarthest_m &&
              greatest_m.maxCoeff() <= world::kFarthest_m,
          "every solid lies in the world");
  require(solid.size_m.minCoeff() > 0.0, "every solid has a size");
  require(std::abs(solid.pose.linear().determinant() - 1.0) < 1e-6, "a pose turns and does not stretch");
  require(solid.surface < world.surfaces.size(), "every solid has a surface");
  require(!solid.friction || (*solid.friction > 0.0 && std::isfinite(*solid.friction)),
          "friction is a number");
  const Eigen::Vector3d centre = solid.pose.translation();
  const auto met = solid.on_vertical(centre.x(), centre.y());
  require(met && met->bottom_m <= centre.z() && met->top_m >= centre.z(),
          "a line through its centre meets it");
}

void check_looks(const world::World& world) {
  for (const world::Surface& surface : world.surfaces) {
    require(surface.repeat_m > 0.0, "surfaces repeat");
    if (surface.kind == world::Surface::Kind::image) continue;
    const world::Picture picture = world::picture_of(surface);
    require(picture.rgb.size() == 3U * static_cast<std::size_t>(picture.width_px * picture.height_px),
            "a picture has all its pixels");
  }
  for (const world::Tag& tag : world.tags) {
    require(tag.id >= 0 && tag.id < world::kTags && tag.size_m > 0.0, "tags are of the dictionary");
  }
  for (const world::Light& light : world.lights) {
    require(std::abs(light.direction.norm() - 1.0) < 1e-6, "light goes somewhere");
  }
}

}  // namespace

void world_file(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(Input(bytes).rest_as_text());
  world::World world;
  try {
    world = world::read_world(file.path());
  } catch (const input::InputError&) {
    return;
  }
  require(world.solids.size() <= world::kMostSolids && world.things.size() <= world::kMostThings &&
              world.tags.size() <= world::kMostTags && world.lights.size() <= world::kMostLights,
          "no more than a world may have");
  std::set<std::string> names;
  const std::vector<world::Solid> solids = world.all_solids(true);
  for (const world::Solid& solid : solids) {
    check_solid(world, solid);
    require(names.insert(solid.name).second, "every part has a name of its own");
  }
  for (const world::Thing& thing : world.things) require(thing.mass_kg > 0.0, "things have a mass");
  check_looks(world);
  const world::HeightGrid heights = world::height_grid(
      solids, {.origin_m = world.start.position_m, .cell_m = 0.05, .columns = 20, .rows = 20}, 0.8);
  for (const float height_m : heights.surface_m) require(height_m >= 0.0F, "nothing is below the floor");
}

}  // namespace gaitway::fuzz
