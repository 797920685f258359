// Builds MuJoCo's model of robot and ground with mjSpec.
#include "physics_model.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>
#include <string>

#include "gaitway/facts/facts.hpp"

namespace gaitway::simulator {
namespace {

// Bits of the contact types: what stands fast and things have the first, links of the robot the second.
constexpr int kWorldType = 1, kLinkType = 2;
// Of the stop at either end of a joint's play: as hard as the time step allows.
constexpr double kPlayStopTime_s = 0.002;
constexpr double kPlayArmature_kg_m2 = 1e-5;

struct SpecDeleter {
  void operator()(mjSpec* spec) const noexcept { mj_deleteSpec(spec); }
};

void copy(const Eigen::Vector3d& from, double* to) {
  std::copy_n(from.data(), 3, to);
}

void copy_pose(const Eigen::Isometry3d& pose, double* position, double* quaternion) {
  copy(pose.translation(), position);
  const Eigen::Quaterniond rotation(pose.linear());
  quaternion[0] = rotation.w();
  quaternion[1] = rotation.x();
  quaternion[2] = rotation.y();
  quaternion[3] = rotation.z();
}

void add_sky(mjSpec* spec) {
  mjsTexture* const sky = mjs_addTexture(spec, nullptr);
  sky->type = mjTEXTURE_SKYBOX;
  sky->builtin = mjBUILTIN_GRADIENT;
  sky->width = 64;
  sky->height = 384;
  const double top[3] = {0.62, 0.74, 0.88}, bottom[3] = {0.96, 0.97, 0.98};
  std::copy_n(top, 3, sky->rgb1);
  std::copy_n(bottom, 3, sky->rgb2);
}

void add_sun(mjSpec* spec) {
  mjsLight* const light = mjs_addLight(mjs_findBody(spec, "world"), nullptr);
  light->type = mjLIGHT_DIRECTIONAL;
  std::copy_n(kSunDirection.data(), 3, light->dir);
  light->castshadow = 1;
}

void use_mesh(mjSpec* spec, const urdf::Mesh& file, mjsGeom* geom) {
  mjsMesh* const mesh = mjs_addMesh(spec, nullptr);
  const std::string name = "mesh " + std::to_string(mjs_getId(mesh->element));
  mjs_setName(mesh->element, name.c_str());
  mjs_setString(mesh->content_type, "model/stl");
  mjs_setString(mesh->file, file.file.c_str());
  copy(file.scale, mesh->scale);
  mesh->inertia = mjMESH_INERTIA_SHELL;  // it weighs nothing here, and need not be closed
  mjs_setString(geom->meshname, name.c_str());
}

mjsGeom* add_shape(mjSpec* spec, mjsBody* body, const urdf::Shape& shape) {
  using Kind = urdf::Shape::Kind;
  mjsGeom* const geom = mjs_addGeom(body, nullptr);
  const Eigen::Vector3d half = shape.size_m / 2.0;
  Eigen::Isometry3d pose = shape.pose;
  switch (shape.kind) {
    case Kind::box:
      geom->type = mjGEOM_BOX;
      copy(half, geom->size);
      break;
    case Kind::cylinder:
      geom->type = mjGEOM_CYLINDER;
      copy({half.x(), half.z(), 0.0}, geom->size);
      break;
    case Kind::sphere:
      geom->type = mjGEOM_SPHERE;
      copy(half, geom->size);
      break;
    case Kind::mesh:
      geom->type = mjGEOM_MESH;
      pose.translate(-shape.mesh.centre_m);
      use_mesh(spec, shape.mesh, geom);
      break;
  }
  copy_pose(pose, geom->pos, geom->quat);
  geom->mass = 0.0;
  return geom;
}

void add_collision(mjSpec* spec, mjsBody* body, const urdf::Link& link, double friction) {
  for (const urdf::Shape& shape : link.collision) {
    mjsGeom* const geom = add_shape(spec, body, shape);
    geom->contype = kLinkType;
    geom->conaffinity = kWorldType | kLinkType;
    geom->condim = 3;
    geom->friction[0] = friction;
    geom->group = 3;  // not drawn
  }
}

void add_visuals(mjSpec* spec, mjsBody* body, const urdf::Link& link) {
  for (const urdf::Shape& shape : link.visual) {
    mjsGeom* const geom = add_shape(spec, body, shape);
    geom->contype = geom->conaffinity = 0;
    geom->group = 1;
    for (Eigen::Index i = 0; i < 4; ++i) {
      geom->rgba[i] = static_cast<float>(shape.rgba[i]);
    }
  }
}

void set_inertia(mjsBody* body, const urdf::Link& link, double factor, const Eigen::Vector3d& com_offset_m) {
  body->explicitinertial = 1;
  body->mass = link.mass_kg * factor;
  copy(link.com_m + com_offset_m, body->ipos);
  const Eigen::Matrix3d inertia = link.inertia_kg_m2 * factor;
  const double full[6] = {inertia(0, 0), inertia(1, 1), inertia(2, 2),
                          inertia(0, 1), inertia(0, 2), inertia(1, 2)};
  std::copy_n(full, 6, body->fullinertia);
}

void add_hinge(mjsBody* body, const urdf::Joint& joint) {
  mjsJoint* const hinge = mjs_addJoint(body, nullptr);
  mjs_setName(hinge->element, joint.name.c_str());
  hinge->type = mjJNT_HINGE;
  copy(joint.axis, hinge->axis);
  hinge->limited = mjLIMITED_TRUE;
  hinge->range[0] = joint.lower_rad;
  hinge->range[1] = joint.upper_rad;
  hinge->armature = joint.motor.armature_kg_m2;
  hinge->damping[0] = joint.motor.damping_Nms_per_rad;
  hinge->frictionloss = joint.motor.friction_Nm;
}

// Behind the motor and its encoder the link can move on by itself, from one stop to the other.
void add_play(mjsBody* body, const urdf::Joint& joint, double width_rad) {
  mjsJoint* const hinge = mjs_addJoint(body, nullptr);
  mjs_setName(hinge->element, (joint.name + "_play").c_str());
  hinge->type = mjJNT_HINGE;
  copy(joint.axis, hinge->axis);
  hinge->limited = mjLIMITED_TRUE;
  hinge->range[0] = -width_rad / 2.0;
  hinge->range[1] = width_rad / 2.0;
  hinge->solref_limit[0] = kPlayStopTime_s;
  hinge->solref_limit[1] = 1.0;
  hinge->armature = kPlayArmature_kg_m2;
}

// The forces between foot and leg: first left, then right, each force and torque.
void add_foot_sensors(mjSpec* spec, const urdf::RobotModel& robot, const std::vector<mjsBody*>& bodies) {
  for (const urdf::Foot& foot : robot.feet) {
    if (foot.sensor != urdf::FootSensor::six_axis) continue;
    mjsSite* const site = mjs_addSite(bodies[static_cast<std::size_t>(foot.link)], nullptr);
    const std::string name = robot.links[static_cast<std::size_t>(foot.link)].name + " sensor";
    mjs_setName(site->element, name.c_str());
    copy_pose(foot.sensor_pose, site->pos, site->quat);
    site->group = 3;  // not drawn
    for (const mjtSensor type : {mjSENS_FORCE, mjSENS_TORQUE}) {
      mjsSensor* const sensor = mjs_addSensor(spec);
      sensor->type = type;
      sensor->objtype = mjOBJ_SITE;
      mjs_setString(sensor->objname, name.c_str());
    }
  }
}

void add_robot(mjSpec* spec, const urdf::RobotModel& robot, const ModelMismatch& mismatch,
               const Conditions& conditions) {
  const double friction = conditions.ground.friction.value_or(robot.contact.friction);
  // A calibration tells what the robot is believed to be, and does not change what it is.
  const Eigen::Vector3d described_to_true_m = mismatch.trunk_com_offset_m - robot.trunk_com_offset_m;
  std::vector<mjsBody*> bodies;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const urdf::Link& link = robot.links[i];
    mjsBody* body = nullptr;
    if (link.parent_joint < 0) {
      body = mjs_addBody(mjs_findBody(spec, "world"), nullptr);
      mjs_addFreeJoint(body);
    } else {
      const urdf::Joint& joint = robot.joints[static_cast<std::size_t>(link.parent_joint)];
      body = mjs_addBody(bodies[static_cast<std::size_t>(joint.parent_link)], nullptr);
      copy_pose(joint.origin, body->pos, body->quat);
      add_hinge(body, joint);
      if (conditions.body.backlash_rad > 0.0) add_play(body, joint, conditions.body.backlash_rad);
    }
    mjs_setName(body->element, link.name.c_str());
    const bool is_trunk = static_cast<int>(i) == robot.imu.link;
    set_inertia(body, link, mismatch.mass_factor[i] * (is_trunk ? conditions.body.trunk_mass_factor : 1.0),
                is_trunk ? described_to_true_m : Eigen::Vector3d::Zero());
    add_collision(spec, body, link, friction);
    add_visuals(spec, body, link);
    bodies.push_back(body);
  }
  add_foot_sensors(spec, robot, bodies);
}

// Chosen for speed at equal motion: Newton converges in one or two iterations here, so that tighter
// tolerances change nothing; the pyramidal cone is the faster one; islands and mid-phase cost more than they
// save with one robot.
void set_options(mjSpec& spec, const urdf::RobotModel& robot) {
  spec.compiler.degree = 0;
  spec.option.timestep = robot.physics_step_s;
  spec.option.gravity[0] = spec.option.gravity[1] = 0.0;
  spec.option.gravity[2] = -facts::kGravity_m_per_s2;
  spec.option.integrator = mjINT_IMPLICITFAST;
  spec.option.solver = mjSOL_NEWTON;
  spec.option.cone = mjCONE_PYRAMIDAL;
  spec.option.iterations = 20;
  spec.option.tolerance = 1e-6;
  // No automatic reset either: a robot that blew up must be seen, not put back on its feet.
  spec.option.disableflags |= mjDSBL_ISLAND | mjDSBL_MIDPHASE | mjDSBL_AUTORESET;
  spec.visual.global.offwidth = kLargestPictureWidth_px;
  spec.visual.global.offheight = kLargestPictureHeight_px;
  spec.stat.extent = 1.0;             // m: the scale of the next line
  spec.visual.map.shadowclip = 3.0F;  // half the width of what the sun sees: the foreground, too
  spec.visual.quality.shadowsize = 4096;
  for (int i = 0; i < 3; ++i) {
    spec.visual.headlight.ambient[i] = 0.35F;
    spec.visual.headlight.diffuse[i] = 0.30F;
    spec.visual.headlight.specular[i] = 0.10F;
  }
}

ModelPointer compiled(mjSpec* spec, const urdf::RobotModel& robot, const std::optional<world::World>& world) {
  ModelPointer model(mj_compile(spec, nullptr));
  if (!model) {
    throw std::runtime_error(robot.name + (world ? " in " + world->file.string() : "") +
                             ": the physics model cannot be built: " + mjs_getError(spec));
  }
  return model;
}

}  // namespace

ModelPointer build_physics_model(const urdf::RobotModel& robot, const ModelMismatch& mismatch,
                                 const Conditions& conditions, const std::optional<world::World>& world) {
  const std::unique_ptr<mjSpec, SpecDeleter> spec(mj_makeSpec());
  set_options(*spec, robot);
  const std::optional<double> floor = world ? world->floor_friction : std::nullopt;
  const double friction = conditions.ground.friction.value_or(floor.value_or(robot.contact.friction));
  if (world) {
    spec->option.disableflags &= ~mjDSBL_MIDPHASE;  // many solids are near none of the robot
    add_world(spec.get(), *world, friction);
  } else {
    add_ground(spec.get(), conditions.ground, friction);
  }
  add_sky(spec.get());
  if (!world || world->lights.empty()) add_sun(spec.get());
  add_robot(spec.get(), robot, mismatch, conditions);
  if (world) {
    for (const urdf::Foot& foot : robot.feet) {
      const std::string& link = robot.links[static_cast<std::size_t>(foot.link)].name;
      make_equal_to_ground(mjs_findBody(spec.get(), link.c_str()), *world, friction);
    }
    add_things(spec.get(), *world, friction);
  }
  leave_out(spec.get(), robot, neighbouring_links(robot));
  ModelPointer model = compiled(spec.get(), robot, world);
  const std::vector<LinkPair> touching = touching_at_home(*model, robot);
  if (touching.empty()) return model;
  leave_out(spec.get(), robot, touching);
  return compiled(spec.get(), robot, world);
}

}  // namespace gaitway::simulator
