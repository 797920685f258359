// The simulated robot plays a plan: its joints' servos follow the points, as a local controller does.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/body_load.hpp"
#include "gaitway/simulator/plant.hpp"

namespace gaitway::motion {

struct Performance {
  bool fallen = false;
  double tilt_at_end_rad = 0.0;     // of the trunk
  double end_offset_m = 0.0;        // of the pelvis from where it stood, in the plane
  double worst_tracking_rad = 0.0;  // of any joint against its planned angle
  double zmp_error_rms_m = 0.0;     // of the measured centre of pressure against the planned ZMP
};

// What a servo asks of its motor on the straight line from one point to the next.
inline double servo_torque_Nm(const simulator::Plant& plant, const urdf::Joint& joint, std::size_t index,
                              double from_rad, double to_rad, double share) {
  const double error =
      from_rad + share * (to_rad - from_rad) - plant.sensors().encoder_count[index] * joint.encoder_count_rad;
  return joint.servo.stiffness_Nm_per_rad * error +
         joint.servo.damping_Nms_per_rad *
             ((to_rad - from_rad) / facts::kSlot_s - plant.velocities()[6 + index]);
}

// One point: the references go straight from one row to the other.
inline void play_point(simulator::Plant& plant, const urdf::RobotModel& robot, std::span<const double> from,
                       std::span<const double> to) {
  std::vector<double> torque(robot.joints.size());
  const int steps = static_cast<int>(std::lround(facts::kSlot_s / robot.physics_step_s));
  for (int step = 1; step <= steps; ++step) {
    const double share = static_cast<double>(step) / steps;
    for (std::size_t j = 0; j < torque.size(); ++j) {
      torque[j] = servo_torque_Nm(plant, robot.joints[j], j, from[j], to[j], share);
    }
    plant.step(torque);
  }
}

// The whole plan on a robot in any state, and its last point for `settle_s`.
inline void play(simulator::Plant& plant, const urdf::RobotModel& robot, const MotionPlan& plan,
                 double settle_s) {
  const std::size_t last = plan.point_count() - 1;
  const std::size_t end = last + static_cast<std::size_t>(settle_s / facts::kSlot_s);
  for (std::size_t i = 0; i < end; ++i) {
    play_point(plant, robot, plan.reference(std::min(i, last)), plan.reference(std::min(i + 1, last)));
  }
}

// Pushed over forwards or backwards while it stands, as hard as its size takes, then put into `lying_rad`.
inline void fall(simulator::Plant& plant, const urdf::RobotModel& robot, double direction,
                 std::span<const double> lying_rad) {
  const facts::BodyScale scale = robot.body_scale();
  const auto points = [&scale](double of_humanoid22) {
    return static_cast<int>(std::lround(of_humanoid22 * scale.factor("s")));
  };
  const int stiff_points = points(70), going_points = points(50), lying_points = points(50);
  std::vector<double> home, before, after;
  for (const urdf::Joint& joint : robot.joints) home.push_back(joint.home_rad);
  before = after = home;
  plant.push(robot.links[static_cast<std::size_t>(robot.imu.link)].name, {direction, 0.0, 0.0},
             7.0 * scale.factor("N*s"), 0.1);
  for (int i = 0; i < stiff_points; ++i) play_point(plant, robot, home, home);
  for (int i = 0; i < going_points; ++i) {
    for (std::size_t j = 0; j < home.size(); ++j) {
      before[j] = std::lerp(home[j], lying_rad[j], static_cast<double>(i) / going_points);
      after[j] = std::lerp(home[j], lying_rad[j], static_cast<double>(i + 1) / going_points);
    }
    play_point(plant, robot, before, after);
  }
  for (int i = 0; i < lying_points; ++i) play_point(plant, robot, lying_rad, lying_rad);
}

// Holds the last point for `settle_s`.
inline Performance perform(const urdf::RobotModel& robot, const MotionPlan& plan, double settle_s = 1.0,
                           const simulator::PlantOptions& options = {.mismatch = 0.0,
                                                                     .sensor_noise = false}) {
  simulator::Plant plant(robot, options);
  Performance result;
  const auto soles_middle = [&plant] {
    const auto& sole = plant.ground_contact().sole;
    return Eigen::Vector2d(0.5 * (sole[0].translation() + sole[1].translation()).head<2>());
  };
  const Eigen::Vector2d origin = soles_middle();
  const Eigen::Vector3d start = plant.truth().base.translation();
  std::vector<double> torque(robot.joints.size());
  const int steps_in_point = static_cast<int>(std::lround(facts::kSlot_s / robot.physics_step_s));
  const std::size_t last = plan.point_count() - 1;
  const std::size_t end = last + static_cast<std::size_t>(settle_s / facts::kSlot_s);
  PlanLoads loads(robot, plan);
  double zmp_error = 0.0;
  for (std::size_t i = 0; i < end && !result.fallen; ++i) {
    const std::span<const double> from = plan.reference(std::min(i, last)),
                                  to = plan.reference(std::min(i + 1, last));
    Eigen::Vector2d pressure = Eigen::Vector2d::Zero();
    for (int step = 1; step <= steps_in_point; ++step) {
      for (std::size_t j = 0; j < torque.size(); ++j) {
        const double share = static_cast<double>(step) / steps_in_point;
        torque[j] = servo_torque_Nm(plant, robot.joints[j], j, from[j], to[j], share);
      }
      plant.step(torque);
      pressure += plant.truth().cop_m.head<2>() / steps_in_point;
    }
    for (std::size_t j = 0; j < torque.size(); ++j) {
      const double angle = plant.sensors().encoder_count[j] * robot.joints[j].encoder_count_rad;
      result.worst_tracking_rad =
          std::max(result.worst_tracking_rad, std::abs(plan.point(std::min(i + 1, last))[j] - angle));
    }
    if (i < last) zmp_error += (pressure - origin - loads.at(i).zmp_m).squaredNorm();
    result.fallen = plant.fallen();
  }
  result.zmp_error_rms_m = std::sqrt(zmp_error / static_cast<double>(last));
  result.end_offset_m = (plant.truth().base.translation() - start).head<2>().norm();
  result.tilt_at_end_rad = plant.truth().trunk_tilt_rad;
  return result;
}

}  // namespace gaitway::motion
