// Plans to stand in the home posture, and spoils its plan as its parameter `defect` says.
#include <limits>
#include <stdexcept>
#include <string>

#include "gaitway/plugin/plugin.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace {

constexpr std::uint32_t kTail = 16;

class JointPlanner final : public gaitway::Plugin {
 public:
  explicit JointPlanner(gaitway::Setup& setup)
      : robot_(gaitway::urdf::load_robot(setup.robot_directory())),
        defect_(setup.parameter("defect", "none")),
        speed_(setup.live_parameter("speed", 0.0)),
        states_(setup.reads<gaitway::JointStates>("joint_states")),
        trim_(setup.writes<gaitway::TrimCommand>("trim")),
        plan_(setup.writes<gaitway::JointPlan>("joint_plan")) {}

  void step(const gaitway::Tick& tick) override {
    trim_.value().stamp_ns = tick.now_ns;
    trim_.value().channel_count = 8;
    trim_.value().angle[3] = 0.01;
    trim_.value().gain[0][2][1] = 0.25;
    trim_.publish();
    if (tick.batch) {
      plan(tick);
    }
  }

 private:
  void plan(const gaitway::Tick& tick) {
    gaitway::JointPlan& plan = plan_.value();
    plan.sequence = tick.batch_sequence - (defect_ == "old_sequence" ? 1 : 0);
    plan.joint_count = static_cast<std::uint32_t>(robot_.joints.size());
    plan.tail_count = kTail;
    for (std::uint32_t point = 0; point < gaitway::kBatchPoints + kTail; ++point) {
      plan.support[point] = 2;
      for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
        plan.position[point][joint] = static_cast<float>(robot_.joints[joint].home_rad + drift_rad_);
      }
      drift_rad_ += defect_ == "drift" && point < gaitway::kBatchPoints ? 0.001 : 0.0;
    }
    if (defect_ == "not_a_number") {
      plan.position[3][5] = std::numeric_limits<float>::quiet_NaN();
    }
    if (defect_ == "jump") {
      plan.position[0][3] += 0.3F;
    }
    const bool stopped = defect_ == "stops_after_two" && tick.batch_sequence > 2;
    if (defect_ != "silent" && !stopped) {
      plan_.publish();
    }
    if (defect_ == "throw") {
      throw std::runtime_error("out of reach");
    }
  }

  gaitway::urdf::RobotModel robot_;
  std::string defect_;
  gaitway::Live<double> speed_;  // without effect: to be set
  double drift_rad_ = 0.0;
  gaitway::Input<gaitway::JointStates> states_;
  gaitway::Output<gaitway::TrimCommand> trim_;
  gaitway::Output<gaitway::JointPlan> plan_;
};

}  // namespace

GAITWAY_PLUGIN(JointPlanner, "joint_planner", "1.0.0", "Stands")
