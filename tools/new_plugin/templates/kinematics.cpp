// The plug-in plugin_name: the shipped leg kinematics, and arms that swing against the legs.
#include <cmath>

#include "gaitway/kinematics/batch_solver.hpp"
#include "gaitway/plugin/plugin.hpp"

class PluginName final : public gaitway::Plugin {
 public:
  explicit PluginName(gaitway::Setup& setup)
      : robot_(gaitway::urdf::load_robot(setup.robot_directory())),
        swing_rad_per_m_(setup.parameter("swing", 4.0, "rad/m")),
        solver_(robot_, gaitway::kinematics::SolverChoice::automatic),
        motion_(setup.reads<gaitway::MotionPlan>("motion_plan")),
        correction_(setup.reads<gaitway::Correction>("correction")),
        joints_(setup.writes<gaitway::JointPlan>("joint_plan")) {
    setup.period(gaitway::Period::batch);
  }

  // Every 80 ms: joint angles for each point of the plan and of its safe tail. Throws where a foot is out of
  // reach: the safe tail plays then.
  void step(const gaitway::Tick& tick) override {
    const gaitway::MotionPlan& motion = motion_.read();
    gaitway::JointPlan& joints = joints_.value();
    if (!solver_.plan_batch(tick.batch_sequence, motion, correction_.read(), joints)) {
      return joints_.publish();  // there is no plan yet
    }
    for (int point = 0; point < gaitway::kBatchPoints + static_cast<int>(motion.tail_count); ++point) {
      const double swing_rad = swing_rad_per_m_ * left_foot_ahead_m(motion, point);
      joints.position[point][left_shoulder_] += static_cast<float>(swing_rad);  // back: positive
      joints.position[point][right_shoulder_] -= static_cast<float>(swing_rad);
    }
    joints_.publish();
  }

 private:
  static double left_foot_ahead_m(const gaitway::MotionPlan& motion, int point) noexcept {
    const auto& foot = motion.foot_position[point];
    return std::cos(motion.base_yaw[point]) * (foot[0][0] - foot[1][0]) +
           std::sin(motion.base_yaw[point]) * (foot[0][1] - foot[1][1]);
  }

  gaitway::urdf::RobotModel robot_;
  int left_shoulder_ = robot_.joint_index("left_shoulder_pitch");
  int right_shoulder_ = robot_.joint_index("right_shoulder_pitch");
  double swing_rad_per_m_;
  gaitway::kinematics::BatchSolver solver_;
  gaitway::Input<gaitway::MotionPlan> motion_;
  gaitway::Input<gaitway::Correction> correction_;
  gaitway::Output<gaitway::JointPlan> joints_;
};

GAITWAY_PLUGIN(PluginName, "plugin_name", "0.1.0", "Swings the arms against the legs")
