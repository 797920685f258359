// Connects the state estimator to its topics: joint states, foot forces and IMU in, estimate out.
#include <algorithm>

#include "gaitway/core/plugin.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/zmp/state_estimator.hpp"

namespace gaitway::zmp {
namespace {

EstimatorParameters parameters_of(Setup& setup) {
  EstimatorParameters p;
  p.contact_on_share = setup.parameter("contact_on_share", p.contact_on_share, "1");
  p.contact_off_share = setup.parameter("contact_off_share", p.contact_off_share, "1");
  p.support_margin = setup.parameter("support_margin", p.support_margin, "1");
  p.tilt_time_constant_s = setup.parameter("tilt_time_constant", p.tilt_time_constant_s, "s");
  p.accelerometer_band_m_per_s2 =
      setup.parameter("accelerometer_band", p.accelerometer_band_m_per_s2, "m/s^2");
  p.rate_filter_s = setup.parameter("rate_filter", p.rate_filter_s, "s");
  p.still_rate_rad_per_s = setup.parameter("still_rate", p.still_rate_rad_per_s, "rad/s");
  p.still_joint_rate_rad_per_s = setup.parameter("still_joint_rate", p.still_joint_rate_rad_per_s, "rad/s");
  p.still_time_s = setup.parameter("still_time", p.still_time_s, "s");
  p.bias_time_constant_s = setup.parameter("bias_time_constant", p.bias_time_constant_s, "s");
  p.bias_limit_rad_per_s = setup.parameter("bias_limit", p.bias_limit_rad_per_s, "rad/s");
  p.com_noise_m = setup.parameter("com_noise", p.com_noise_m, "m");
  p.acceleration_noise_m_per_s2 =
      setup.parameter("acceleration_noise", p.acceleration_noise_m_per_s2, "m/s^2");
  p.acceleration_drift_m_per_s2_rts =
      setup.parameter("acceleration_drift", p.acceleration_drift_m_per_s2_rts, "m/s^2/s^0.5");
  p.stale_after_s = setup.parameter("stale_after", p.stale_after_s, "s");
  return p;
}

// Reports a fault when it begins, and again only after a quiet second.
class FaultNotice {
 public:
  explicit FaultNotice(const char* text) noexcept : text_(text) {}

  void update(bool fault, const Reporter& report) noexcept {
    if (fault && quiet_ticks_ >= kQuietTicks) report(Severity::warning, text_);
    quiet_ticks_ = fault ? 0 : std::min(quiet_ticks_ + 1, kQuietTicks);
  }

 private:
  static constexpr int kQuietTicks = 100;
  const char* text_;
  int quiet_ticks_ = kQuietTicks;
};

class Zmp final : public Plugin {
 public:
  explicit Zmp(Setup& setup)
      : estimator_(urdf::load_robot(setup.robot_directory()), parameters_of(setup)),
        joint_states_(setup.reads<JointStates>("joint_states")),
        foot_forces_(setup.reads<FootForces>("foot_forces")),
        imu_(setup.reads<gaitway::Imu>("imu")),
        estimate_(setup.writes<Estimate>("estimate")),
        report_(setup.reporter()) {
    setup.period(Period::tick);
  }

  void step(const Tick& tick) override {
    const JointStates& joints = joint_states_.read();
    const FootForces& forces = foot_forces_.read();
    const gaitway::Imu& imu = imu_.read();
    if (!joint_states_.has_value() || !foot_forces_.has_value() || !imu_.has_value()) return;
    if (!estimator_.update(tick.now_ns, joints, forces, imu, estimate_.value())) return;
    estimate_.publish();
    const InputFaults& faults = estimator_.faults();
    no_joints_.update(faults.joints_stale, report_);
    no_forces_.update(faults.forces_stale, report_);
    no_imu_.update(faults.imu_stale, report_);
    joint_missing_.update(faults.missing != 0, report_);
  }

  [[nodiscard]] std::uint32_t state_version() const override { return 1; }
  void save_state(StateWriter& state) const override { state(estimator_); }
  void restore_state(StateReader& state) override { state(estimator_); }

 private:
  StateEstimator estimator_;
  Input<JointStates> joint_states_;
  Input<FootForces> foot_forces_;
  Input<gaitway::Imu> imu_;
  Output<Estimate> estimate_;
  Reporter report_;
  FaultNotice no_joints_{"no new joint states: the last ones are kept"};
  FaultNotice no_forces_{"no new foot forces: the last ones are kept"};
  FaultNotice no_imu_{"no new IMU sample: the last attitude is kept"};
  FaultNotice joint_missing_{"a joint is missing: its last position is kept"};
};

}  // namespace
}  // namespace gaitway::zmp

GAITWAY_PLUGIN(gaitway::zmp::Zmp, "zmp", "1.0.0",
               "Measured ZMP, contacts, attitude, CoM and DCM from the sensors")
