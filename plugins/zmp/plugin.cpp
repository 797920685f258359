// Connects the state estimator to its topics: joint states, foot forces and IMU in, estimate out.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/plugin/plugin.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/zmp/state_estimator.hpp"

namespace gaitway::zmp {
namespace {

// Of an IMU that nobody has aligned: 1° askew about any axis, of whose square each axis has a third; and a
// zero of 0.005 g.
constexpr double kUnaligned_rad = 0.011;

// Where nothing tells the tilt of a robot that walks, the gyro's bias must be followed as it walks itself,
// some 0.01 °/s in the root of a second: in so long a bias of `bias_deviation` becomes another one.
constexpr double kBiasLifetime_s = 1600.0;
// And a bias of 0.05 rad/s that comes all at once must be learned before the robot leans too far.
constexpr double kBiasWalk_rad_per_s_rts = 0.003;

EstimatorParameters parameters_of(Setup& setup, const urdf::RobotModel& robot) {
  EstimatorParameters p;
  if (robot.imu.inclinometer == urdf::Inclinometer::pendulum) {
    p.tilt_zero_deviation_rad = kUnaligned_rad;
    p.bias_lifetime_s = kBiasLifetime_s;
    p.bias_walk_rad_per_s_rts = kBiasWalk_rad_per_s_rts;
  }
  scale_to_body(p.numbers(), robot.body_scale());
  setup.parameters(p.numbers());
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
  explicit Zmp(Setup& setup) : Zmp(setup, urdf::load_robot(setup.robot_directory())) {}

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

  [[nodiscard]] std::uint32_t state_version() const override { return 9; }
  void save_state(StateWriter& state) const override { state(estimator_); }
  void restore_state(StateReader& state) override { state(estimator_); }

 private:
  Zmp(Setup& setup, const urdf::RobotModel& robot)
      : estimator_(robot, parameters_of(setup, robot)),
        joint_states_(setup.reads<JointStates>("joint_states")),
        foot_forces_(setup.reads<FootForces>("foot_forces")),
        imu_(setup.reads<gaitway::Imu>("imu")),
        estimate_(setup.writes<Estimate>("estimate")),
        report_(setup.reporter()) {
    setup.period(Period::tick);
  }

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
