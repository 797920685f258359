// Looks at the ground under the soles, and at what the physics engine says lies in what.
#include "world_ground.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

#include "gaitway/input/complaint.hpp"
#include "gaitway/world/height_grid.hpp"

namespace gaitway::simulator {
namespace {

constexpr double kUneven_m = 0.03;  // on a body as large as humanoid22
constexpr double kDepth_m = 0.001;  // what lies so deep in another begins inside of it
constexpr double kLookEvery_m = 0.01;

std::string millimetres(double length_m) {
  return std::to_string(std::lround(1000.0 * length_m)) + " mm";
}

[[noreturn]] void refuse_start(const world::World& world, const std::string& rule) {
  input::refuse(
      {world.file, world.start.line, "start", "", rule, "Begin elsewhere: start: {position_m: [x, y]}"});
}

// Of a sole, in its frame, close to one another.
std::vector<Eigen::Vector3d> places_of(const urdf::Foot& foot) {
  std::vector<Eigen::Vector3d> places;
  const Eigen::Vector2d corner = foot.centre_m - foot.size_m / 2.0;
  for (double x = 0.0; x <= foot.size_m.x(); x += kLookEvery_m) {
    for (double y = 0.0; y <= foot.size_m.y(); y += kLookEvery_m) {
      places.emplace_back(corner.x() + x, corner.y() + y, 0.0);
    }
  }
  return places;
}

}  // namespace

WorldGround::WorldGround(const world::World& world) {
  std::ranges::copy_if(world.solids, std::back_inserter(solids_),
                       [](const world::Solid& solid) { return world::is_ground(solid.kind); });
  for (const world::Solid& solid : solids_) highest_m_ = std::max(highest_m_, solid.bounds_m().second.z());
}

double WorldGround::height_above_m(const Eigen::Vector3d& point_m, double enough_m) const noexcept {
  const double at_least_m = point_m.z() - highest_m_;
  if (at_least_m >= enough_m) return at_least_m;
  return point_m.z() - world::height_at(solids_, point_m.x(), point_m.y(), point_m.z()).surface_m;
}

// Which of the solids is highest there; none: the floor.
const world::Solid* WorldGround::top_at(double x_m, double y_m) const noexcept {
  const world::Solid* top = nullptr;
  double top_m = 0.0;
  for (const world::Solid& solid : solids_) {
    const auto met = solid.on_vertical(x_m, y_m);
    if (!met || met->top_m <= top_m) continue;
    top = &solid;
    top_m = met->top_m;
  }
  return top;
}

Eigen::Isometry3d WorldGround::start_pose(const world::World& world, const urdf::RobotModel& robot,
                                          const std::array<Eigen::Isometry3d, 2>& soles_in_base,
                                          double base_height_m) const {
  const Eigen::Vector2d at = world.start.position_m;
  Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  base.translation().head<2>() = at;
  base.linear() = Eigen::AngleAxisd(world.start.yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const world::Solid* const middle = top_at(at.x(), at.y());
  bool on_one_solid = true;
  double lowest_m = std::numeric_limits<double>::infinity(), highest_m = -lowest_m;
  for (std::size_t side = 0; side < 2; ++side) {
    for (const Eigen::Vector3d& place : places_of(robot.feet[side])) {
      const Eigen::Vector3d point = base * soles_in_base[side] * place;
      on_one_solid = on_one_solid && top_at(point.x(), point.y()) == middle;
      const double top_m = world::height_at(solids_, point.x(), point.y()).surface_m;
      lowest_m = std::min(lowest_m, top_m);
      highest_m = std::max(highest_m, top_m);
    }
  }
  if (on_one_solid && middle != nullptr && middle->kind == world::Kind::slope) {
    const Eigen::Vector3d normal = middle->pose.linear().col(2);
    base.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), normal) * base.linear();
    base.translation().z() = middle->on_vertical(at.x(), at.y())->top_m;
    base.translation() += base_height_m * normal;
    return base;
  }
  if (highest_m - lowest_m > kUneven_m * robot.body_scale().factor("m")) {
    refuse_start(world, "the ground under the soles differs by " + millimetres(highest_m - lowest_m));
  }
  base.translation().z() = highest_m + base_height_m;
  return base;
}

void require_plain_ground(const GroundConditions& conditions, const world::World& world) {
  if (!conditions.slope_rad.isZero(0.0) || conditions.tile_height_m > 0.0 || conditions.step) {
    throw std::invalid_argument(
        "the conditions slope_deg, tiles_m and step are of the plain floor, and the world '" + world.name +
        "' has a ground of its own. Leave one of them out");
  }
}

void require_room(const mjModel& model, const mjData& state, const ContactReader& contacts,
                  const world::World& world, const urdf::RobotModel& robot) {
  const std::vector<world::Solid> solids = world.all_solids(true);
  const auto solid_name = [&](int solid) {
    return solid == BodyContact::kFloor
               ? std::string("the floor")
               : std::string(world::name(solids[static_cast<std::size_t>(solid)].kind)) + " '" +
                     solids[static_cast<std::size_t>(solid)].name + "'";
  };
  for (int i = 0; i < state.ncon; ++i) {
    const mjContact& contact = state.contact[i];
    const auto [link, other_link] = contacts.links_in(model, contact);
    if (contact.dist > -kDepth_m || other_link >= 0) continue;  // room is what the world has
    const int first = contacts.solid_of(contact.geom[0]), second = contacts.solid_of(contact.geom[1]);
    const std::string depth = " begins " + millimetres(-contact.dist) + " inside of ";
    if (link >= 0) {
      refuse_start(world, "the robot's " + robot.links[static_cast<std::size_t>(link)].name + depth +
                              solid_name(std::max(first, second)));
    }
    const world::Solid& thing = solids[static_cast<std::size_t>(std::max(first, second))];
    input::refuse({world.file, thing.line, thing.name, "",
                   "the thing" + depth + solid_name(std::min(first, second)),
                   "Move one of them, or raise bottom_m"});
  }
}

}  // namespace gaitway::simulator
