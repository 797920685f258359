// Every way in which a world file can be wrong is refused with file, line, field, value and rule.
#include "written_world.hpp"

namespace gaitway::world {
namespace {

using test::WrittenWorld;

// A file with one good part of each kind, a line each, in which one place is changed.
std::string sound() {
  return "floor: {friction: 0.8, surface: carpet}\n"
         "start: {position_m: [0, 0], yaw_deg: 90}\n"
         "surfaces:\n"
         "  carpet: {noise: [[0.5, 0.4, 0.4], [0.6, 0.5, 0.5]], repeat_m: 0.5, seed: 3}\n"
         "  brick: {checker: [[1, 0, 0], [0, 0, 1]]}\n"
         "boxes: [{name: crate, position_m: [1, 0], size_m: [0.3, 0.2, 0.1], surface: brick}]\n"
         "steps: [{position_m: [2, 0], count: 4, rise_m: 0.01, run_m: 0.3, width_m: 1}]\n"
         "slopes: [{position_m: [5, 0], length_m: 1, rise_m: 0.05, width_m: 1.5}]\n"
         "tiles: [{position_m: [8, 0], size_m: [2, 1], tile_m: 0.1, height_m: 0.005}]\n"
         "walls: [{from_m: [1, -2], to_m: [1, 2], height_m: 1.5, doors: [{at_m: 2, width_m: 0.6, height_m: "
         "0.9}]}]\n"
         "things: [{shape: sphere, diameter_m: 0.15, mass_kg: 0.25, position_m: [-1, 0]}]\n"
         "lights: [{sun: [-0.3, -0.4, -1]}, {lamp: [0, 0, 2.5], colour: [0.5, 0.5, 0.4]}]\n"
         "tags: [{id: 7, size_m: 0.15, position_m: [3, 0, 0.4], yaw_deg: 180}]\n"
         "random: [{seed: 1, boxes: 5, from_m: [-9, -9], to_m: [-3, -3], smallest_m: [0.1, 0.1, 0.05], "
         "largest_m: [0.4, 0.4, 0.2]}]\n";
}

void expect_refused(const std::string& before, const std::string& after,
                    const std::vector<std::string>& parts) {
  std::string text = sound();
  const std::size_t place = text.find(before);
  ASSERT_NE(place, std::string::npos) << before;
  WrittenWorld(text.replace(place, before.size(), after)).expect_refused(after, parts);
}

TEST(BrokenWorld, TheSoundOneIsRead) {
  const World world = WrittenWorld(sound()).read();
  EXPECT_EQ(world.solids.size(), 1U + 4U + 1U + 200U + 3U + 5U);
  EXPECT_EQ(world.things.size(), 1U);
  EXPECT_EQ(world.lights.size(), 2U);
  EXPECT_EQ(world.tags.size(), 1U);
}

TEST(BrokenWorld, UnknownKeysNameTheNearest) {
  expect_refused("boxes: [", "boxs: [", {"key = 'boxs': there is no such key", "Did you mean 'boxes'?"});
  expect_refused("friction: 0.8", "frictoin: 0.8", {"floor key = 'frictoin'", "Did you mean 'friction'?"});
  expect_refused("yaw_deg: 90", "yaw: 90", {"start key = 'yaw'", "yaw_deg"});
  expect_refused("name: crate", "title: crate", {"boxes[0] key = 'title'"});
  expect_refused("count: 4", "number: 4", {"steps[0] key = 'number'"});
  expect_refused("length_m: 1", "length: 1", {"slopes[0] key = 'length'", "Did you mean 'length_m'?"});
  expect_refused("tile_m: 0.1", "tiles_m: 0.1", {"tiles[0] key = 'tiles_m'", "Did you mean 'tile_m'?"});
  expect_refused("height_m: 1.5", "high_m: 1.5", {"walls[0] key = 'high_m'"});
  expect_refused("width_m: 0.6", "wide_m: 0.6", {"walls[0].doors[0] key = 'wide_m'"});
  expect_refused("mass_kg: 0.25", "mas_kg: 0.25", {"things[0] key = 'mas_kg'", "Did you mean 'mass_kg'?"});
  expect_refused("lamp: [", "lump: [", {"lights[1] key = 'lump'", "Did you mean 'lamp'?"});
  expect_refused("id: 7", "number: 7", {"tags[0] key = 'number'"});
  expect_refused("boxes: 5", "box: 5", {"random[0] key = 'box'", "Did you mean 'boxes'?"});
  expect_refused("noise: [[", "noises: [[", {"surfaces.carpet key = 'noises'", "Did you mean 'noise'?"});
}

TEST(BrokenWorld, MissingKeysAreNamed) {
  for (const auto& [section, key] :
       {std::pair{"boxes", "size_m"}, std::pair{"steps", "rise_m"}, std::pair{"slopes", "width_m"},
        std::pair{"tiles", "height_m"}, std::pair{"walls", "from_m"}, std::pair{"things", "mass_kg"},
        std::pair{"tags", "position_m"}, std::pair{"random", "seed"}}) {
    std::string text = sound();
    const std::size_t place = text.find(key, text.find(std::string("\n") + section + ":") + 1);
    ASSERT_NE(place, std::string::npos) << section;
    // The key and its value: to the next comma or bracket on the same level.
    std::size_t end = place;
    for (int depth = 0; depth > 0 || (text[end] != ',' && text[end] != '}'); ++end) {
      depth += text[end] == '[' ? 1 : text[end] == ']' ? -1 : 0;
    }
    text.erase(place, end - place + (text[end] == ',' ? 1 : 0));
    WrittenWorld(text).expect_refused(std::string(section) + ": [",
                                      {std::string(section) + "[0]: the key '" + key + "' is missing"});
  }
}

TEST(BrokenWorld, NumbersOutOfRangeAreRefused) {
  expect_refused("friction: 0.8", "friction: 9", {"floor.friction = '9': must be 0.01..5"});
  expect_refused("yaw_deg: 90", "yaw_deg: north", {"start.yaw_deg = 'north': must be a number"});
  expect_refused("size_m: [0.3, 0.2, 0.1]", "size_m: [0.3, 0.2]", {"boxes[0].size_m", "must be a list of 3"});
  expect_refused("size_m: [0.3, 0.2, 0.1]", "size_m: [0.3, 0.2, 11]", {"boxes[0].size_m[2]", "0.001..10 m"});
  expect_refused("count: 4", "count: 0", {"steps[0].count = '0': must be 1..100"});
  expect_refused("mass_kg: 0.25", "mass_kg: 0", {"things[0].mass_kg = '0': must be 0.001..1000 kg"});
  expect_refused("id: 7", "id: 587", {"tags[0].id = '587': must be 0..586"});
  expect_refused("boxes: 5", "boxes: 501", {"random[0].boxes = '501': must be 1..500"});
  expect_refused("[1, 0, 0]", "[1, 0, 255]", {"surfaces.brick.checker[0][2]", "must be 0..1"});
}

TEST(BrokenWorld, ShapesThatCannotBeAreRefused) {
  expect_refused("rise_m: 0.05", "rise_m: 1.5", {"slopes[0].rise_m", "steeper than 45 degrees"});
  expect_refused("size_m: [2, 1]", "size_m: [2, 0.05]", {"tiles[0].size_m", "no room for one tile"});
  expect_refused("to_m: [1, 2]", "to_m: [1, -2]", {"walls[0].to_m", "is where the wall begins"});
  expect_refused("{at_m: 2,", "{at_m: 3.8,", {"walls[0].doors[0]", "beyond the wall of 4 m"});
  expect_refused("height_m: 0.9", "height_m: 1.9", {"walls[0].doors[0].height_m", "0.01..1.5 m, the wall's"});
  expect_refused("shape: sphere", "shape: cone", {"things[0].shape = 'cone'", "box, cylinder or sphere"});
  expect_refused("diameter_m: 0.15", "diameter_m: 0.15, height_m: 1",
                 {"things[0].height_m", "does not belong to a sphere"});
  expect_refused("sun: [-0.3, -0.4, -1]", "sun: [0, 0, 0]", {"lights[0].sun", "must not be zero"});
  expect_refused("{sun: [-0.3, -0.4, -1]}", "{colour: [1, 1, 1]}", {"lights[0]", "exactly one of sun, lamp"});
  expect_refused("{checker: [[1, 0, 0], [0, 0, 1]]}", "{repeat_m: 1}",
                 {"surfaces.brick", "exactly one of plain, checker, noise, image"});
  expect_refused("{checker: [[1, 0, 0], [0, 0, 1]]}", "{image: no.png}",
                 {"surfaces.brick.image = 'no.png'", "a PNG file that is there"});
  expect_refused("{checker: [[1, 0, 0], [0, 0, 1]]}", "{plain: [1, 0, 0], seed: 3}",
                 {"surfaces.brick.seed", "belongs to noise"});
  expect_refused("smallest_m: [0.1", "smallest_m: [0.5",
                 {"random[0].largest_m", "no smaller than smallest_m"});
  expect_refused("to_m: [-3, -3]", "to_m: [-3, -9]", {"random[0].to_m", "beyond from_m along both axes"});
}

TEST(BrokenWorld, UnknownSurfacesAndTakenNamesAreRefused) {
  expect_refused("surface: brick", "surface: brik",
                 {"boxes[0].surface = 'brik': the world has no such surface", "Did you mean 'brick'?"});
  expect_refused("shape: sphere", "name: crate, shape: sphere",
                 {"things[0]", "the name 'crate' is that of line 6, too"});
  expect_refused("name: crate", "name: \"a/b\"", {"boxes[0].name", "letters, digits, blanks"});
}

TEST(BrokenWorld, AWorldThatIsTooLargeIsRefused) {
  expect_refused("position_m: [1, 0], size", "position_m: [49.9, 0], size",
                 {"boxes[0]", "the world is too large: 'crate' reaches further than 50 m from its origin"});
  expect_refused("size_m: [2, 1], tile_m: 0.1", "size_m: [8, 8], tile_m: 0.1",
                 {"tiles[0]", "the world is too large: it has more than 2000 solids"});
  expect_refused("boxes: 5,", "mass_kg: 1, boxes: 64,",
                 {"random[0]", "the world is too large: at most 64 things can be pushed"});
}

TEST(BrokenWorld, ARegionWithoutRoomIsRefusedWithWhatFits) {
  expect_refused("boxes: 5, from_m: [-9, -9]", "boxes: 500, from_m: [-5, -5]",
                 {"random[0].boxes = '500': only ", " find room in the region", "Ask for fewer"});
}

TEST(BrokenWorld, WhatIsNoWorldIsRefused) {
  WrittenWorld("boxes: 3\n").expect_refused("boxes", {"boxes = '3': must be a list"});
  EXPECT_THROW((void)WrittenWorld("").read(), input::InputError);
  EXPECT_THROW((void)read_world("/no/such/world.yaml"), input::InputError);
}

}  // namespace
}  // namespace gaitway::world
