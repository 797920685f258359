// Draws a robot, lets it take the poses, and asks it for its deviations in the end.
#include "tools/calibrate/simulated_calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/leg_joints.hpp"
#include "tools/calibrate/standing_measurement.hpp"

namespace gaitway::calibration {
namespace {

constexpr double kZeroBlend_s = 0.5;
// Ankles' speed for each metre between where the two soles press.
constexpr double kRelaxing_rad_per_s_m = 0.7;
constexpr double kMostRelaxed_rad = 0.06;
constexpr double kLoaded_N = 5.0;

}  // namespace

PosePerformer::PosePerformer(const urdf::RobotModel& robot, simulator::Plant& plant, double measured_s)
    : robot_(robot),
      plant_(plant),
      measured_s_(measured_s),
      zero_rad_(robot.joints.size(), 0.0),
      relaxed_rad_(robot.joints.size(), 0.0) {
  const std::vector<simulator::JointTruth> built = plant.body_truth().joints;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const urdf::Joint& joint = robot.joints[j];
    servos_.emplace_back(
        localcontroller::ServoGains{built[j].servo_stiffness_factor * joint.servo.stiffness_Nm_per_rad,
                                    built[j].servo_damping_factor * joint.servo.damping_Nms_per_rad,
                                    joint.motor.torque_limit_Nm, joint.motor.speed_limit_rad_per_s});
  }
  const urdf::ForwardKinematics home(robot);
  for (const urdf::Side side : urdf::kSides) {
    const urdf::LegJoints leg(robot, home, side);
    const int pitch = leg[urdf::LegJoint::ankle_pitch], roll = leg[urdf::LegJoint::ankle_roll];
    ankles_[urdf::index_of(side)] = {pitch, roll, home.joint_axis(robot, pitch).y(),
                                     home.joint_axis(robot, roll).x()};
  }
}

void PosePerformer::take(const simulator::PlantSensors& sensors, StandingReading& reading) const {
  std::vector<double> joint_rad(robot_.joints.size());
  for (std::size_t j = 0; j < joint_rad.size(); ++j) {
    joint_rad[j] = sensors.encoder_count[j] * robot_.joints[j].encoder_count_rad;
  }
  reading.take(joint_rad, robot_.imu.specific_force_in_link(sensors.acceleration_m_per_s2),
               robot_.imu.tilt_in_link(sensors.inclination_rad), sensors.force_N);
}

void PosePerformer::play_point(std::span<const double> from, std::span<const double> to,
                               StandingReading* reading) {
  const int steps = static_cast<int>(std::lround(facts::kSlot_s / robot_.physics_step_s));
  std::vector<double> torque_Nm(robot_.joints.size());
  moment_Nm_.fill(Eigen::Vector2d::Zero());
  force_N_.fill(0.0);
  for (int step = 1; step <= steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    for (std::size_t j = 0; j < torque_Nm.size(); ++j) {
      const double measured_rad =
          plant_.sensors().encoder_count[j] * robot_.joints[j].encoder_count_rad - zero_rad_[j];
      torque_Nm[j] = servos_[j].step(std::lerp(from[j], to[j], share) + relaxed_rad_[j],
                                     (to[j] - from[j]) / facts::kSlot_s, measured_rad, robot_.physics_step_s);
    }
    plant_.step(torque_Nm);
    if (reading != nullptr) take(plant_.sensors(), *reading);
    for (std::size_t side = 0; side < 2; ++side) {
      const urdf::Foot& foot = robot_.feet[side];
      for (std::size_t cell = 0; cell < kCells; ++cell) {
        const double cell_N = plant_.sensors().force_N[side][cell];
        force_N_[side] += cell_N;
        moment_Nm_[side] += cell_N * (foot.cell_m[cell] - foot.centre_m);
      }
    }
  }
}

void PosePerformer::relax_ankles() {
  const double steps = facts::kSlot_s / robot_.physics_step_s;
  if (std::min(force_N_[0], force_N_[1]) < kLoaded_N * steps) return;
  const Eigen::Vector2d apart = moment_Nm_[0] / force_N_[0] - moment_Nm_[1] / force_N_[1];
  const Eigen::Vector2d turn = 0.5 * kRelaxing_rad_per_s_m * facts::kSlot_s * apart;
  for (std::size_t side = 0; side < 2; ++side) {
    const double sign = side == 0 ? 1.0 : -1.0;
    // Toes down presses ahead, the left edge up presses to the right.
    const auto add = [this](int joint, double angle_rad) {
      double& relaxed = relaxed_rad_[static_cast<std::size_t>(joint)];
      relaxed = std::clamp(relaxed + angle_rad, -kMostRelaxed_rad, kMostRelaxed_rad);
    };
    add(ankles_[side].pitch, -sign * turn.x() * ankles_[side].pitch_about_y);
    add(ankles_[side].roll, sign * turn.y() * ankles_[side].roll_about_x);
  }
}

// Gently: a joint's zero is not to change faster than its reference would.
void PosePerformer::take_zeros(std::span<const double> posture, std::span<const double> zero_rad) {
  const std::vector<double> before = zero_rad_;
  const int points = static_cast<int>(std::lround(kZeroBlend_s / facts::kSlot_s));
  for (int point = 1; point <= points; ++point) {
    const double share = static_cast<double>(point) / points;
    for (std::size_t j = 0; j < zero_rad_.size(); ++j) {
      zero_rad_[j] = std::lerp(before[j], zero_rad[j], share);
    }
    play_point(posture, posture, nullptr);
    relax_ankles();
  }
}

std::vector<StandingMeasurement> PosePerformer::perform(
    const motion::MotionPlan& plan, std::span<const double> zero_rad,
    const std::function<void(const std::string&)>& progress) {
  const auto measured = static_cast<std::size_t>(std::lround(measured_s_ / facts::kSlot_s));
  take_zeros(plan.reference(0), zero_rad);
  std::vector<StandingMeasurement> poses;
  const int samples = static_cast<int>(std::lround(measured_s_ / robot_.physics_step_s));
  std::size_t point = 0;
  for (const motion::KeyTime& key : plan.keys) {
    const bool is_pose = key.left - key.reached >= measured;
    const std::size_t begin = is_pose ? key.left - measured : key.left;
    StandingReading reading(robot_.joints.size(), samples);
    for (; point < key.left; ++point) {
      if (plan.contact[point] != motion::Contact::both)
        placement_ += plan.contact[point - 1] == motion::Contact::both;
      const bool reads = point >= begin;
      play_point(plan.reference(point), plan.reference(point + 1), reads ? &reading : nullptr);
      if (!reads) relax_ankles();
      if (plant_.fallen()) {
        throw PerformanceError(
            fmt::format("the simulated robot fell on the way to pose '{}'. Choose poses "
                        "that are nearer to the middle of the feet",
                        key.name));
      }
    }
    if (!is_pose) continue;
    if (progress) progress(key.name);
    StandingMeasurement& pose = poses.emplace_back(reading.result());
    if (!robot_.carries(urdf::SensorKind::inclination)) pose.inclination_rad.reset();
    pose.pose = key.name;
    pose.placement = placement_;
    for (const urdf::Side side : urdf::kSides) {
      pose.stands[static_cast<std::size_t>(side)] = motion::stands_on(plan.contact[key.reached], side);
    }
  }
  return poses;
}

namespace {

constexpr double kCellGainDeviation = 0.03;
constexpr int kFewestRounds = 2;

simulator::PlantOptions plant_options(const SimulatedCalibrationOptions& options) {
  simulator::PlantOptions result{.seed = options.seed, .mismatch = options.mismatch};
  result.conditions.body.cell_gain_deviation = options.mismatch * kCellGainDeviation;
  result.conditions.body.backlash_rad = options.play_rad;
  return result;
}

ImuErrors imu_truth_of(const urdf::RobotModel& robot, const simulator::ImuTruth& imu) {
  const Eigen::AngleAxisd mounting(imu.mounting);
  ImuErrors errors{.mounting_rad = mounting.angle() * mounting.axis(),
                   .accelerometer_sensitivity = imu.accelerometer_sensitivity,
                   .accelerometer_zero_m_per_s2 = imu.accelerometer_zero_m_per_s2};
  if (robot.imu.inclinometer == urdf::Inclinometer::pendulum) {
    errors.inclinometer_zero_rad = imu.inclinometer_zero_rad;
    errors.inclinometer_cross_axis = imu.inclinometer_cross_axis;
  } else {  // a module of its own, which sits as it should
    errors.inclinometer_zero_rad =
        -tilt_said(ImuSensor::inclinometer, robot.imu, errors, Eigen::Vector3d::UnitZ());
  }
  return errors;
}

RobotDeviations truth_of(const urdf::RobotModel& robot, const simulator::Plant& plant) {
  const simulator::BodyTruth body = plant.body_truth();
  RobotDeviations truth{.zero_rad = body.encoder_zero_rad,
                        .trunk_com_offset_m = body.trunk_com_offset_m,
                        .mass_factor = {},
                        .cell_gain = body.cell_gain,
                        .imu = imu_truth_of(robot, body.imu)};
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    truth.mass_factor.push_back(body.link_mass_kg[link] / robot.links[link].mass_kg);
  }
  return truth;
}

}  // namespace

SimulatedCalibration calibrate_simulated(const urdf::RobotModel& robot, const motion::MotionPlan& poses,
                                         const SimulatedCalibrationOptions& options) {
  simulator::Plant plant(robot, plant_options(options));
  SimulatedCalibration result;
  result.truth = truth_of(robot, plant);
  if (options.play_rad > 0.0) allow_play(options.play_rad, result.settings.standing);
  if (options.weighing_deviation_kg) {
    std::mt19937_64 random(options.seed);
    std::normal_distribution<double> error(total_mass_kg(robot, result.truth),
                                           *options.weighing_deviation_kg);
    result.settings.weighing = Weighing{error(random), *options.weighing_deviation_kg};
  }
  PosePerformer performer(robot, plant, options.measured_s);
  std::vector<double> zero_rad(robot.joints.size(), 0.0);
  for (int round = 1; round <= options.rounds; ++round) {
    result.measurements = performer.perform(poses, zero_rad, [&](const std::string& pose) {
      if (options.progress) options.progress(round, pose);
    });
    result.calibration = calibrate(robot, result.measurements, result.settings);
    zero_rad = result.calibration.deviations.zero_rad;
    if (round >= kFewestRounds && result.calibration.feet_on_edge == 0) break;
  }
  return result;
}

}  // namespace gaitway::calibration
