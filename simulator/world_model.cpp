// Lays a world into the physics model: floor, solids, things that can be pushed, tags, lights.
#include <algorithm>
#include <cstddef>
#include <string>

#include "gaitway/world/picture.hpp"
#include "physics_model.hpp"

namespace gaitway::simulator {
namespace {

constexpr int kTouches = 1;
// A contact has the friction of the world's part in it, and of what can be pushed before what stands fast.
constexpr int kSolidPriority = 1, kThingPriority = 2;
// So that what is round comes to rest.
constexpr double kTurningFriction_m = 0.005, kRollingFriction_m = 0.001;
constexpr double kTagThickness_m = 0.002;

void set_pose(const Eigen::Isometry3d& pose, double* position, double* quaternion) {
  std::copy_n(pose.translation().data(), 3, position);
  const Eigen::Quaterniond rotation(pose.linear());
  quaternion[0] = rotation.w();
  quaternion[1] = rotation.x();
  quaternion[2] = rotation.y();
  quaternion[3] = rotation.z();
}

std::string surface_name(std::size_t index) {
  return "surface " + std::to_string(index);
}

void add_material(mjSpec* spec, const std::string& name, const std::string& texture, double repeats_per_m) {
  mjsMaterial* const material = mjs_addMaterial(spec, nullptr);
  mjs_setName(material->element, name.c_str());
  mjs_setInStringVec(material->textures, mjTEXROLE_RGB, texture.c_str());
  material->texuniform = repeats_per_m > 0.0 ? 1 : 0;
  material->texrepeat[0] = material->texrepeat[1] =
      repeats_per_m > 0.0 ? static_cast<float>(repeats_per_m) : 1.0F;
  material->specular = 0.1F;
}

mjsTexture* add_texture(mjSpec* spec, const std::string& name) {
  mjsTexture* const texture = mjs_addTexture(spec, nullptr);
  mjs_setName(texture->element, name.c_str());
  texture->type = mjTEXTURE_2D;
  texture->nchannel = 3;
  return texture;
}

void set_pixels(mjsTexture* texture, const world::Picture& picture) {
  texture->width = picture.width_px;
  texture->height = picture.height_px;
  mjs_setBuffer(texture->data, picture.rgb.data(), static_cast<int>(picture.rgb.size()));
}

void add_surfaces(mjSpec* spec, const world::World& world) {
  for (std::size_t i = 0; i < world.surfaces.size(); ++i) {
    const world::Surface& surface = world.surfaces[i];
    const std::string name = surface_name(i);
    mjsTexture* const texture = add_texture(spec, name);
    if (surface.kind == world::Surface::Kind::image) {
      mjs_setString(texture->content_type, "image/png");
      mjs_setString(texture->file, std::filesystem::absolute(surface.image).c_str());
    } else {
      set_pixels(texture, world::picture_of(surface));
    }
    add_material(spec, name, name, 1.0 / surface.repeat_m);
  }
}

void set_shape(const world::Solid& solid, mjsGeom* geom) {
  using Shape = world::Solid::Shape;
  const Eigen::Vector3d half = solid.size_m / 2.0;
  geom->type = solid.shape == Shape::box        ? mjGEOM_BOX
               : solid.shape == Shape::cylinder ? mjGEOM_CYLINDER
                                                : mjGEOM_SPHERE;
  const Eigen::Vector3d size =
      solid.shape == Shape::cylinder ? Eigen::Vector3d(half.x(), half.z(), 0.0) : half;
  std::copy_n(size.data(), 3, geom->size);
}

void set_contact(mjsGeom* geom, double friction, int priority) {
  geom->contype = kTouches;
  geom->conaffinity = 0;
  geom->friction[0] = friction;
  geom->priority = priority;
}

mjsGeom* add_solid(const world::Solid& solid, double friction, mjsBody* body) {
  mjsGeom* const geom = mjs_addGeom(body, nullptr);
  mjs_setName(geom->element, world_name(solid).c_str());
  set_shape(solid, geom);
  set_contact(geom, solid.friction.value_or(friction), kSolidPriority);
  mjs_setString(geom->material, surface_name(solid.surface).c_str());
  return geom;
}

void add_thing(mjSpec* spec, const world::Thing& thing, double friction) {
  mjsBody* const body = mjs_addBody(mjs_findBody(spec, "world"), nullptr);
  mjs_setName(body->element, world_name(thing.solid).c_str());
  set_pose(thing.solid.pose, body->pos, body->quat);
  mjs_addFreeJoint(body);
  mjsGeom* const geom = add_solid(thing.solid, friction, body);
  geom->mass = thing.mass_kg;
  geom->priority = kThingPriority;
  geom->conaffinity = kTouches;  // ground and one another, too
  if (thing.solid.shape != world::Solid::Shape::box) {
    geom->condim = 6;
    geom->friction[1] = kTurningFriction_m;
    geom->friction[2] = kRollingFriction_m;
  }
}

void add_floor(mjSpec* spec, const world::World& world, double friction) {
  mjsGeom* const plane = mjs_addGeom(mjs_findBody(spec, "world"), nullptr);
  mjs_setName(plane->element, "ground");
  plane->type = mjGEOM_PLANE;
  plane->size[0] = plane->size[1] = 0.0;  // endless
  plane->size[2] = 0.05;
  set_contact(plane, friction, kSolidPriority);
  mjs_setString(plane->material, surface_name(world.floor_surface).c_str());
}

void add_tag(mjSpec* spec, const world::Tag& tag, std::size_t number) {
  const std::string name = "tag " + std::to_string(number);
  set_pixels(add_texture(spec, name), world::picture_of_tag(tag.id));
  add_material(spec, name, name, 0.0);
  mjsGeom* const plate = mjs_addGeom(mjs_findBody(spec, "world"), nullptr);
  plate->type = mjGEOM_BOX;
  const double half_m = tag.size_m / 2.0 * world::kTagPictureCells / world::kTagCells;
  plate->size[0] = plate->size[1] = half_m;
  plate->size[2] = kTagThickness_m / 2.0;
  set_pose(tag.pose, plate->pos, plate->quat);
  plate->contype = plate->conaffinity = 0;
  mjs_setString(plate->material, name.c_str());
}

void add_light(mjSpec* spec, const world::Light& light) {
  const bool is_sun = light.kind == world::Light::Kind::sun;
  mjsLight* const added = mjs_addLight(mjs_findBody(spec, "world"), nullptr);
  added->type = is_sun ? mjLIGHT_DIRECTIONAL : mjLIGHT_POINT;
  std::copy_n(light.position_m.data(), 3, added->pos);
  std::copy_n(light.direction.data(), 3, added->dir);
  added->castshadow = is_sun ? 1 : 0;
  std::ranges::transform(light.colour, added->diffuse,
                         [](double share) { return static_cast<float>(share); });
}

}  // namespace

std::string world_name(const world::Solid& solid) {
  return "world/" + solid.name;
}

void add_world(mjSpec* spec, const world::World& world, double friction) {
  add_surfaces(spec, world);
  add_floor(spec, world, friction);
  for (const world::Solid& solid : world.solids) {
    mjsGeom* const geom = add_solid(solid, friction, mjs_findBody(spec, "world"));
    set_pose(solid.pose, geom->pos, geom->quat);
  }
  for (std::size_t i = 0; i < world.tags.size(); ++i) add_tag(spec, world.tags[i], i);
  for (const world::Light& light : world.lights) add_light(spec, light);
}

// Between equals the larger friction counts, and the mean of their springs.
void make_equal_to_ground(mjsBody* foot, const world::World& world, double friction) {
  for (const world::Solid& solid : world.solids) {
    friction = std::min(friction, solid.friction.value_or(friction));
  }
  for (mjsElement* shape = mjs_firstChild(foot, mjOBJ_GEOM, 0); shape != nullptr;
       shape = mjs_nextChild(foot, shape, 0)) {
    mjsGeom* const geom = mjs_asGeom(shape);
    geom->priority = kSolidPriority;
    geom->friction[0] = friction;
  }
}

void add_things(mjSpec* spec, const world::World& world, double friction) {
  for (const world::Thing& thing : world.things) add_thing(spec, thing, friction);
}

}  // namespace gaitway::simulator
