// In place of the state estimator: attitude from gyro and inclinometer, CoM from the encoders. No ZMP and no
// model of the pendulum.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/manager/fallback.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/neck.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::core {

// As plans and gains number them.
enum class Support : std::uint8_t { left, right, both };

// Contacts come from the foot forces while they are fresh, else from the support of the motion plan. `zmp` is
// the CoM's projection, `foot_zmp` the sole's centre: nothing is measured. Goes on from the last good
// estimate: yaw, roll and pitch at once, the CoM's difference fades.
class EstimateFallback final : public Fallback {
 public:
  explicit EstimateFallback(const FallbackSource& source);

  void follow(const Tick& tick) noexcept override;
  bool act(const Tick& tick, ManagedPlugin& through) noexcept override;

 private:
  void take_turn(const Tick& tick) noexcept;
  void begin(const Tick& tick) noexcept;
  void update_attitude() noexcept;
  void update_levels() noexcept;
  void update_contacts(const Tick& tick) noexcept;
  bool contacts_of_forces(const Tick& tick) noexcept;
  void contacts_of_plan(const Tick& tick) noexcept;
  void change_support(std::size_t to) noexcept;
  void update_com() noexcept;
  void write(const Tick& tick) noexcept;
  [[nodiscard]] std::optional<Eigen::Vector2d> measured_tilt() const noexcept;
  [[nodiscard]] Eigen::Vector3d com_seen_from(std::size_t foot) const noexcept;

  urdf::RobotModel robot_;
  urdf::ForwardKinematics kinematics_;
  urdf::Neck neck_;
  double slower_;  // than humanoid22: of its times
  double weight_N_;
  msgclient::Reader<JointStates> joint_reader_;
  msgclient::Reader<Imu> imu_reader_;
  msgclient::Reader<FootForces> force_reader_;
  msgclient::Reader<MotionPlan> plan_reader_;
  msgclient::Reader<Estimate> estimate_reader_;

  JointStates joints_{};
  Imu imu_{};
  FootForces forces_{};
  std::unique_ptr<MotionPlan> plan_ = std::make_unique<MotionPlan>();  // large
  std::uint64_t plan_sequence_ = 0;
  Estimate last_{};  // the plug-in's, then one's own
  std::int64_t turn_ns_ = 0;
  double turn_s_ = 0.010;  // since its turn before
  bool acting_ = false;
  bool started_ = false;  // since begin(): there is a CoM of the tick before
  std::int64_t imu_stamp_ns_ = 0;
  Eigen::Vector3d gyro_bias_ = Eigen::Vector3d::Zero();
  bool has_bias_ = false;
  Eigen::Vector3d attitude_ = Eigen::Vector3d::Zero();  // roll, pitch, yaw
  Eigen::Vector3d rate_ = Eigen::Vector3d::Zero();
  std::array<Eigen::Matrix3d, 2> level_from_base_{};
  std::array<bool, 2> contact_{};
  std::array<double, 2> force_N_{};
  std::size_t support_ = 0;
  std::array<Eigen::Vector3d, 2> com_before_{};               // seen from each foot
  Eigen::Vector3d com_velocity_ = Eigen::Vector3d::Zero();    // seen from the support foot
  Eigen::Vector3d com_difference_ = Eigen::Vector3d::Zero();  // to the last good estimate; fades
};

}  // namespace gaitway::core
