// Random courses keep what they promise, whatever the seed.
#include <cmath>

#include "gaitway/world/height_grid.hpp"
#include "written_world.hpp"

namespace gaitway::world {
namespace {

using test::WrittenWorld;

constexpr const char* kCourse =
    "start: {position_m: [0.5, -0.5]}\n"
    "walls: [{from_m: [-2, 0.5], to_m: [2, 1.5], height_m: 0.5}]\n"
    "random: [{seed: 4, boxes: 30, from_m: [-2, -3], to_m: [3, 3], smallest_m: [0.1, 0.05, 0.02], "
    "largest_m: [0.5, 0.3, 0.2], keep_out_m: 0.7, gap_m: 0.06, clear: [{position_m: [2, 2], radius_m: "
    "0.4}]}]\n";

std::vector<Solid> boxes_of(const World& world) {
  std::vector<Solid> boxes;
  for (const Solid& solid : world.solids) {
    if (solid.kind == Kind::box) boxes.push_back(solid);
  }
  return boxes;
}

// Points of the outline, every few centimetres.
std::vector<Eigen::Vector2d> outline(const Solid& solid) {
  std::vector<Eigen::Vector2d> points;
  constexpr int kPieces = 16;
  const Eigen::Vector3d half = solid.size_m / 2.0;
  for (int i = 0; i <= kPieces; ++i) {
    const double share = 2.0 * i / kPieces - 1.0;
    for (const Eigen::Vector3d& local :
         {Eigen::Vector3d(share * half.x(), half.y(), 0.0), Eigen::Vector3d(share * half.x(), -half.y(), 0.0),
          Eigen::Vector3d(half.x(), share * half.y(), 0.0),
          Eigen::Vector3d(-half.x(), share * half.y(), 0.0)}) {
      points.push_back((solid.pose * local).head<2>());
    }
  }
  return points;
}

double distance_m(const Solid& a, const Solid& b) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& p : outline(a)) {
    for (const Eigen::Vector2d& q : outline(b)) least_m = std::min(least_m, (p - q).norm());
  }
  return least_m;
}

TEST(RandomCourse, KeepsItsRegionItsGapsAndOffTheStart) {
  const WrittenWorld file(kCourse);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const World world = read_world(file.file(), seed);
    const std::vector<Solid> boxes = boxes_of(world);
    ASSERT_EQ(boxes.size(), 30U);
    for (std::size_t i = 0; i < world.solids.size(); ++i) {
      const Solid& solid = world.solids[i];
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GE(distance_m(solid, world.solids[j]), 0.06 - 1e-9) << solid.name << ", seed " << seed;
      }
      if (solid.kind != Kind::box) continue;
      EXPECT_LE(solid.size_m.x(), 0.5);
      EXPECT_GE(solid.size_m.z(), 0.02);
      for (const Eigen::Vector2d& point : outline(solid)) {
        EXPECT_GE(point.x(), -2.0 - 1e-9);
        EXPECT_LE(point.x(), 3.0 + 1e-9);
        EXPECT_GE(point.y(), -3.0 - 1e-9);
        EXPECT_LE(point.y(), 3.0 + 1e-9);
        EXPECT_GE((point - Eigen::Vector2d(0.5, -0.5)).norm(), 0.7 - 1e-9);
        EXPECT_GE((point - Eigen::Vector2d(2.0, 2.0)).norm(), 0.4 - 1e-9);
      }
    }
  }
}

TEST(RandomCourse, IsOfItsSeedAlone) {
  const WrittenWorld file(kCourse);
  const auto places = [](const World& world) {
    std::vector<double> numbers;
    for (const Solid& solid : boxes_of(world)) {
      const Eigen::Matrix4d pose = solid.pose.matrix();
      numbers.insert(numbers.end(), pose.data(), pose.data() + pose.size());
    }
    return numbers;
  };
  EXPECT_EQ(places(file.read()), places(file.read()));
  EXPECT_EQ(places(file.read()), places(read_world(file.file(), 4))) << "the file's own seed";
  EXPECT_NE(places(file.read()), places(read_world(file.file(), 5)));
}

TEST(RandomCourse, TwoOfOneSeedDiffer) {
  const World world =
      WrittenWorld(
          "random:\n"
          "  - {seed: 1, boxes: 3, from_m: [1, 1], to_m: [3, 3], smallest_m: [0.1, 0.1, 0.1], "
          "largest_m: [0.2, 0.2, 0.2]}\n"
          "  - {seed: 1, boxes: 3, from_m: [11, 1], to_m: [13, 3], smallest_m: [0.1, 0.1, 0.1], "
          "largest_m: [0.2, 0.2, 0.2]}\n")
          .read();
  ASSERT_EQ(world.solids.size(), 6U);
  EXPECT_GT((world.solids[3].size_m - world.solids[0].size_m).norm(), 1e-6);
}

TEST(RandomCourse, OfThingsThatCanBePushed) {
  const World world =
      WrittenWorld(
          "random: [{seed: 2, boxes: 6, from_m: [1, 1], to_m: [4, 4], smallest_m: [0.1, 0.1, 0.1], "
          "largest_m: [0.2, 0.2, 0.2], mass_kg: 0.4}]\n")
          .read();
  EXPECT_TRUE(world.solids.empty());
  ASSERT_EQ(world.things.size(), 6U);
  for (const Thing& thing : world.things) EXPECT_EQ(thing.mass_kg, 0.4);
}

}  // namespace
}  // namespace gaitway::world
