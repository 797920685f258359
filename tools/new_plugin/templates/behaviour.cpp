// The plug-in plugin_name: the behaviour with a leaf of its own beside the shipped ones. It takes the place
// of the shipped behaviour, and begins with the mission in plugin_name.xml.
#include <cmath>
#include <memory>
#include <utility>

#include "gaitway/behaviour_leaves/behaviour_plugin.hpp"
#include "gaitway/behaviour_leaves/leaf_library.hpp"

namespace behaviour = gaitway::behaviour;
namespace leaves = gaitway::behaviour_leaves;

// <StepAside distance="0.2 m"/>: walks to the left until it has come so far, to the right where that is
// negative; succeeds when it stands. Called once a batch, every 80 ms; an order to walk holds until the next.
class StepAside final : public behaviour::Action {
 public:
  explicit StepAside(std::shared_ptr<leaves::Robot> robot) : robot_(std::move(robot)) {}

  behaviour::Outcome on_start(behaviour::Call& call) noexcept override {
    start_ = robot_->situation.base();
    is_there_ = false;
    return on_running(call);
  }

  behaviour::Outcome on_running(behaviour::Call& call) noexcept override {
    const leaves::Situation& now = robot_->situation;
    if (!now.is_upright()) return behaviour::Outcome::failure;
    const double wanted_m = call.get<double>(0).value_or(0.0);
    const double gone_m = leaves::inside(start_, now.base()).y_m;
    is_there_ = is_there_ || gone_m * wanted_m >= wanted_m * wanted_m;
    if (is_there_) return now.stands() ? behaviour::Outcome::success : behaviour::Outcome::running;
    robot_->orders.walk({.left_m_per_s = std::copysign(kSpeed_m_per_s, wanted_m)});
    return behaviour::Outcome::running;
  }

  // Something else takes its turn: what comes next begins when the robot stands.
  Halt on_halt(behaviour::Call& call) noexcept override { return on_halting(call); }
  Halt on_halting(behaviour::Call&) noexcept override {
    const leaves::Situation& now = robot_->situation;
    return now.stands() || !now.commands() || !now.is_upright() ? Halt::ended : Halt::ending;
  }

 private:
  static constexpr double kSpeed_m_per_s = 0.08;
  std::shared_ptr<leaves::Robot> robot_;
  leaves::Pose start_;  // odometry
  bool is_there_ = false;
};

// The leaves that the mission may use beside the shipped ones (`gaitway behaviour leaves` lists these).
void register_own_leaves(behaviour::Registry& registry, const std::shared_ptr<leaves::Robot>& robot) {
  registry.add_action(
      {.id = "StepAside",
       .ports = {{.name = "distance",
                  .type = {.kind = behaviour::ValueKind::number, .unit = "m", .lowest = -1.0, .highest = 1.0},
                  .meaning = "to the left"}},
       .meaning = "Walks sideways, and stands"},
      [robot] { return std::make_unique<StepAside>(robot); });
}

class PluginName final : public leaves::BehaviourPlugin {
 public:
  explicit PluginName(gaitway::Setup& setup)
      : BehaviourPlugin(setup, register_own_leaves, GAITWAY_PLUGIN_TREE) {}
};

GAITWAY_PLUGIN(PluginName, "plugin_name", "0.1.0", "Runs missions, which may step aside")
GAITWAY_BEHAVIOUR_LEAVES(register_own_leaves)
