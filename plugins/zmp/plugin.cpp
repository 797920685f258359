// Connects the state estimator to its topics: joint states, foot forces and IMU in, estimate out.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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
  p.gyro_noise_rad_per_s = setup.parameter("gyro_noise", p.gyro_noise_rad_per_s, "rad/s");
  p.tilt_noise_rad = setup.parameter("tilt_noise", p.tilt_noise_rad, "rad");
  p.accelerometer_band_m_per_s2 =
      setup.parameter("accelerometer_band", p.accelerometer_band_m_per_s2, "m/s^2");
  p.rate_filter_s = setup.parameter("rate_filter", p.rate_filter_s, "s");
  p.bias_deviation_rad_per_s = setup.parameter("bias_deviation", p.bias_deviation_rad_per_s, "rad/s");
  p.bias_lifetime_s = setup.parameter("bias_lifetime", p.bias_lifetime_s, "s");
  p.heading_noise_rad = setup.parameter("heading_noise", p.heading_noise_rad, "rad");
  p.creep_rad_rts = setup.parameter("creep", p.creep_rad_rts, "rad/s^0.5");
  p.settling_creep_rad_rts = setup.parameter("settling_creep", p.settling_creep_rad_rts, "rad/s^0.5");
  p.rattle_creep_rad_rts = setup.parameter("rattle_creep", p.rattle_creep_rad_rts, "rad/s^0.5");
  p.planted_share = setup.parameter("planted_share", p.planted_share, "1");
  p.planted_time_s = setup.parameter("planted_time", p.planted_time_s, "s");
  p.moved_creep_rts = setup.parameter("moved_creep", p.moved_creep_rts, "s^0.5");
  p.cell_noise_N = setup.parameter("cell_noise", p.cell_noise_N, "N");
  p.cell_gain_deviation = setup.parameter("cell_gain_deviation", p.cell_gain_deviation, "1");
  p.cell_gain_lifetime_s = setup.parameter("cell_gain_lifetime", p.cell_gain_lifetime_s, "s");
  p.link_mass_deviation = setup.parameter("link_mass_deviation", p.link_mass_deviation, "1");
  p.trunk_com_deviation_m = setup.parameter("trunk_com_deviation", p.trunk_com_deviation_m, "m");
  p.joint_zero_deviation_rad = setup.parameter("joint_zero_deviation", p.joint_zero_deviation_rad, "rad");
  p.com_noise_m = setup.parameter("com_noise", p.com_noise_m, "m");
  p.acceleration_noise_m_per_s2 =
      setup.parameter("acceleration_noise", p.acceleration_noise_m_per_s2, "m/s^2");
  p.acceleration_drift_m_per_s2_rts =
      setup.parameter("acceleration_drift", p.acceleration_drift_m_per_s2_rts, "m/s^2/s^0.5");
  p.com_offset_noise_m_rts = setup.parameter("com_offset_noise", p.com_offset_noise_m_rts, "m*s^0.5");
  p.com_offset_drift_m_per_rts = setup.parameter("com_offset_drift", p.com_offset_drift_m_per_rts, "m/s^0.5");
  p.slip_leak_s = setup.parameter("slip_leak", p.slip_leak_s, "s");
  p.slip_offset_time_s = setup.parameter("slip_offset_time", p.slip_offset_time_s, "s");
  p.fall.margin = setup.parameter("fall_margin", p.fall.margin, "1");
  p.fall.confirm_s = setup.parameter("fall_confirm", p.fall.confirm_s, "s");
  p.fall.model.impact_tilt_rad = setup.parameter("fall_impact_tilt", p.fall.model.impact_tilt_rad, "rad");
  p.fall.model.inertia_factor = setup.parameter("fall_inertia", p.fall.model.inertia_factor, "1");
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

const char* text_of_fall(double direction_rad) noexcept {
  constexpr std::array<const char*, 4> kTexts{"the robot falls ahead", "the robot falls to the left",
                                              "the robot falls backwards", "the robot falls to the right"};
  const long quarter = std::lround(direction_rad / (std::numbers::pi / 2.0));
  return kTexts[static_cast<std::size_t>((quarter % 4 + 4) % 4)];
}

// Reports a fall, and its end.
class FallNotice {
 public:
  void update(const FallRecognition& recognition, const Reporter& report) noexcept {
    const Fall fall = recognition.fall();
    if (fall == last_) return;
    last_ = fall;
    switch (fall) {
      case Fall::falls:
        return report(Severity::error, text_of_fall(recognition.direction_rad()));
      case Fall::lies:
        return report(Severity::warning, "the robot lies");
      case Fall::upright:
        return report(Severity::info, "the robot stands again");
    }
  }

 private:
  Fall last_ = Fall::upright;
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
    fall_.update(estimator_.fall(), report_);
    cell_dead_.update(estimator_.cells().any_dead(), report_);
  }

  [[nodiscard]] std::uint32_t state_version() const override { return 4; }
  void save_state(StateWriter& state) const override { state(estimator_); }
  void restore_state(StateReader& state) override { state(estimator_); }

 private:
  StateEstimator estimator_;
  Input<JointStates> joint_states_;
  Input<FootForces> foot_forces_;
  Input<gaitway::Imu> imu_;
  Output<Estimate> estimate_;
  Reporter report_;
  FallNotice fall_;
  FaultNotice no_joints_{"no new joint states: the last ones are kept"};
  FaultNotice no_forces_{"no new foot forces: the last ones are kept"};
  FaultNotice no_imu_{"no new IMU sample: the last attitude is kept"};
  FaultNotice cell_dead_{"a force cell says nothing under load: the other three of its foot stand in for it"};
  FaultNotice joint_missing_{"a joint is missing: its last position is kept"};
};

}  // namespace
}  // namespace gaitway::zmp

GAITWAY_PLUGIN(gaitway::zmp::Zmp, "zmp", "1.0.0",
               "Measured ZMP, contacts, attitude, CoM and DCM from the sensors")
