// The sensors' last good values: what is stale, missing or not finite is not taken, and it is said which.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::zmp {

// What the newest update had to do without.
struct InputFaults {
  bool joints_stale = false;  // no new joint states; the last ones are kept
  bool forces_stale = false;  // no new foot forces, or a joint that brings them is missing
  bool imu_stale = false;     // no new IMU sample, or always the same, or a joint that brings it is missing
  std::uint64_t missing = 0;  // bit i: joint i is missing or not finite; its last position is kept

  [[nodiscard]] bool any() const noexcept {
    return joints_stale || forces_stale || imu_stale || missing != 0;
  }
};

class SensorInputs {
 public:
  SensorInputs(const urdf::RobotModel& model, double stale_after_s);

  // Takes what is new and good. Never allocates.
  void take(std::int64_t now_ns, const JointStates& joints, const FootForces& forces,
            const gaitway::Imu& imu) noexcept;

  [[nodiscard]] const InputFaults& faults() const noexcept { return faults_; }
  // Every sensor has brought at least one good value.
  [[nodiscard]] bool complete() const noexcept { return joints_.seen && forces_.seen && imu_.seen; }
  // Arrival of the oldest of the three values in use.
  [[nodiscard]] std::int64_t stamp_ns() const noexcept;
  // Whole slots between the IMU sample before and this one; 0: no new one.
  [[nodiscard]] int imu_slots() const noexcept { return imu_.slots; }
  [[nodiscard]] int force_slots() const noexcept { return forces_.slots; }  // the same of the forces
  [[nodiscard]] int joint_slots() const noexcept { return joints_.slots; }  // and of the joint states

  [[nodiscard]] std::span<const double> position_rad() const noexcept { return position_rad_; }
  // How fast the legs are meant to move: of the fastest joint. Play does not rattle in it.
  [[nodiscard]] double leg_reference_rate_rad_per_s() const noexcept { return leg_reference_rate_; }
  // Zero where the feet have no sensors: what arrives then with each IMU sample is not theirs.
  [[nodiscard]] const std::array<std::array<double, 4>, 2>& cell_force_N() const noexcept { return force_N_; }
  // Specific force at a sole's origin, in its frame.
  [[nodiscard]] const Eigen::Vector3d& foot_acceleration_m_per_s2(urdf::Side side) const noexcept {
    return foot_acceleration_[static_cast<std::size_t>(side)];
  }
  [[nodiscard]] const Eigen::Vector3d& gyro_rad_per_s() const noexcept { return gyro_; }
  [[nodiscard]] const Eigen::Vector3d& acceleration_m_per_s2() const noexcept { return acceleration_; }
  // Measured roll and pitch; none if the robot has no inclinometer.
  [[nodiscard]] const std::optional<Eigen::Vector2d>& inclination_rad() const noexcept {
    return inclination_;
  }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.joints_, self.forces_, self.imu_, self.faults_, self.position_rad_, self.leg_reference_rad_,
            self.leg_reference_rate_, self.force_N_, self.foot_acceleration_, self.gyro_, self.acceleration_,
            self.inclination_, self.same_imu_samples_);
  }

 private:
  struct Source {
    std::uint64_t joints = 0;   // that bring it, as bits
    std::int64_t stamp_ns = 0;  // of the last good value
    int slots = 0;              // since the value before; 0: nothing new
    bool seen = false;

    template <class Self, class Archive>
    static void visit_state(Self& self, Archive& archive) {
      archive(self.stamp_ns, self.slots, self.seen);
    }
  };

  [[nodiscard]] bool is_fresh(const Source& source, std::int64_t stamp_ns, std::int64_t now_ns,
                              std::uint64_t missing) const noexcept;
  static void mark(Source& source, std::int64_t stamp_ns) noexcept;
  void take_joints(std::int64_t now_ns, const JointStates& joints) noexcept;
  void take_forces(std::int64_t now_ns, const FootForces& forces, std::uint64_t missing) noexcept;
  void take_imu(std::int64_t now_ns, const gaitway::Imu& imu, std::uint64_t missing) noexcept;
  [[nodiscard]] bool imu_is_stuck(const gaitway::Imu& imu) noexcept;

  std::int64_t stale_after_ns_;
  bool has_inclinometer_;
  bool senses_load_;
  Source joints_, forces_, imu_;
  InputFaults faults_;
  std::vector<double> position_rad_;
  std::array<std::array<int, 6>, 2> leg_joints_{};
  std::array<std::array<double, 6>, 2> leg_reference_rad_{};
  double leg_reference_rate_ = 0.0;
  std::array<std::array<double, 4>, 2> force_N_{};
  std::array<Eigen::Vector3d, 2> foot_acceleration_{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  Eigen::Vector3d gyro_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration_ = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector2d> inclination_;
  int same_imu_samples_ = 0;  // in a row, while the legs moved
};

}  // namespace gaitway::zmp
