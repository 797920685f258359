// From the sensors to the topic `estimate`: contacts, measured ZMP, attitude, CoM, its velocity and the
// divergent component of motion (DCM).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/neck.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/zmp/attitude_filter.hpp"
#include "gaitway/zmp/cell_calibration.hpp"
#include "gaitway/zmp/com_filter.hpp"
#include "gaitway/zmp/estimator_parameters.hpp"
#include "gaitway/zmp/fall_recognition.hpp"
#include "gaitway/zmp/foot_contact.hpp"
#include "gaitway/zmp/foot_load_model.hpp"
#include "gaitway/zmp/foot_odometry.hpp"
#include "gaitway/zmp/sensor_inputs.hpp"
#include "gaitway/zmp/support_kinematics.hpp"

namespace gaitway::zmp {

// The frame `support` is the level frame of the support foot (see SupportKinematics): z against gravity, even
// if the sole is tilted. To be updated every 10 ms. Not thread-safe.
class StateEstimator {
 public:
  // Throws std::invalid_argument (see EstimatorParameters::validate).
  StateEstimator(const urdf::RobotModel& model, const EstimatorParameters& parameters);

  // Fills `estimate`; false, and nothing filled, until every sensor has been heard once. The estimate's stamp
  // is the arrival of the oldest sensor value in it: it stops when a sensor does. About 2 us; no
  // allocation.
  bool update(std::int64_t now_ns, const JointStates& joints, const FootForces& forces,
              const gaitway::Imu& imu, Estimate& estimate) noexcept;

  [[nodiscard]] const InputFaults& faults() const noexcept { return inputs_.faults(); }
  [[nodiscard]] const AttitudeFilter& attitude() const noexcept { return attitude_; }
  [[nodiscard]] const CellCalibration& cells() const noexcept { return cells_; }
  [[nodiscard]] const FallRecognition& fall() const noexcept { return fall_; }
  // Natural frequency of the pendulum at the estimated CoM height, sqrt(g / height).
  [[nodiscard]] double omega_rad_per_s() const noexcept;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.contacts_, self.cells_, self.attitude_, self.com_, self.com_offset_, self.angular_velocity_,
            self.zmp_m_, self.zmp_variance_, self.support_, self.frame_heading_rad_, self.started_,
            self.blind_ticks_, self.predicted_ticks_, self.settling_ticks_, self.last_measured_m_,
            self.turned_attitude_, self.calm_slots_, self.feet_planted_, self.slip_, self.fall_, self.inputs_,
            self.load_model_, self.odometry_);
  }

 private:
  void update_attitude() noexcept;
  void correct_tilt() noexcept;
  void place_body() noexcept;
  [[nodiscard]] bool begin_tilt(const Eigen::Vector3d& force_m_per_s2) noexcept;  // false: not yet
  void hold_heading() noexcept;
  void update_pressure() noexcept;
  void update_slip() noexcept;
  void update_com() noexcept;
  void begin_com(const Eigen::Vector3d& velocity_m_per_s) noexcept;
  void resume_com() noexcept;
  void follow_frame() noexcept;
  void change_support() noexcept;
  void update_fall() noexcept;
  [[nodiscard]] Eigen::Vector2d zmp_in(urdf::Side foot) const noexcept;
  [[nodiscard]] Eigen::Vector2d zmp_variance_in(urdf::Side foot) const noexcept;
  [[nodiscard]] Eigen::Vector3d filtered_com_m() const noexcept;
  [[nodiscard]] Eigen::Vector3d measured_com_m(urdf::Side foot) const noexcept;
  [[nodiscard]] bool in_the_air() const noexcept;
  void write(Estimate& estimate) const noexcept;
  void write_odometry(Estimate& estimate) const noexcept;
  void write_deviations(Estimate& estimate) const noexcept;

  EstimatorParameters parameters_;
  double mass_kg_;
  double nominal_com_height_m_;
  urdf::Neck neck_;
  std::array<urdf::Foot, 2> feet_;
  SensorInputs inputs_;
  ContactDetector contacts_;
  bool senses_load_;
  bool senses_tilt_;          // an inclinometer that tells roll and pitch, not apparent gravity
  FootLoadModel load_model_;  // speaks where the feet do not
  CellCalibration cells_;
  AttitudeFilter attitude_;
  Attitude turned_attitude_;  // that of the last tick, turned on by the gyro alone
  int calm_slots_ = 0;
  PlantedFeet feet_planted_;
  ModelUncertainty model_uncertainty_;
  SupportKinematics kinematics_;
  std::array<ComFilter, 3> com_;
  ComOffset com_offset_;
  std::array<FootPressure, 2> pressure_{};
  std::array<SlipObserver, 2> slip_;
  FallRecognition fall_;
  FootOdometry odometry_;
  Eigen::Vector3d angular_velocity_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d zmp_m_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d zmp_variance_ = Eigen::Vector2d::Zero();
  urdf::Side support_ = urdf::Side::left;
  double frame_heading_rad_ = 0.0;  // in the world, of the frame in which the filters' states are
  bool started_ = false;
  int blind_ticks_ = 0;                                        // without joint states
  int predicted_ticks_ = 0;                                    // since the CoM was measured
  int settling_ticks_ = 0;                                     // in which no fall is told
  Eigen::Vector3d last_measured_m_ = Eigen::Vector3d::Zero();  // CoM, in the support's frame of then
};

}  // namespace gaitway::zmp
