// What is put into the world, moved and taken away while the robot is in it: the physics model is built anew,
// and the state of all that stays goes over.
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "gaitway/input/complaint.hpp"
#include "gaitway/simulator/plant.hpp"
#include "plant_implementation.hpp"

namespace gaitway::simulator {
namespace {

constexpr double kDeepest_m = 0.002;  // that a solid may reach into the robot where it appears
constexpr int kFreePositions = 7, kFreeVelocities = 6;

struct FreeState {
  std::array<double, kFreePositions> position{};
  std::array<double, kFreeVelocities> velocity{}, warm_start{};
};

int position_address(const mjModel& model, int body) {
  return model.jnt_qposadr[model.body_jntadr[body]];
}
int velocity_address(const mjModel& model, int body) {
  return model.jnt_dofadr[model.body_jntadr[body]];
}

FreeState state_of(const mjModel& model, const mjData& data, int body) {
  FreeState state;
  std::copy_n(data.qpos + position_address(model, body), kFreePositions, state.position.begin());
  std::copy_n(data.qvel + velocity_address(model, body), kFreeVelocities, state.velocity.begin());
  std::copy_n(data.qacc_warmstart + velocity_address(model, body), kFreeVelocities, state.warm_start.begin());
  return state;
}

void set_state(const mjModel& model, mjData& data, int body, const FreeState& state) {
  std::ranges::copy(state.position, data.qpos + position_address(model, body));
  std::ranges::copy(state.velocity, data.qvel + velocity_address(model, body));
  std::ranges::copy(state.warm_start, data.qacc_warmstart + velocity_address(model, body));
}

// Of the robot, which comes before the things.
std::pair<int, int> robot_dimensions(const mjModel& model, const std::vector<int>& thing_body) {
  if (thing_body.empty()) return {static_cast<int>(model.nq), static_cast<int>(model.nv)};
  return {position_address(model, thing_body.front()), velocity_address(model, thing_body.front())};
}

std::vector<std::string> names_of(const world::World& world) {
  std::vector<std::string> names;
  for (const world::Solid& solid : world.all_solids(true)) names.push_back(solid.name);
  return names;
}

// An equal one that is there already, or a new one.
std::size_t surface_of(world::World& world, const world::Colour& colour) {
  const auto same = std::ranges::find_if(world.surfaces, [&colour](const world::Surface& surface) {
    return surface.kind == world::Surface::Kind::plain && surface.colours[0] == colour;
  });
  const auto index = static_cast<std::size_t>(same - world.surfaces.begin());
  if (same == world.surfaces.end()) {
    if (world.surfaces.size() >= world::kMostSurfaces) {
      throw std::invalid_argument("the world has " + std::to_string(world.surfaces.size()) +
                                  " surfaces, as many as it may: choose a colour that is there");
    }
    world.surfaces.push_back({.kind = world::Surface::Kind::plain, .colours = {colour}, .image = {}});
  }
  return index;
}

// Those that only something had that is gone.
void drop_unused_surfaces(world::World& world, std::size_t first) {
  for (std::size_t i = world.surfaces.size(); i-- > first;) {
    const auto uses = [i](const world::Solid& solid) { return solid.surface == i; };
    const bool used = world.floor_surface == i || std::ranges::any_of(world.solids, uses) ||
                      std::ranges::any_of(world.things, uses, &world::Thing::solid);
    if (used) continue;
    world.surfaces.erase(world.surfaces.begin() + static_cast<std::ptrdiff_t>(i));
    const auto renumber = [i](world::Solid& solid) { solid.surface -= solid.surface > i ? 1 : 0; };
    std::ranges::for_each(world.solids, renumber);
    std::ranges::for_each(world.things, renumber, &world::Thing::solid);
  }
}

void require_room_for_one(std::size_t there, std::size_t most, const char* what) {
  if (there >= most) {
    throw std::invalid_argument("the world has " + std::to_string(there) + " " + what +
                                ", as many as it may: remove one first");
  }
}

}  // namespace

world::World& Plant::Implementation::changeable_world() {
  if (!world) {
    throw std::invalid_argument(
        "the robot is in no world, where nothing can be put: give one (--world empty)");
  }
  return *world;
}

world::World Plant::Implementation::world_as_it_lies() const {
  world::World now = *world;
  for (std::size_t i = 0; i < thing_body.size(); ++i)
    now.things[i].solid.pose = body_pose(*data, thing_body[i]);
  return now;
}

void Plant::Implementation::change_world(world::World next, std::string_view newcomer) {
  std::map<std::string, FreeState> things;
  for (std::size_t i = 0; i < thing_body.size(); ++i) {
    const std::string& name = world->things[i].solid.name;
    if (name != newcomer) things.emplace(name, state_of(*model, *data, thing_body[i]));
  }
  std::optional<world::World> changed(std::move(next));
  ModelPointer next_model = build_physics_model(robot, mismatch, conditions, changed);
  set_drawn(*next_model);
  DataPointer next_data(mj_makeData(next_model.get()));
  std::vector<int> next_bodies = bodies_of_things(*next_model, changed);
  const auto [positions, velocities] = robot_dimensions(*model, thing_body);
  next_data->time = data->time;
  std::copy_n(data->qpos, positions, next_data->qpos);
  std::copy_n(data->qvel, velocities, next_data->qvel);
  std::copy_n(data->qacc_warmstart, velocities, next_data->qacc_warmstart);
  for (std::size_t i = 0; i < next_bodies.size(); ++i) {
    const auto known = things.find(changed->things[i].solid.name);
    if (known != things.end()) set_state(*next_model, *next_data, next_bodies[i], known->second);
  }
  ContactReader next_contacts = contacts;
  next_contacts.follow(*next_model, changed);
  mj_step1(next_model.get(), next_data.get());
  if (const int link =
          next_contacts.link_inside(*next_model, *next_data, changed->index_of(newcomer), kDeepest_m);
      link >= 0) {
    throw std::invalid_argument("'" + std::string(newcomer) + "' would lie inside the robot's " +
                                robot.links[static_cast<std::size_t>(link)].name + ": choose another place");
  }
  // A push goes on, but not of what is no longer there.
  std::erase_if(pushes, [&](ActivePush& push) {
    push.body = mj_name2id(next_model.get(), mjOBJ_BODY, mj_id2name(model.get(), mjOBJ_BODY, push.body));
    return push.body < 0;
  });
  home.resize(static_cast<std::size_t>(positions));
  home.insert(home.end(), next_model->qpos0 + positions, next_model->qpos0 + next_model->nq);
  world = std::move(changed);
  world_ground.emplace(*world);
  contacts = std::move(next_contacts);
  thing_body = std::move(next_bodies);
  data = std::move(next_data);
  model = std::move(next_model);
  ++geometry;
}

void Plant::put(const world::Solid& solid, const world::Colour& colour, std::optional<double> mass_kg) {
  Implementation& self = *implementation_;
  const world::World& before = self.changeable_world();
  if (before.index_of(solid.name) >= 0) {
    throw std::invalid_argument("the world has a '" + solid.name + "' already: choose another name");
  }
  world::World next = self.world_as_it_lies();
  world::Solid added = solid;
  added.surface = surface_of(next, colour);
  if (mass_kg) {
    require_room_for_one(next.things.size(), world::kMostThings, "things");
    added.kind = world::Kind::thing;
    next.things.push_back({.solid = added, .mass_kg = *mass_kg});
  } else {
    require_room_for_one(next.solids.size(), world::kMostSolids, "solids");
    next.solids.push_back(added);
  }
  self.change_world(std::move(next), added.name);
  self.put_names.push_back(added.name);
}

void Plant::move(std::string_view name, const Eigen::Isometry3d& pose) {
  Implementation& self = *implementation_;
  world::World next = (static_cast<void>(self.changeable_world()), self.world_as_it_lies());
  const auto thing =
      std::ranges::find(next.things, name, [](const world::Thing& one) { return one.solid.name; });
  const bool was_put = std::ranges::find(self.put_names, name) != self.put_names.end();
  const auto fixed = std::ranges::find(next.solids, name, &world::Solid::name);
  if (thing != next.things.end()) {
    thing->solid.pose = pose;
  } else if (was_put && fixed != next.solids.end()) {
    fixed->pose = pose;
  } else if (fixed != next.solids.end()) {
    throw std::invalid_argument(
        "'" + std::string(name) +
        "' stands fast: only things that can be pushed, and what was put there, move");
  } else {
    throw std::invalid_argument("the world has no '" + std::string(name) + "'. " +
                                input::suggest(std::string(name), names_of(next)));
  }
  self.change_world(std::move(next), name);
}

void Plant::remove(std::string_view name) {
  Implementation& self = *implementation_;
  world::World next = (static_cast<void>(self.changeable_world()), self.world_as_it_lies());
  if (std::ranges::find(self.put_names, name) == self.put_names.end()) {
    throw std::invalid_argument("'" + std::string(name) + "' is nothing that was put into the world. " +
                                input::suggest(std::string(name), self.put_names));
  }
  std::erase_if(next.solids, [name](const world::Solid& solid) { return solid.name == name; });
  std::erase_if(next.things, [name](const world::Thing& thing) { return thing.solid.name == name; });
  drop_unused_surfaces(next, self.own_surfaces);
  self.change_world(std::move(next), {});
  std::erase(self.put_names, name);
}

std::vector<world::Solid> Plant::put_solids() const {
  std::vector<world::Solid> all = solids();
  const std::vector<std::string>& names = implementation_->put_names;
  std::erase_if(all, [&names](const world::Solid& solid) {
    return std::ranges::find(names, solid.name) == names.end();
  });
  return all;
}

std::uint32_t Plant::geometry() const noexcept {
  return implementation_->geometry;
}

}  // namespace gaitway::simulator
