// Puts boxes into worlds.
#include "written_scene.hpp"

#include <cmath>
#include <numbers>

#include "gaitway/facts/random_stream.hpp"

namespace gaitway::planning {

Limits small_humanoid() {
  return {
      .sole = {.length_m = 0.135, .width_m = 0.085, .centre_forward_m = 0.010},
      .foot_spacing_m = 0.100,
      .max_step_forward_m = 0.150,
      .max_step_backward_m = 0.100,
      .max_foot_spacing_m = 0.200,
      .max_step_turn_rad = 0.50,
      .min_sole_gap_m = 0.008,
      .max_step_height_m = 0.010,
      .sole_unevenness_m = 0.006,
      .lift_m = 0.020,
      .bands =
          {{0.02, {{-0.06, -0.0925}, {0.09, -0.0925}, {0.09, 0.0925}, {-0.06, 0.0925}}},
           {0.22,
            {{-0.05, -0.165}, {0.05, -0.165}, {0.08, -0.08}, {0.08, 0.08}, {0.05, 0.165}, {-0.05, 0.165}}}},
      .height_m = 0.825,
      .clearance_m = 0.03};
}

const Planner& planner() {
  static const Planner one(small_humanoid(), kCell_m);
  return one;
}

world::Solid upright(world::Kind kind, double x_m, double y_m, double length_m, double width_m,
                     double height_m, double yaw_rad, double bottom_m) {
  world::Solid solid;
  solid.kind = kind;
  solid.pose.translation() = Eigen::Vector3d(x_m, y_m, bottom_m + 0.5 * height_m);
  solid.pose.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  solid.size_m = Eigen::Vector3d(length_m, width_m, height_m);
  return solid;
}

Request Scene::request() const {
  const Limits limits = small_humanoid();
  return {
      .left = limits.foot_of(start, Side::left), .right = limits.foot_of(start, Side::right), .goal = goal};
}

Scene floor(double length_m, double width_m) {
  Scene scene;
  scene.grid = {.origin_m = {-0.5 * length_m, -0.5 * width_m},
                .cell_m = kCell_m,
                .columns = static_cast<int>(std::lround(length_m / kCell_m)),
                .rows = static_cast<int>(std::lround(width_m / kCell_m))};
  return scene;
}

Scene random_scene(std::uint64_t seed, double side_m, int boxes) {
  facts::RandomStream random(seed, 0x7363'656E'65ULL);
  const auto between = [&random](double least, double most) {
    return least + (most - least) * random.uniform();
  };
  Scene scene = floor(side_m, side_m);
  const double half_m = 0.5 * side_m;
  for (int i = 0; i < boxes; ++i) {
    const double x_m = between(-half_m, half_m), y_m = between(-half_m, half_m);
    const double length_m = between(0.10, 0.40), width_m = between(0.10, 0.30),
                 height_m = between(0.02, 0.25);
    scene.world.solids.push_back(
        upright(world::Kind::box, x_m, y_m, length_m, width_m, height_m, between(0.0, std::numbers::pi)));
  }
  const double most_m = half_m - 0.3;
  scene.start = {between(-most_m, most_m), between(-most_m, most_m), between(-3.1, 3.1)};
  scene.goal = {between(-most_m, most_m), between(-most_m, most_m), between(-3.1, 3.1)};
  return scene;
}

}  // namespace gaitway::planning
