// The physics engine's rays meet in a world's model what the world itself says is there.
#include <mujoco/mujoco.h>

#include "gaitway/facts/random_stream.hpp"
#include "gaitway/world/height_grid.hpp"
#include "physics_model.hpp"
#include "world_fixture.hpp"

namespace gaitway::simulator {
namespace {

constexpr double kTolerance_m = 1e-6;
constexpr double kEdge_m = 1e-4;  // so near to an edge of a solid either answer is right

class WorldModelTest : public WorldTest {
 protected:
  // The robot begins far away.
  void build(world::World world) {
    world_ = std::move(world);
    world_.start.position_m = {45.0, 45.0};
    ModelMismatch exact;
    exact.mass_factor.assign(model_.links.size(), 1.0);
    model_pointer_ = build_physics_model(model_, exact, {}, world_);
    data_.reset(mj_makeData(model_pointer_.get()));
    data_->qpos[0] = data_->qpos[1] = 45.0;
    mj_forward(model_pointer_.get(), data_.get());
  }
  // Of the nearest geometry, upwards or downwards; none: nothing is met.
  [[nodiscard]] std::optional<double> ray(double x_m, double y_m, double z_m, double direction) const {
    const double from[3] = {x_m, y_m, z_m}, along[3] = {0.0, 0.0, direction};
    const double distance_m =
        mj_ray(model_pointer_.get(), data_.get(), from, along, nullptr, 1, -1, nullptr, nullptr);
    return distance_m < 0.0 ? std::nullopt : std::optional(z_m + direction * distance_m);
  }
  // Whether the same holds all around the point: it lies near no edge.
  template <class Same>
  static bool holds_around(double x_m, double y_m, Same same) {
    return same(x_m + kEdge_m, y_m) && same(x_m - kEdge_m, y_m) && same(x_m, y_m + kEdge_m) &&
           same(x_m, y_m - kEdge_m);
  }

  // Asks `points` places; returns how many of them were on a solid, and how many below one.
  std::pair<int, int> compare(int points, double ceiling_m, facts::RandomStream& random) {
    const std::vector<world::Solid> solids = world_.all_solids(true);
    int on_solids = 0, below_solids = 0;
    for (int i = 0; i < points; ++i) {
      const double x_m = 8.0 * (random.uniform() - 0.5), y_m = 8.0 * (random.uniform() - 0.5);
      const auto count_at = [&](double x, double y) {
        return std::ranges::count_if(solids,
                                     [&](const auto& one) { return one.on_vertical(x, y).has_value(); });
      };
      const auto met = count_at(x_m, y_m);
      if (!holds_around(x_m, y_m, [&](double x, double y) { return count_at(x, y) == met; })) continue;
      const double top_m = world::height_at(solids, x_m, y_m).surface_m;
      EXPECT_NEAR(ray(x_m, y_m, 30.0, -1.0).value_or(-1.0), top_m, kTolerance_m) << x_m << ", " << y_m;
      on_solids += met > 0 ? 1 : 0;
      const bool inside = std::ranges::any_of(solids, [&](const world::Solid& one) {
        const auto part = one.on_vertical(x_m, y_m);
        return part && part->bottom_m <= ceiling_m + kEdge_m && part->top_m >= ceiling_m - kEdge_m;
      });
      if (inside) continue;
      const world::Height height = world::height_at(solids, x_m, y_m, ceiling_m);
      EXPECT_NEAR(ray(x_m, y_m, ceiling_m, -1.0).value_or(-1.0), height.surface_m, kTolerance_m);
      const std::optional<double> above = ray(x_m, y_m, ceiling_m, 1.0);
      EXPECT_EQ(above.has_value(), height.underside_m.has_value()) << x_m << ", " << y_m;
      EXPECT_NEAR(above.value_or(0.0), height.underside_m.value_or(0.0), kTolerance_m);
      below_solids += above ? 1 : 0;
    }
    return {on_solids, below_solids};
  }

  world::World world_;
  ModelPointer model_pointer_;
  DataPointer data_;
};

// Every kind of part, at angles of all kinds.
TEST_F(WorldModelTest, RaysMeetWhatTheFileSays) {
  build(
      world("boxes: [{position_m: [1, 2], yaw_deg: 33, size_m: [1.2, 0.7, 0.4], bottom_m: 0.3}]\n"
            "steps: [{position_m: [-3, -1], yaw_deg: 70, count: 5, rise_m: 0.03, run_m: 0.25, width_m: 1.1, "
            "top_m: 0.6, "
            "down: true}]\n"
            "slopes: [{position_m: [-2, 2], yaw_deg: -40, length_m: 1.5, rise_m: 0.5, width_m: 0.9, top_m: "
            "0.4, down: true}]\n"
            "tiles: [{position_m: [2, -2], yaw_deg: 15, size_m: [2, 2], tile_m: 0.2, height_m: 0.05}]\n"
            "walls: [{from_m: [-3, 3], to_m: [3, 2.5], height_m: 1.4, doors: [{at_m: 3, width_m: 1.5, "
            "height_m: 0.9}]}]\n"
            "things:\n"
            "  - {shape: sphere, diameter_m: 0.8, mass_kg: 1, position_m: [3, 1]}\n"
            "  - {shape: cylinder, diameter_m: 0.9, height_m: 0.3, mass_kg: 1, position_m: [-1, -2]}\n"));
  facts::RandomStream random(3, 1);
  const auto [on_solids, below_solids] = compare(4000, 0.85, random);
  EXPECT_GT(on_solids, 500);
  EXPECT_GT(below_solids, 5) << "the lintel";
}

TEST_F(WorldModelTest, RaysMeetSolidsAtAnyAngle) {
  facts::RandomStream random(7, 2);
  int on_solids = 0, below_solids = 0;
  for (int trial = 0; trial < 20; ++trial) {
    world::World world = this->world("{}\n");
    for (int i = 0; i < 20; ++i) {
      world::Solid solid;
      solid.name = std::to_string(i);
      solid.shape = static_cast<world::Solid::Shape>(random.next() % 3);
      solid.size_m = {0.1 + random.uniform(), 0.1 + random.uniform(), 0.1 + random.uniform()};
      if (solid.shape == world::Solid::Shape::cylinder) solid.size_m.y() = solid.size_m.x();
      if (solid.shape == world::Solid::Shape::sphere) solid.size_m.setConstant(solid.size_m.x());
      solid.pose.linear() =
          Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
              .normalized()
              .toRotationMatrix();
      const double x_m = 6.0 * (random.uniform() - 0.5), y_m = 6.0 * (random.uniform() - 0.5);
      solid.pose.translation() = Eigen::Vector3d(x_m, y_m, 0.5 + 2.0 * random.uniform());
      world.solids.push_back(solid);
    }
    build(std::move(world));
    const auto [on, below] = compare(200, 0.5 + random.uniform(), random);
    on_solids += on;
    below_solids += below;
  }
  EXPECT_GT(on_solids, 400);
  EXPECT_GT(below_solids, 200);
}

}  // namespace
}  // namespace gaitway::simulator
