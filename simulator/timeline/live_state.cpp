// Truth as JSON.
#include "live_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "gaitway/simulator/localization.hpp"
#include "gaitway/world/world.hpp"

namespace gaitway::timeline {
namespace {

using nlohmann::json;

constexpr std::size_t kMostNames = 200;  // of what was put there; the geometry has all

double yaw_of(const Eigen::Isometry3d& pose) {
  return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
}

json pose_json(const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d at = pose.translation();
  const Eigen::Quaterniond turn(pose.linear());
  return {at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z(), turn.w()};
}

json flat_json(const Eigen::Isometry3d& pose) {
  return {pose.translation().x(), pose.translation().y(), yaw_of(pose)};
}

// A surface's colour from afar.
json colour_json(const world::World& world, std::size_t surface) {
  const world::Surface& look = world.surfaces.at(surface);
  json colour = json::array();
  for (std::size_t i = 0; i < 3; ++i) {
    const bool two = look.kind == world::Surface::Kind::checker || look.kind == world::Surface::Kind::noise;
    const double value = look.kind == world::Surface::Kind::image ? 0.7
                         : two ? (look.colours[0][i] + look.colours[1][i]) / 2.0
                               : look.colours[0][i];
    colour.push_back(value);
  }
  return colour;
}

const char* name_of(world::Solid::Shape shape) {
  constexpr std::array<const char*, 3> kNames{"box", "cylinder", "sphere"};
  return kNames[static_cast<std::size_t>(shape)];
}

// The frame `odometry` in the world: there the estimated base lies over the true one, and the more loaded
// sole is at height 0.
json odometry_json(const simulator::Plant& plant, const Estimate& estimate) {
  const simulator::PlantTruth truth = plant.truth();
  const double yaw = yaw_of(truth.base) - estimate.odometry_base[2];
  const Eigen::Vector2d base = truth.base.translation().head<2>();
  const Eigen::Vector2d estimated(estimate.odometry_base[0], estimate.odometry_base[1]);
  const Eigen::Vector2d origin = base - Eigen::Rotation2Dd(yaw) * estimated;
  const std::size_t support = estimate.support == 0 ? 0 : 1;
  return {origin.x(), origin.y(), plant.ground_contact().sole[support].translation().z(), yaw};
}

}  // namespace

LiveState::LiveState(simulator::Cosimulation& run)
    : run_(run), estimate_(run.client().read<Estimate>("estimate")) {}

json LiveState::describe() {
  const simulator::Plant& plant = run_.plant();
  static_cast<void>(estimate_.read(newest_));
  json things = json::array(), put = json::array(), feet = json::array(), obstacles = json::array();
  const std::vector<world::Solid> solids = plant.solids();
  const std::size_t fixed = plant.world() ? plant.world()->solids.size() : 0;
  for (std::size_t i = fixed; i < solids.size(); ++i) {
    things.push_back({{"name", solids[i].name}, {"pose", pose_json(solids[i].pose)}});
  }
  const std::vector<world::Solid> put_solids = plant.put_solids();
  for (std::size_t i = 0; i < std::min(put_solids.size(), kMostNames); ++i) put.push_back(put_solids[i].name);
  const Obstacles boxes = simulator::boxes_around(put_solids);
  for (std::uint32_t i = 0; i < boxes.count; ++i) {
    obstacles.push_back({{"place", boxes.place[i]}, {"size", boxes.size[i]}});
  }
  for (const Eigen::Isometry3d& sole : plant.ground_contact().sole) feet.push_back(flat_json(sole));
  return {{"time_s", static_cast<double>(run_.now_ns()) * 1e-9},
          {"fallen", plant.fallen()},
          {"base", pose_json(plant.truth().base)},
          {"odometry", odometry_json(plant, newest_)},
          {"feet", feet},
          {"obstacles", obstacles},
          {"things", things},
          {"spawned", put},
          {"geometry", plant.geometry()}};
}

json LiveState::geometry(std::size_t first) const {
  const simulator::Plant& plant = run_.plant();
  if (!plant.world()) return {{"geometry", 0}, {"total", 0}, {"world", ""}, {"solids", json::array()}};
  const world::World& world = *plant.world();
  const std::vector<world::Solid> solids = plant.solids();
  json list = json::array();
  for (std::size_t i = first; i < std::min(solids.size(), first + kSolidsAtOnce); ++i) {
    const world::Solid& solid = solids[i];
    list.push_back({{"name", solid.name},
                    {"kind", world::name(solid.kind)},
                    {"shape", name_of(solid.shape)},
                    {"size", {solid.size_m.x(), solid.size_m.y(), solid.size_m.z()}},
                    {"pose", pose_json(solid.pose)},
                    {"colour", colour_json(world, solid.surface)},
                    {"movable", i >= world.solids.size()}});
  }
  return {{"geometry", plant.geometry()},
          {"world", world.name},
          {"total", solids.size()},
          {"floor_colour", colour_json(world, world.floor_surface)},
          {"start", {world.start.position_m.x(), world.start.position_m.y(), world.start.yaw_rad}},
          {"solids", list}};
}

}  // namespace gaitway::timeline
