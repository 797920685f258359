// The plug-in plugin_name: the shipped state estimator, which also says when a foot tips over its edge.
#include <array>
#include <cmath>

#include "gaitway/plugin/plugin.hpp"
#include "gaitway/zmp/state_estimator.hpp"

class PluginName final : public gaitway::Plugin {
 public:
  explicit PluginName(gaitway::Setup& setup)
      : robot_(gaitway::urdf::load_robot(setup.robot_directory())),
        margin_m_(setup.parameter("margin", 0.004, "m")),
        estimator_(robot_, gaitway::zmp::EstimatorParameters{}),
        joints_(setup.reads<gaitway::JointStates>("joint_states")),
        forces_(setup.reads<gaitway::FootForces>("foot_forces")),
        imu_(setup.reads<gaitway::Imu>("imu")),
        estimate_(setup.writes<gaitway::Estimate>("estimate")),
        report_(setup.reporter()) {}

  // Every 10 ms.
  void step(const gaitway::Tick& tick) override {
    gaitway::Estimate& estimate = estimate_.value();
    if (!joints_.has_value() || !forces_.has_value() || !imu_.has_value() ||
        !estimator_.update(tick.now_ns, joints_.read(), forces_.read(), imu_.read(), estimate)) {
      return;  // a sensor has not been heard yet
    }
    estimate_.publish();
    for (std::size_t side = 0; side < 2; ++side) {
      const bool tips = estimate.contact[side] != 0 && at_edge(robot_.feet[side], estimate.foot_zmp[side]);
      if (tips && !tipped_[side]) {
        report_(gaitway::Severity::info, side == 0 ? "left foot at its edge" : "right foot at its edge");
      }
      tipped_[side] = tips;
    }
  }

 private:
  [[nodiscard]] bool at_edge(const gaitway::urdf::Foot& foot, const double* zmp) const noexcept {
    return std::abs(zmp[0] - foot.centre_m.x()) > foot.size_m.x() / 2.0 - margin_m_ ||
           std::abs(zmp[1] - foot.centre_m.y()) > foot.size_m.y() / 2.0 - margin_m_;
  }

  gaitway::urdf::RobotModel robot_;
  double margin_m_;
  std::array<bool, 2> tipped_{};
  gaitway::zmp::StateEstimator estimator_;
  gaitway::Input<gaitway::JointStates> joints_;
  gaitway::Input<gaitway::FootForces> forces_;
  gaitway::Input<gaitway::Imu> imu_;
  gaitway::Output<gaitway::Estimate> estimate_;
  gaitway::Reporter report_;
};

GAITWAY_PLUGIN(PluginName, "plugin_name", "0.1.0", "Estimates the state; says when a foot tips over its edge")
