// The simulated body: steps the physics, limits the motors and reads the sensors.
#include "gaitway/simulator/plant.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/tilt.hpp"
#include "plant_implementation.hpp"

namespace gaitway::simulator {
namespace {

constexpr double kMassDeviation = 0.05;
constexpr double kZeroDeviation_rad = 0.4 * std::numbers::pi / 180.0;
const Eigen::Vector3d kTrunkComDeviation_m(0.006, 0.004, 0.006);
constexpr double kPlayDeviation = 0.5;       // ± uniform, of a joint's play
constexpr double kSoleTimeDeviation = 0.4;   // ± uniform, of a contact's time constant: rubber hard or soft
constexpr double kLeastSoleTime = 0.1;       // of the described one
constexpr std::ptrdiff_t kWrenchValues = 6;  // of a foot, in sensordata
constexpr double kFallenTilt_rad = 50.0 * std::numbers::pi / 180.0;
constexpr double kFallenHeight = 0.2 / 0.36;  // of the hips' height in the stand

ModelMismatch draw_mismatch(const urdf::RobotModel& robot, facts::RandomStream& random,
                            facts::RandomStream& build_random, double scale) {
  ModelMismatch mismatch;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    mismatch.mass_factor.push_back(std::max(0.1, 1.0 + scale * kMassDeviation * random.normal()));
  }
  const double larger = robot.body_scale().factor("m");
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    mismatch.trunk_com_offset_m[axis] = scale * larger * kTrunkComDeviation_m[axis] * random.normal();
  }
  const auto factor = [&](double deviation) {
    return 1.0 + scale * robot.parts_deviation * deviation * (2.0 * build_random.uniform() - 1.0);
  };
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    mismatch.play_factor.push_back(std::max(0.0, factor(kPlayDeviation)));
  }
  for (double& sole : mismatch.sole_time_factor) {
    sole = std::max(0.5 * (1.0 + kLeastSoleTime), factor(kSoleTimeDeviation));
  }
  return mismatch;
}

// Velocity of a body-fixed point and the body's angular velocity, in the world.
struct PointVelocity {
  Eigen::Vector3d linear, angular;
};
PointVelocity point_velocity(const mjModel& model, const mjData& data, int body,
                             const Eigen::Vector3d& point_m) {
  double velocity[6];
  mj_objectVelocity(&model, &data, mjOBJ_XBODY, body, velocity, 0);  // angular, linear; at the body's origin
  PointVelocity result;
  result.angular = Eigen::Map<const Eigen::Vector3d>(velocity);
  const Eigen::Vector3d arm =
      point_m - Eigen::Map<const Eigen::Vector3d>(data.xpos + std::ptrdiff_t{3} * body);
  result.linear = Eigen::Map<const Eigen::Vector3d>(velocity + 3) + result.angular.cross(arm);
  return result;
}

}  // namespace

std::vector<int> bodies_of_things(const mjModel& model, const std::optional<world::World>& world) {
  std::vector<int> bodies;
  for (std::size_t i = 0; world && i < world->things.size(); ++i) {
    bodies.push_back(mj_name2id(&model, mjOBJ_BODY, world_name(world->things[i].solid).c_str()));
  }
  return bodies;
}

Plant::Implementation::Implementation(const urdf::RobotModel& description, const PlantOptions& options)
    : robot(description),
      mismatch_random(options.seed, 0x6D69'736D'6174'6368ULL),
      build_random(options.seed, 0x6275'696C'6400'0000ULL),
      noise_random(options.seed, 0x6E6F'6973'6500'0000ULL),
      condition_random(options.seed, 0x636F'6E64'6974'696FULL),
      noise(options.sensor_noise),
      mismatch(draw_mismatch(robot, mismatch_random, build_random, options.mismatch)),
      conditions(options.conditions),
      ground(ground_rotation(options.conditions.ground)),
      world(options.world),
      world_ground(world ? std::optional<WorldGround>(*world) : std::nullopt),
      model(build_physics_model(robot, mismatch, options.conditions, world)),
      imu_model(options.seed, options.mismatch * robot.parts_deviation, model->opt.timestep),
      tiles(*model, options.conditions.ground, options.seed),
      data(mj_makeData(model.get())),
      foot_body{robot.feet[0].link + 1, robot.feet[1].link + 1},
      trunk_body(robot.imu.link + 1),
      contacts(*model, robot, world),
      motors(robot, options.seed, options.mismatch * robot.parts_deviation,
             options.sensor_noise && robot.parts_deviation > 0.0),
      servos(draw_servo_factors(robot, options.seed, options.mismatch * robot.parts_deviation)),
      motor_speed_rad_per_s(robot.joints.size(), 0.0) {
  if (world) require_plain_ground(options.conditions.ground, *world);
  for (const urdf::Joint& joint : robot.joints) {
    const int hinge = mj_name2id(model.get(), mjOBJ_JOINT, joint.name.c_str());
    position_address.push_back(model->jnt_qposadr[hinge]);
    velocity_address.push_back(model->jnt_dofadr[hinge]);
    zero_error_rad.push_back(options.mismatch * kZeroDeviation_rad * mismatch_random.normal());
  }
  set_drawn(*model);
  thing_body = bodies_of_things(*model, world);
  own_surfaces = world ? world->surfaces.size() : 0;
  set_home(options.start_rad);
  draw_sensor_faults();
  tiles.follow(*model, Eigen::Map<const Eigen::Vector3d>(home.data()));
  sensors.encoder_count.assign(robot.joints.size(), 0);
  sensors.motor_torque_Nm.assign(robot.joints.size(), 0.0);
  sensors.motor_current_Nm.assign(motors.sensed_Nm().begin(), motors.sensed_Nm().end());
  reset(data.get());
  if (world) require_room(*model, *data, contacts, *world, robot);
  contacts.read(*model, *data);
  mj_step1(model.get(), data.get());
  read_sensors(true);
}

void Plant::Implementation::draw_sensor_faults() {
  for (double& bias : gyro_bias_rad_per_s) {
    bias = conditions.body.gyro_bias_deviation_rad_per_s * condition_random.normal();
  }
  for (auto& foot : cell_gain) {
    for (double& gain : foot) gain = 1.0 + conditions.body.cell_gain_deviation * condition_random.normal();
  }
  if (conditions.body.dead_cell)
    cell_gain[static_cast<std::size_t>(conditions.body.dead_cell->foot)][conditions.body.dead_cell->cell] =
        0.0;
}

void Plant::Implementation::reset(mjData* state) const {
  mj_resetData(model.get(), state);
  std::ranges::copy(home, state->qpos);
  mj_forward(model.get(), state);
}

void Plant::Implementation::apply_pushes() {
  for (ActivePush& push : pushes) {
    Eigen::Map<Eigen::Vector3d> applied(data->xfrc_applied + std::ptrdiff_t{6} * push.body);
    applied.setZero();
  }
  std::erase_if(pushes, [](const ActivePush& push) { return push.remaining_steps == 0; });
  for (ActivePush& push : pushes) {
    Eigen::Map<Eigen::Vector3d>(data->xfrc_applied + std::ptrdiff_t{6} * push.body) += push.force_N;
    --push.remaining_steps;
  }
}

void Plant::Implementation::read_sensors(bool first) {
  const auto normal = [this] { return noise ? noise_random.quick_normal() : 0.0; };
  const urdf::SensorNoise& sigma = robot.noise;
  const Eigen::Vector3d gravity(0.0, 0.0, -facts::kGravity_m_per_s2);
  const Eigen::Isometry3d imu = body_pose(*data, trunk_body) * robot.imu.pose;
  const Eigen::Matrix3d axes = imu.linear() * imu_model.mounting();
  const PointVelocity motion = point_velocity(*model, *data, trunk_body, imu.translation());
  const auto specific_force = [&](std::size_t which, const Eigen::Vector3d& velocity,
                                  const Eigen::Matrix3d& rotation) -> Eigen::Vector3d {
    const Eigen::Vector3d acceleration =
        first ? Eigen::Vector3d::Zero().eval()
              : ((velocity - last_velocity_m_per_s[which]) / model->opt.timestep).eval();
    last_velocity_m_per_s[which] = velocity;
    return rotation.transpose() * (acceleration - gravity);
  };
  const Eigen::Vector3d force = specific_force(0, motion.linear, axes);
  if (first) imu_model.settle(force);
  const ImuModel::Reading read = imu_model.step(axes.transpose() * motion.angular, force);
  sensors.acceleration_m_per_s2 = read.acceleration_m_per_s2;
  sensors.angular_velocity_rad_per_s = read.angular_velocity_rad_per_s;
  sensors.inclination_rad = robot.imu.inclinometer == urdf::Inclinometer::pendulum
                                ? read.inclination_rad
                                : geometry::tilt_at_rest(imu.linear().row(2));
  for (double& value : sensors.acceleration_m_per_s2) value += sigma.acceleration_m_per_s2 * normal();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    sensors.angular_velocity_rad_per_s[axis] +=
        gyro_bias_rad_per_s[axis] + sigma.angular_velocity_rad_per_s * normal();
  }
  for (double& value : sensors.inclination_rad) value += sigma.inclination_rad * normal();
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const PointVelocity velocity =
        point_velocity(*model, *data, foot_body[foot], contacts.ground().sole[foot].translation());
    sensors.foot_acceleration_m_per_s2[foot] =
        specific_force(1 + foot, velocity.linear, contacts.ground().sole[foot].linear());
    for (double& value : sensors.foot_acceleration_m_per_s2[foot])
      value += sigma.acceleration_m_per_s2 * normal();
    read_foot(foot);
    for (double& cell_N : sensors.force_N[foot]) {
      cell_N += sigma.force_N * normal();
    }
    if (robot.feet[foot].sensor == urdf::FootSensor::six_axis) read_wrench(foot);
  }
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const double angle = data->qpos[position_address[j]] + zero_error_rad[j];
    sensors.encoder_count[j] =
        static_cast<std::int32_t>(std::lround(angle / robot.joints[j].encoder_count_rad));
  }
}

void Plant::Implementation::read_foot(std::size_t foot) {
  const double force = contacts.ground().normal_force_N[foot];
  const std::array<double, 4> on_cell_N =
      force > 0.0 ? robot.feet[foot].cell_forces_N(force, contacts.ground().foot_cop_m[foot])
                  : std::array<double, 4>{};
  for (std::size_t i = 0; i < on_cell_N.size(); ++i) {
    sensors.force_N[foot][i] = cell_gain[foot][i] * on_cell_N[i];
  }
}

// What hangs on the sensor, as its electronics is told while the foot hangs level.
urdf::Wrench Plant::Implementation::weight_on_sensor(std::size_t foot) const {
  const urdf::Foot& described = robot.feet[foot];
  const std::ptrdiff_t body = foot_body[foot];
  const Eigen::Vector3d com_m = Eigen::Map<const Eigen::Vector3d>(model->body_ipos + 3 * body);
  const Eigen::Vector3d weight_N =
      described.sole.linear() * Eigen::Vector3d(0.0, 0.0, -facts::kGravity_m_per_s2 * model->body_mass[body]);
  const Eigen::Matrix3d turn = described.sensor_pose.linear().transpose();
  urdf::Wrench wrench;
  wrench << turn * weight_N, turn * (com_m - described.sensor_pose.translation()).cross(weight_N);
  return wrench;
}

void Plant::Implementation::read_wrench(std::size_t foot) {
  const double* const sensed = data->sensordata + kWrenchValues * static_cast<std::ptrdiff_t>(foot);
  // MuJoCo tells what the leg does to the foot.
  sensors.foot_wrench[foot] = -Eigen::Map<const urdf::Wrench>(sensed) - weight_on_sensor(foot);
  for (Eigen::Index i = 0; i < 6; ++i) {
    const double sigma = i < 3 ? robot.noise.force_N : robot.noise.torque_Nm;
    sensors.foot_wrench[foot][i] += noise ? sigma * noise_random.quick_normal() : 0.0;
  }
}

Plant::Plant(const urdf::RobotModel& robot, const PlantOptions& options)
    : implementation_(std::make_unique<Implementation>(robot, options)) {}
Plant::~Plant() = default;
Plant::Plant(Plant&&) noexcept = default;
Plant& Plant::operator=(Plant&&) noexcept = default;

void Plant::step(std::span<const double> command_Nm) {
  Implementation& self = *implementation_;
  self.apply_motors(command_Nm);
  self.apply_pushes();
  self.tiles.follow(*self.model, Eigen::Map<const Eigen::Vector3d>(self.data->qpos));
  // mj_step in two halves: forces and integration, then poses and velocities of the new state. In between,
  // contact points and the forces in them belong together.
  mj_step2(self.model.get(), self.data.get());
  self.contacts.read(*self.model, *self.data);
  mj_step1(self.model.get(), self.data.get());
  self.read_sensors(false);
}

const PlantSensors& Plant::sensors() const noexcept {
  return implementation_->sensors;
}
const GroundContact& Plant::ground_contact() const noexcept {
  return implementation_->contacts.ground();
}
std::span<const BodyContact> Plant::body_contacts() const noexcept {
  return implementation_->contacts.body();
}
const std::optional<world::World>& Plant::world() const noexcept {
  return implementation_->world;
}

std::vector<world::Solid> Plant::solids() const {
  const Implementation& self = *implementation_;
  if (!self.world) return {};
  std::vector<world::Solid> all = self.world->all_solids(true);
  for (std::size_t i = 0; i < self.thing_body.size(); ++i) {
    all[self.world->solids.size() + i].pose = body_pose(*self.data, self.thing_body[i]);
  }
  return all;
}
double Plant::time_s() const noexcept {
  return implementation_->data->time;
}

std::span<const double> Plant::positions() const noexcept {
  return {implementation_->data->qpos, static_cast<std::size_t>(implementation_->model->nq)};
}
std::span<const double> Plant::velocities() const noexcept {
  return {implementation_->data->qvel, static_cast<std::size_t>(implementation_->model->nv)};
}

PlantTruth Plant::truth() const {
  const Implementation& self = *implementation_;
  PlantTruth truth;
  truth.base = body_pose(*self.data, 1);
  truth.com_m = Eigen::Map<const Eigen::Vector3d>(self.data->subtree_com + 3);
  truth.trunk = body_pose(*self.data, self.trunk_body);
  truth.trunk_tilt_rad = std::acos(std::clamp(truth.trunk.linear()(2, 2), -1.0, 1.0));
  double force = 0.0;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const Eigen::Vector2d& cop = self.contacts.ground().foot_cop_m[foot];
    force += self.contacts.ground().normal_force_N[foot];
    truth.cop_m += self.contacts.ground().normal_force_N[foot] *
                   (self.contacts.ground().sole[foot] * Eigen::Vector3d(cop.x(), cop.y(), 0.0));
  }
  if (force > 0.0) {
    truth.cop_m /= force;
  }
  return truth;
}

BodyTruth Plant::body_truth() const {
  const Implementation& self = *implementation_;
  BodyTruth truth{.encoder_zero_rad = self.zero_error_rad,
                  .trunk_com_offset_m = self.mismatch.trunk_com_offset_m,
                  .play_factor = self.mismatch.play_factor,
                  .sole_time_factor = self.mismatch.sole_time_factor,
                  .link_mass_kg = {},
                  .cell_gain = self.cell_gain,
                  .gyro_bias_rad_per_s = self.gyro_bias_rad_per_s + self.imu_model.walked_bias_rad_per_s(),
                  .imu = self.imu_model.truth(),
                  .joints = self.joint_truth()};
  const std::span<const double> masses(self.model->body_mass,
                                       self.robot.links.size() + 1);  // the world first
  truth.link_mass_kg.assign(masses.begin() + 1, masses.end());
  return truth;
}

bool Plant::fallen() const noexcept {
  const Implementation& self = *implementation_;
  const mjData& data = *self.data;
  const Eigen::Vector3d base = Eigen::Map<const Eigen::Vector3d>(data.xpos + 3);
  const double enough_m = kFallenHeight * self.robot.hip_height_m;
  const double height_m =
      self.world ? self.world_ground->height_above_m(base, enough_m) : (self.ground.inverse() * base).z();
  // Asked the other way round, so that a state that is not a number counts as fallen.
  const bool up = data.xmat[9 * self.trunk_body + 8] >= std::cos(kFallenTilt_rad);
  return !(up && height_m >= enough_m);
}

void Plant::push(std::string_view body, const Eigen::Vector3d& direction, double impulse_Ns,
                 double duration_s) {
  Implementation& self = *implementation_;
  int id = mj_name2id(self.model.get(), mjOBJ_BODY, std::string(body).c_str());
  if (id < 0) id = mj_name2id(self.model.get(), mjOBJ_BODY, ("world/" + std::string(body)).c_str());
  if (id <= 0) {
    throw std::invalid_argument("push: the robot has no body '" + std::string(body) + "'");
  }
  const double length = direction.norm();
  if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(impulse_Ns) || !(duration_s > 0.0) ||
      !std::isfinite(duration_s)) {
    throw std::invalid_argument(
        "push on '" + std::string(body) +
        "': direction must not be zero, duration must be > 0 s, and all must be finite");
  }
  const long steps = std::max(1L, std::lround(duration_s / self.model->opt.timestep));
  const double force_N = impulse_Ns / (static_cast<double>(steps) * self.model->opt.timestep);
  self.pushes.push_back({id, direction / length * force_N, steps});
}

void Plant::weaken_motors(double torque_factor, double duration_s) {
  if (!(torque_factor >= 0.0 && torque_factor <= 1.0) || !(duration_s > 0.0) || !std::isfinite(duration_s)) {
    throw std::invalid_argument(
        "motors that are weakened: the factor must be within 0 and 1, the duration > 0 s and finite");
  }
  Implementation& self = *implementation_;
  self.supply_factor = torque_factor;
  self.sagging_steps = std::max(1L, std::lround(duration_s / self.model->opt.timestep));
}

Replay Plant::replay(std::span<const float> applied_torque_Nm) const {
  const Implementation& self = *implementation_;
  const DataPointer data(mj_makeData(self.model.get()));
  self.reset(data.get());
  const std::size_t joints = self.robot.joints.size();
  if (applied_torque_Nm.size() % joints != 0) {
    throw std::invalid_argument(self.robot.name + ": a replay takes whole rows of " + std::to_string(joints) +
                                " joint torques; " + std::to_string(applied_torque_Nm.size()) +
                                " values are not");
  }
  const auto started = std::chrono::steady_clock::now();
  for (std::size_t row = 0; row < applied_torque_Nm.size(); row += joints) {
    for (std::size_t j = 0; j < joints; ++j) {
      data->qfrc_applied[self.velocity_address[j]] = static_cast<double>(applied_torque_Nm[row + j]);
    }
    mj_step(self.model.get(), data.get());
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - started;
  return {.wall_s = wall.count(), .positions = {data->qpos, data->qpos + self.model->nq}};
}

double Plant::replay_wall_s(std::span<const float> applied_torque_Nm) const {
  return replay(applied_torque_Nm).wall_s;
}

}  // namespace gaitway::simulator
