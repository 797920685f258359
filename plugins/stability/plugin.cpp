// Connects the balance controller to its topics: estimate and motion plan in, trims and correction out.
#include "gaitway/plugin/plugin.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/stability/balance_controller.hpp"
#include "gaitway/stability/body_balance.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability {
namespace {

const BalanceParameters& declared(Setup& setup, const urdf::RobotModel& robot,
                                  BalanceParameters& parameters) {
  parameters = balance_of(robot);
  setup.parameters(parameters.numbers());
  return parameters;
}

class Stability final : public Plugin {
 public:
  explicit Stability(Setup& setup) : Stability(setup, urdf::load_robot(setup.robot_directory())) {}

  void step(const Tick& tick) override {
    BalanceInputs inputs;
    if (estimate_.has_value()) inputs.estimate = &estimate_.read();
    if (motion_plan_.has_value()) inputs.plan = &motion_plan_.read();
    if (network_state_.has_value()) inputs.network = &network_state_.read();
    controller_.update(tick.now_ns, inputs, trim_.value(), correction_.value());
    trim_.publish();
    correction_.publish();
  }

  [[nodiscard]] std::uint32_t state_version() const override { return 8; }
  void save_state(StateWriter& state) const override { state(controller_); }
  void restore_state(StateReader& state) override { state(controller_); }

 private:
  Stability(Setup& setup, const urdf::RobotModel& robot)
      : controller_(robot, declared(setup, robot, parameters_)),
        estimate_(setup.reads<Estimate>("estimate")),
        motion_plan_(setup.reads<MotionPlan>("motion_plan")),
        network_state_(setup.reads_optional<NetworkState>("network_state")),
        trim_(setup.writes<TrimCommand>("trim")),
        correction_(setup.writes<Correction>("correction")) {
    setup.period(Period::tick);
  }

  BalanceParameters parameters_;  // live: what is set between two steps is in force at the next one
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
