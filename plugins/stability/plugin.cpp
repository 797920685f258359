// Connects the balance controller to its topics: estimate and motion plan in, trims and correction out.
#include "gaitway/core/plugin.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/stability/balance_controller.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability {
namespace {

JointGain gain_of(Setup& setup, const char* angle, const char* rate, const JointGain& standard) {
  return {setup.parameter(angle, standard.angle_rad_per_rad, "rad/rad"),
          setup.parameter(rate, standard.rate_rad_per_rad_per_s, "s")};
}

BalanceParameters parameters_of(Setup& setup) {
  BalanceParameters p;
  p.ankle_pitch = gain_of(setup, "ankle_pitch", "ankle_pitch_rate", p.ankle_pitch);
  p.ankle_roll = gain_of(setup, "ankle_roll", "ankle_roll_rate", p.ankle_roll);
  p.hip_pitch = gain_of(setup, "hip_pitch", "hip_pitch_rate", p.hip_pitch);
  p.hip_roll = gain_of(setup, "hip_roll", "hip_roll_rate", p.hip_roll);
  p.attitude_reference_rad[0] = setup.parameter("roll_reference", p.attitude_reference_rad[0], "rad");
  p.attitude_reference_rad[1] = setup.parameter("pitch_reference", p.attitude_reference_rad[1], "rad");
  p.trim_limit_rad = setup.parameter("trim_limit", p.trim_limit_rad, "rad");
  p.ramp_s = setup.parameter("ramp", p.ramp_s, "s");
  p.standing_after_s = setup.parameter("standing_after", p.standing_after_s, "s");
  p.fallen_at_rad = setup.parameter("fallen_at", p.fallen_at_rad, "rad");
  p.airborne_after_s = setup.parameter("airborne_after", p.airborne_after_s, "s");
  p.estimate_lifetime_s = setup.parameter("estimate_lifetime", p.estimate_lifetime_s, "s");
  p.fall_softness = setup.parameter("fall_softness", p.fall_softness, "1");
  p.heading_gain_per_s = setup.parameter("heading_gain", p.heading_gain_per_s, "1/s");
  p.heading_limit_rad_per_s = setup.parameter("heading_limit", p.heading_limit_rad_per_s, "rad/s");
  p.heading_filter_s = setup.parameter("heading_filter", p.heading_filter_s, "s");
  p.speed_filter_s = setup.parameter("speed_filter", p.speed_filter_s, "s");
  p.speed_limit_m_per_s = setup.parameter("speed_limit", p.speed_limit_m_per_s, "m/s");
  p.lean_gain_per_s = setup.parameter("lean_gain", p.lean_gain_per_s, "1/s");
  p.walking_lean_gain_per_s = setup.parameter("walking_lean_gain", p.walking_lean_gain_per_s, "1/s");
  p.lean_limit_rad = setup.parameter("lean_limit", p.lean_limit_rad, "rad");
  p.sole_gain_rad_per_m_s = setup.parameter("sole_gain", p.sole_gain_rad_per_m_s, "rad/(m*s)");
  p.sole_limit_rad = setup.parameter("sole_limit", p.sole_limit_rad, "rad");
  return p;
}

class Stability final : public Plugin {
 public:
  explicit Stability(Setup& setup)
      : controller_(urdf::load_robot(setup.robot_directory()), parameters_of(setup)),
        estimate_(setup.reads<Estimate>("estimate")),
        motion_plan_(setup.reads<MotionPlan>("motion_plan")),
        network_state_(setup.reads_optional<NetworkState>("network_state")),
        trim_(setup.writes<TrimCommand>("trim")),
        correction_(setup.writes<Correction>("correction")) {
    setup.period(Period::tick);
  }

  void step(const Tick& tick) override {
    BalanceInputs inputs;
    inputs.estimate = &estimate_.read();
    if (!estimate_.has_value()) inputs.estimate = nullptr;
    inputs.plan = &motion_plan_.read();
    if (!motion_plan_.has_value()) inputs.plan = nullptr;
    inputs.network = &network_state_.read();
    if (!network_state_.has_value()) inputs.network = nullptr;
    controller_.update(tick.now_ns, inputs, trim_.value(), correction_.value());
    trim_.publish();
    correction_.publish();
  }

  [[nodiscard]] std::uint32_t state_version() const override { return 4; }
  void save_state(StateWriter& state) const override { state(controller_); }
  void restore_state(StateReader& state) override { state(controller_); }

 private:
  BalanceController controller_;
  Input<Estimate> estimate_;
  Input<MotionPlan> motion_plan_;
  Input<NetworkState> network_state_;
  Output<TrimCommand> trim_;
  Output<Correction> correction_;
};

}  // namespace
}  // namespace gaitway::stability

GAITWAY_PLUGIN(gaitway::stability::Stability, "stability", "1.0.0",
               "Balance feedback: trims from the trunk's attitude, heading and lean through the batches")
