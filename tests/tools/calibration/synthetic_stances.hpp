// Robots with known deviations that stand as the poses say, by inverse kinematics and the forces' balance
// alone: every error of a measurement is drawn as the settings say.
#pragma once

#include <random>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/tilt.hpp"
#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/motion_path.hpp"
#include "gaitway/motion/stance_map.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "tools/calibrate/calibration_estimator.hpp"

namespace gaitway::calibration {

class SyntheticStances {
 public:
  static constexpr double kForceDeviation_N = 0.01, kTiltDeviation_rad = 1e-4;
  static constexpr double kGravity_m_per_s2 = facts::kGravity_m_per_s2;

  SyntheticStances(const urdf::RobotModel& robot, const motion::Motion& poses)
      : robot_(robot), poses_(poses), postures_(motion::key_postures(robot, poses, {})), map_(robot) {}

  // Draws a robot.
  RobotDeviations draw(std::mt19937_64& random, const ManufacturingDeviations& sigma) const {
    RobotDeviations drawn = no_deviations(robot_);
    for (double& zero : drawn.zero_rad) zero = sigma.joint_zero_rad * normal(random);
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      drawn.trunk_com_offset_m[axis] = sigma.trunk_com_m[axis] * normal(random);
    }
    for (double& factor : drawn.mass_factor) factor += sigma.link_mass * normal(random);
    for (auto& foot : drawn.cell_gain) {
      for (double& gain : foot) gain += sigma.cell_gain * normal(random);
    }
    Eigen::Vector<double, kImuUnknowns> imu;
    for (double& unknown : imu) unknown = normal(random);
    drawn.imu = imu_errors(sigma.imu, imu);
    return drawn;
  }

  // It takes all poses but the last, which only ends the motion.
  std::vector<StandingMeasurement> measure(const RobotDeviations& truth, const CalibrationSettings& settings,
                                           std::mt19937_64& random) {
    std::vector<StandingMeasurement> result;
    for (std::size_t key = 0; key + 1 < poses_.keys.size(); ++key) {
      result.push_back(pose(postures_[key + 1], truth, settings.standing, random));
      result.back().pose = poses_.keys[key].name;
    }
    return result;
  }

 private:
  static double normal(std::mt19937_64& random) { return std::normal_distribution<double>()(random); }

  StandingMeasurement pose(const motion::KeyPosture& posture, const RobotDeviations& truth,
                           const StandingDeviations& sigma, std::mt19937_64& random) {
    Eigen::VectorXd stance = *posture.stance, joint_rad = posture.joint_rad;
    const Eigen::Index right = motion::StanceMap::kSole[1];
    stance[right] += sigma.creep_ahead_m * normal(random);
    stance[right + 1] += sigma.creep_aside_m * normal(random);
    stance[right + 2] += sigma.sole_height_m * normal(random);
    stance[right + 5] += sigma.creep_rad * normal(random);
    for (const Eigen::Index sole : motion::StanceMap::kSole) {
      for (Eigen::Index axis = 3; axis < 5; ++axis)
        stance[sole + axis] += sigma.sole_tilt_rad * normal(random);
    }
    EXPECT_EQ(map_.joints(stance, joint_rad), 0.0);
    const Eigen::Isometry3d base = motion::pose_at(stance, motion::StanceMap::kPelvis);
    urdf::ForwardKinematics kinematics(robot_);
    kinematics.compute({joint_rad.data(), static_cast<std::size_t>(joint_rad.size())});

    StandingMeasurement measured;
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
      measured.joint_rad.push_back(joint_rad[static_cast<Eigen::Index>(j)] + truth.zero_rad[j] +
                                   sigma.joint_rad * normal(random));
    }
    feel_gravity((base.linear() * kinematics.link_rotation(robot_.imu.link)).row(2), truth, random, measured);
    balance(base, kinematics, truth, sigma, random, measured);
    return measured;
  }

  void feel_gravity(const Eigen::Vector3d& up_in_trunk, const RobotDeviations& truth, std::mt19937_64& random,
                    StandingMeasurement& measured) const {
    const double force_noise = kGravity_m_per_s2 * kTiltDeviation_rad;
    measured.specific_force_m_per_s2 =
        kGravity_m_per_s2 *
        geometry::up_at_tilt(tilt_said(ImuSensor::accelerometer, robot_.imu, truth.imu, up_in_trunk));
    measured.specific_force_deviation_m_per_s2.setConstant(force_noise);
    for (double& value : measured.specific_force_m_per_s2) value += force_noise * normal(random);
    measured.inclination_rad = tilt_said(ImuSensor::inclinometer, robot_.imu, truth.imu, up_in_trunk);
    measured.inclination_deviation_rad.setConstant(kTiltDeviation_rad);
    for (double& value : *measured.inclination_rad) value += kTiltDeviation_rad * normal(random);
  }

  // The centre of pressure is below the CoM; the feet share the load by where it lies between them.
  void balance(const Eigen::Isometry3d& base, const urdf::ForwardKinematics& kinematics,
               const RobotDeviations& truth, const StandingDeviations& sigma, std::mt19937_64& random,
               StandingMeasurement& measured) const {
    const double mass_kg = total_mass_kg(robot_, truth);
    Eigen::Vector3d com = Eigen::Vector3d::Zero();
    for (std::size_t link = 0; link < robot_.links.size(); ++link) {
      const int index = static_cast<int>(link);
      Eigen::Vector3d own = robot_.links[link].com_m;
      if (index == robot_.imu.link) own += truth.trunk_com_offset_m;
      com += truth.mass_factor[link] * robot_.links[link].mass_kg / mass_kg *
             (base * (kinematics.link_pose(index) * own));
    }
    std::array<Eigen::Isometry3d, 2> sole;
    for (const urdf::Side side : urdf::kSides) {
      sole[static_cast<std::size_t>(side)] = base * kinematics.sole_pose(side);
    }
    const Eigen::Vector2d left = sole[0].translation().head<2>(), right = sole[1].translation().head<2>();
    const double share = (com.head<2>() - left).dot(right - left) / (right - left).squaredNorm();
    const Eigen::Vector2d off =
        com.head<2>() - (left + share * (right - left));  // beside the line of the feet
    for (std::size_t side = 0; side < 2; ++side) {
      const double force_N = mass_kg * kGravity_m_per_s2 * (side == 0 ? 1.0 - share : share);
      const Eigen::Vector3d at =
          sole[side].inverse() * (sole[side].translation() + Eigen::Vector3d(off.x(), off.y(), 0.0));
      load(side, force_N, at.head<2>(), truth, sigma, random, measured);
    }
  }

  // A rigid plate on four springs.
  void load(std::size_t side, double force_N, const Eigen::Vector2d& pressure, const RobotDeviations& truth,
            const StandingDeviations& sigma, std::mt19937_64& random, StandingMeasurement& measured) const {
    const urdf::Foot& foot = robot_.feet[side];
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Eigen::Vector2d& cell : foot.cell_m) {
      spread += (cell - foot.centre_m) * (cell - foot.centre_m).transpose();
    }
    const Eigen::Vector2d slope = spread.inverse() * (force_N * (pressure - foot.centre_m));
    const double uneven_N = sigma.plate_unevenness * force_N * normal(random) / 4.0;
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      const double warp = cell == 0 || cell == 3 ? uneven_N : -uneven_N;
      const double on_cell_N = force_N / 4.0 + slope.dot(foot.cell_m[cell] - foot.centre_m) + warp;
      measured.force_N[side][cell] =
          truth.cell_gain[side][cell] * on_cell_N + kForceDeviation_N * normal(random);
      measured.force_deviation_N[side][cell] = kForceDeviation_N;
    }
  }

  const urdf::RobotModel& robot_;
  motion::Motion poses_;
  std::vector<motion::KeyPosture> postures_;
  motion::StanceMap map_;
};

}  // namespace gaitway::calibration
