// The plug-in plugin_name: turns the head to where the robot will walk; the legs are the shipped kinematics'.
#include <algorithm>

#include "gaitway/facts/facts.hpp"
#include "gaitway/kinematics/batch_solver.hpp"
#include "gaitway/plugin/plugin.hpp"

class PluginName final : public gaitway::Plugin {
 public:
  explicit PluginName(gaitway::Setup& setup)
      : robot_(gaitway::urdf::load_robot(setup.robot_directory())),
        look_ahead_s_(setup.parameter("look_ahead", 2.0, "s")),
        speed_rad_per_s_(setup.parameter("speed", 1.0, "rad/s")),
        solver_(robot_, gaitway::kinematics::SolverChoice::automatic),
        walk_(setup.reads_optional<gaitway::WalkCommand>("walk_command")),
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
    constexpr double kStep_s = gaitway::facts::kSlot_s;  // from point to point
    const double aim_rad = std::clamp(look_ahead_s_ * walk_.read().turn_rate, -1.0, 1.0);
    for (int point = 0; point < gaitway::kBatchPoints + static_cast<int>(motion.tail_count); ++point) {
      if (point < gaitway::kBatchPoints) {  // in the tail the head holds still
        gaze_rad_ += std::clamp(aim_rad - gaze_rad_, -kStep_s * speed_rad_per_s_, kStep_s * speed_rad_per_s_);
      }
      joints.position[point][neck_yaw_] = static_cast<float>(gaze_rad_);
    }
    joints_.publish();
  }

 private:
  gaitway::urdf::RobotModel robot_;
  int neck_yaw_ = robot_.joint_index("neck_yaw");
  double look_ahead_s_, speed_rad_per_s_;
  double gaze_rad_ = 0.0;
  gaitway::kinematics::BatchSolver solver_;
  gaitway::Input<gaitway::WalkCommand> walk_;
  gaitway::Input<gaitway::MotionPlan> motion_;
  gaitway::Input<gaitway::Correction> correction_;
  gaitway::Output<gaitway::JointPlan> joints_;
};

GAITWAY_PLUGIN(PluginName, "plugin_name", "0.1.0", "Looks to where the robot will walk")
