// The load of a leg against two other ways to it: the physics engine's standing robot, and Lagrange's
// equations.
#include "gaitway/kinematics/leg_load.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "gaitway/simulator/plant.hpp"

namespace gaitway::kinematics {
namespace {

using Angles = std::array<double, 6>;

const urdf::RobotModel kRobot = urdf::load_robot(GAITWAY_HUMANOID22_DIRECTORY);

const urdf::Joint& leg_joint(urdf::Side side, std::size_t i) {
  return kRobot.joints[static_cast<std::size_t>(kRobot.legs[static_cast<std::size_t>(side)].joints[i])];
}

// Servos hold the home posture; what their motors give must be the load of the leg under the ground's force.
TEST(LegLoad, IsWhatTheMotorsOfTheStandingRobotGive) {
  const urdf::RobotModel& robot = kRobot;
  simulator::Plant plant(robot, {.seed = 1, .mismatch = 0.0, .sensor_noise = false});
  std::vector<double> torque(robot.joints.size());
  for (int i = 0; i < 3000; ++i) {
    for (std::size_t j = 0; j < torque.size(); ++j) {
      const double angle = plant.sensors().encoder_count[j] * robot.joints[j].encoder_count_rad;
      torque[j] = robot.joints[j].servo.stiffness_Nm_per_rad * (robot.joints[j].home_rad - angle) -
                  robot.joints[j].servo.damping_Nms_per_rad * plant.velocities()[6 + j];
    }
    plant.step(torque);
  }
  for (const urdf::Side side : urdf::kSides) {
    const auto foot = static_cast<std::size_t>(side);
    Angles angle{};
    for (std::size_t i = 0; i < 6; ++i) {
      angle[i] = plant.positions()[7 + static_cast<std::size_t>(robot.legs[foot].joints[i])];
    }
    const LegLoad load(robot, side);
    const simulator::GroundContact& contact = plant.ground_contact();
    const Eigen::Vector2d& cop = contact.foot_cop_m[foot];
    GroundForce ground;
    ground.force_N.z() = contact.normal_force_N[foot];
    ground.point_m = contact.sole[foot] * Eigen::Vector3d(cop.x(), cop.y(), 0.0);
    std::array<Eigen::Vector3d, 6> still;
    still.fill(Eigen::Vector3d::Zero());
    const Angles needed = load.torque_Nm(load.places(plant.truth().base, angle), still, {}, {}, ground);
    for (const std::size_t i : {2U, 3U, 4U}) {  // the pitch axes; sideways the feet push against each other
      const auto joint = static_cast<std::size_t>(robot.legs[foot].joints[i]);
      // Dry friction bears what it can.
      EXPECT_NEAR(needed[i], plant.sensors().motor_torque_Nm[joint],
                  robot.joints[joint].motor.friction_Nm + 0.05)
          << robot.joints[joint].name;
    }
    EXPECT_GT(std::abs(needed[3]), 1.0) << "the bent knee bears half the robot";
  }
}

// tau = d/dt dT/dq' - d(T - V)/dq, all by differences, for point masses and rotors on a fixed base.
TEST(LegLoad, InTheAirFollowsLagrange) {
  const urdf::Side side = urdf::Side::right;
  const LegLoad load(kRobot, side);
  const Eigen::Isometry3d base = Eigen::Isometry3d::Identity();
  const auto angle_at = [](double t) {
    Angles q{};
    for (std::size_t i = 0; i < 6; ++i) {
      const double k = static_cast<double>(i);
      q[i] = 0.2 * k / 6.0 + 0.25 * std::sin((5.0 + k) * t + k);
    }
    return q;
  };
  constexpr double h = 1e-4;
  const auto rate_at = [&](double t) {
    Angles rate{};
    const Angles ahead = angle_at(t + h), behind = angle_at(t - h);
    for (std::size_t i = 0; i < 6; ++i) rate[i] = (ahead[i] - behind[i]) / (2.0 * h);
    return rate;
  };
  const auto lagrangian = [&](const Angles& q, const Angles& rate) {
    Angles ahead = q, behind = q;
    for (std::size_t i = 0; i < 6; ++i) {
      ahead[i] += h * rate[i];
      behind[i] -= h * rate[i];
    }
    const LegPlaces here = load.places(base, q), after = load.places(base, ahead),
                    before = load.places(base, behind);
    double value = 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
      const double mass = kRobot.links[static_cast<std::size_t>(leg_joint(side, i).child_link)].mass_kg;
      const Eigen::Vector3d velocity = (after.com_m[i] - before.com_m[i]) / (2.0 * h);
      value += 0.5 * mass * velocity.squaredNorm() - mass * 9.81 * here.com_m[i].z() +
               0.5 * leg_joint(side, i).motor.armature_kg_m2 * rate[i] * rate[i];
    }
    return value;
  };
  const auto slope = [&](Angles q, Angles rate, std::size_t i, bool of_rate) {
    constexpr double step = 1e-3;
    Angles& varied = of_rate ? rate : q;
    varied[i] += step;
    const double above = lagrangian(q, rate);
    varied[i] -= 2.0 * step;
    return (above - lagrangian(q, rate)) / (2.0 * step);
  };
  for (const double t : {0.0, 0.37, 1.1}) {
    constexpr double dt = 2e-3;
    const Angles rate = rate_at(t);
    Angles acceleration{};
    std::array<Eigen::Vector3d, 6> com_acceleration;
    const LegPlaces ahead = load.places(base, angle_at(t + dt)), here = load.places(base, angle_at(t)),
                    behind = load.places(base, angle_at(t - dt));
    for (std::size_t i = 0; i < 6; ++i) {
      acceleration[i] = (rate_at(t + dt)[i] - rate_at(t - dt)[i]) / (2.0 * dt);
      com_acceleration[i] = (ahead.com_m[i] - 2.0 * here.com_m[i] + behind.com_m[i]) / (dt * dt);
    }
    const Angles torque = load.torque_Nm(here, com_acceleration, rate, acceleration, {});
    for (std::size_t i = 0; i < 6; ++i) {
      const urdf::Motor& motor = leg_joint(side, i).motor;
      const double losses =
          motor.damping_Nms_per_rad * rate[i] + motor.friction_Nm * std::tanh(rate[i] / 0.2);
      const double momentum_rate = (slope(angle_at(t + dt), rate_at(t + dt), i, true) -
                                    slope(angle_at(t - dt), rate_at(t - dt), i, true)) /
                                   (2.0 * dt);
      EXPECT_NEAR(torque[i] - losses, momentum_rate - slope(angle_at(t), rate, i, false), 0.02)
          << leg_joint(side, i).name << " at " << t;
    }
  }
}

}  // namespace
}  // namespace gaitway::kinematics
