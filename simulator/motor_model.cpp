// What motors, gears, supply and current sensors make of the torque that the servos ask for.
#include "motor_model.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::simulator {
namespace {

constexpr std::uint64_t kMotorStream = 0x6D6F'746F'7273'0000ULL;    // "motors"
constexpr std::uint64_t kCurrentStream = 0x6375'7272'656E'7400ULL;  // "current"
constexpr std::uint64_t kServoStream = 0x7365'7276'6F73'0000ULL;    // "servos"

// However large the mismatch: a motor remains a motor.
constexpr double kLeastFactor = 0.1;
constexpr double kLargestGearLoss = 0.5, kLargestDerating = 0.9, kLargestSag = 0.5;
constexpr double kMostFrictionOctaves = 3.0;

// The gear's loss is reckoned with the speed at the beginning of a step. As long as it takes no more than
// this share of a bare rotor's speed within the step, it damps and does not swing. Of rotors lighter than
// those of such robots it would take more; with the link behind them it does not.
constexpr double kLargestDampingOfAStep = 0.5;
constexpr double kSlowestGearShare = 1.0 / 80.0, kFastestGearShare = 0.25;  // of the speed limit

constexpr double kServoPeriod_s = static_cast<double>(facts::kMillisecond_ns) * 1e-9;
constexpr double kLargestServoDamping = 0.49;  // of a bare rotor's speed, in a servo period

// Uniform in ±1.
double either_way(facts::RandomStream& random) {
  return 2.0 * random.uniform() - 1.0;
}

double factor_around_one(facts::RandomStream& random, double spread) {
  return std::max(kLeastFactor, 1.0 + spread * either_way(random));
}

double gear_speed_rad_per_s(const urdf::Motor& motor, double largest_torque_Nm, double loss, double step_s) {
  const double slowest = kSlowestGearShare * motor.speed_limit_rad_per_s;
  const double fastest = kFastestGearShare * motor.speed_limit_rad_per_s;
  if (motor.armature_kg_m2 <= 0.0) return fastest;
  const double steady = loss * largest_torque_Nm * step_s / (kLargestDampingOfAStep * motor.armature_kg_m2);
  return std::clamp(steady, slowest, fastest);
}

}  // namespace

ServoFactors draw_servo_factors(const urdf::RobotModel& robot, std::uint64_t seed, double mismatch) {
  facts::RandomStream random(seed, kServoStream);
  const double common = mismatch * kMotorDeviations.servo_common;
  const double individual = mismatch * kMotorDeviations.servo_individual;
  const double all_stiffness = factor_around_one(random, common);
  const double all_damping = factor_around_one(random, common);
  ServoFactors factors;
  for (const urdf::Joint& joint : robot.joints) {
    factors.stiffness.push_back(all_stiffness * factor_around_one(random, individual));
    double damping = all_damping * factor_around_one(random, individual);
    const double described = joint.servo.damping_Nms_per_rad;
    if (described > 0.0 && joint.motor.armature_kg_m2 > 0.0) {
      const double bearable =
          kLargestServoDamping * joint.motor.armature_kg_m2 / (kServoPeriod_s * described);
      damping = std::min(damping, std::max(1.0, bearable));
    }
    factors.damping.push_back(damping);
  }
  return factors;
}

MotorModel::MotorModel(const urdf::RobotModel& robot, std::uint64_t seed, double mismatch, bool current_noise)
    : noise_random_(seed, kCurrentStream),
      current_noise_(current_noise),
      gear_loss_(std::min(kLargestGearLoss, mismatch * kMotorDeviations.gear_loss)),
      derating_depth_(std::min(kLargestDerating, mismatch * kMotorDeviations.derating_depth)),
      supply_sag_(std::min(kLargestSag, mismatch * kMotorDeviations.supply_sag)),
      heat_blend_(1.0 - std::exp(-robot.physics_step_s / kMotorConstants.thermal_time_s)),
      supply_blend_(1.0 - std::exp(-robot.physics_step_s / kMotorConstants.supply_time_s)) {
  facts::RandomStream random(seed, kMotorStream);
  draw(robot, random, mismatch);
  for (const urdf::Leg& leg : robot.legs) {
    for (const int index : leg.joints) {
      const Joint& joint = joints_[static_cast<std::size_t>(index)];
      const double share = kMotorConstants.reference_share;
      // Mechanical power, and copper losses as in step().
      reference_power_W_ += 2.0 * share * share * joint.torque_limit_Nm * joint.speed_limit_rad_per_s;
    }
  }
  heat_.assign(joints_.size(), 0.0);
  torque_Nm_.assign(joints_.size(), 0.0);
  for (const Joint& joint : joints_) sensed_Nm_.push_back(joint.current_offset_Nm);
}

void MotorModel::draw(const urdf::RobotModel& robot, facts::RandomStream& random, double mismatch) {
  const double octaves = std::min(kMostFrictionOctaves, mismatch * kMotorDeviations.friction_octaves);
  for (const urdf::Joint& source : robot.joints) {
    Joint joint;
    joint.torque_limit_Nm = source.motor.torque_limit_Nm;
    joint.speed_limit_rad_per_s = source.motor.speed_limit_rad_per_s;
    joint.torque_constant_factor = factor_around_one(random, mismatch * kMotorDeviations.torque_constant);
    joint.friction_factor = std::exp2(octaves * either_way(random));
    joint.damping_factor = std::exp2(octaves * either_way(random));
    joint.current_gain = factor_around_one(random, mismatch * kMotorDeviations.current_gain);
    joint.current_offset_Nm =
        mismatch * kMotorDeviations.current_offset * joint.torque_limit_Nm * random.normal();
    joint.gear_speed_rad_per_s = gear_speed_rad_per_s(
        source.motor, joint.torque_constant_factor * joint.torque_limit_Nm, gear_loss_, robot.physics_step_s);
    joints_.push_back(joint);
  }
}

// What the drive can put through the motor: limited by heat, and by what the supply's voltage leaves at this
// speed.
double MotorModel::current_torque_Nm(std::size_t joint, double asked_Nm, double speed_rad_per_s,
                                     double torque_factor) const noexcept {
  const Joint& motor = joints_[joint];
  const bool driving = asked_Nm * speed_rad_per_s > 0.0;
  const double fastest = voltage_ * motor.speed_limit_rad_per_s;
  const double fade = driving ? std::max(0.0, 1.0 - std::abs(speed_rad_per_s) / fastest) : 1.0;
  const double hot = std::clamp((heat_[joint] - kMotorConstants.derating_begins) /
                                    (kMotorConstants.derating_ends - kMotorConstants.derating_begins),
                                0.0, 1.0);
  const double limit = motor.torque_limit_Nm * torque_factor * fade * (1.0 - derating_depth_ * hot);
  return std::clamp(asked_Nm, -limit, limit);
}

// The loss is a part of the torque and always against the motion: it weakens what drives and helps what
// brakes.
double MotorModel::after_gear_Nm(const Joint& joint, double torque_Nm,
                                 double speed_rad_per_s) const noexcept {
  const double slow = joint.gear_speed_rad_per_s;
  const double direction = speed_rad_per_s / std::sqrt(speed_rad_per_s * speed_rad_per_s + slow * slow);
  return torque_Nm - gear_loss_ * std::abs(torque_Nm) * direction;
}

void MotorModel::step(std::span<const double> asked_Nm, std::span<const double> speed_rad_per_s,
                      double torque_factor) noexcept {
  double power_W = 0.0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const Joint& joint = joints_[j];
    const double speed = speed_rad_per_s[j];
    const double current_Nm = current_torque_Nm(j, asked_Nm[j], speed, torque_factor);
    torque_Nm_[j] = after_gear_Nm(joint, joint.torque_constant_factor * current_Nm, speed);
    const double load = current_Nm / joint.torque_limit_Nm;
    // At standstill all power is lost in the copper; the torque limit needs the whole voltage there.
    power_W += current_Nm * speed + load * load * joint.torque_limit_Nm * joint.speed_limit_rad_per_s;
    const double overload = load / kMotorConstants.continuous_share;
    heat_[j] += heat_blend_ * (overload * overload - heat_[j]);
    const double noise = current_noise_ ? noise_random_.quick_normal() : 0.0;
    sensed_Nm_[j] = joint.current_gain * current_Nm + joint.current_offset_Nm +
                    kMotorDeviations.current_noise * joint.torque_limit_Nm * noise;
  }
  // The supply takes nothing back: what brakes feeds what drives.
  const double sag =
      reference_power_W_ > 0.0 ? supply_sag_ * std::max(0.0, power_W) / reference_power_W_ : 0.0;
  voltage_ += supply_blend_ * (1.0 - std::min(sag, kLargestSag) - voltage_);
}

}  // namespace gaitway::simulator
