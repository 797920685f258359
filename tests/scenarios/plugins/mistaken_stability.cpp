// The shipped balance feedback with a mistake from `mistaken_at` on, for the time `mistaken_for`: the DCM
// that it sees is `dcm_error` further ahead.
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/plugin/plugin.hpp"
#include "gaitway/stability/balance_controller.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace {

class MistakenStability final : public gaitway::Plugin {
 public:
  explicit MistakenStability(gaitway::Setup& setup)
      : begin_s_(setup.parameter("mistaken_at", 0.0, "s")),
        duration_s_(setup.parameter("mistaken_for", 0.0, "s")),
        dcm_error_m_(setup.parameter("dcm_error", 0.0, "m")),
        controller_(gaitway::urdf::load_robot(setup.robot_directory()), parameters_),
        estimate_(setup.reads<gaitway::Estimate>("estimate")),
        plan_(setup.reads<gaitway::MotionPlan>("motion_plan")),
        network_(setup.reads_optional<gaitway::NetworkState>("network_state")),
        trim_(setup.writes<gaitway::TrimCommand>("trim")),
        correction_(setup.writes<gaitway::Correction>("correction")) {}

  void step(const gaitway::Tick& tick) override {
    const double now_s = static_cast<double>(tick.now_ns) * 1e-9;
    const bool mistaken = now_s >= begin_s_ && now_s < begin_s_ + duration_s_;
    gaitway::stability::BalanceInputs inputs;
    if (estimate_.has_value()) {
      seen_ = estimate_.read();
      seen_.dcm[0] += mistaken ? dcm_error_m_ : 0.0;
      inputs.estimate = &seen_;
    }
    if (plan_.has_value()) inputs.plan = &plan_.read();
    if (network_.has_value()) inputs.network = &network_.read();
    controller_.update(tick.now_ns, inputs, trim_.value(), correction_.value());
    trim_.publish();
    correction_.publish();
  }

 private:
  double begin_s_, duration_s_, dcm_error_m_;
  gaitway::stability::BalanceParameters parameters_;
  gaitway::stability::BalanceController controller_;
  gaitway::Estimate seen_{};
  gaitway::Input<gaitway::Estimate> estimate_;
  gaitway::Input<gaitway::MotionPlan> plan_;
  gaitway::Input<gaitway::NetworkState> network_;
  gaitway::Output<gaitway::TrimCommand> trim_;
  gaitway::Output<gaitway::Correction> correction_;
};

}  // namespace

GAITWAY_PLUGIN(MistakenStability, "mistaken_stability", "1.0.0", "The balance feedback with a mistake")
