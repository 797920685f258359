// Watches one trial and keeps its figures; unlike the run's recorder it keeps no samples.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <deque>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "tools/measure/gait_trial.hpp"
#include "tools/run/run_metrics.hpp"

namespace gaitway::tools {

class TrialWatch {
 public:
  TrialWatch(simulator::Cosimulation& run, const Trial& trial);

  // After each millisecond.
  void look();
  [[nodiscard]] TrialOutcome outcome() const;
  // Of a trial that watches its fall: it is on its way, it is half a second old.
  [[nodiscard]] bool falls() const;
  [[nodiscard]] bool fall_is_over() const;

 private:
  struct Pose {
    double time_s = 0.0;
    Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
    double yaw_rad = 0.0;  // not wrapped
  };

  void take_sample(double time_s);
  void measure_heading(const Pose& pose);
  void measure_progress(const Pose& pose);
  void compare_zmp();
  void watch_feet(double time_s);
  void watch_fall();
  void watch_stand();
  [[nodiscard]] double lowest_corner_m(std::size_t foot) const;

  simulator::Cosimulation& run_;
  const Trial& trial_;
  msgclient::Reader<Estimate> estimate_;
  CentreOfPressureMean cop_mean_;
  RootMeanSquare zmp_error_m_;
  TrialOutcome outcome_;

  std::deque<Pose> cycle_;  // the last gait cycle
  double yaw_rad_ = 0.0;
  double stand_yaw_sum_rad_ = 0.0;
  int stand_samples_ = 0;
  Eigen::Vector3d progress_ = Eigen::Vector3d::Zero();  // along the heading: m, m, rad
  double progress_s_ = 0.0;
  Pose progress_from_;
  bool progressing_ = false;
  bool feet_noted_ = false;
  std::array<Eigen::Vector3d, 2> feet_at_push_m_{};
  std::array<double, 2> lowest_at_push_m_{};
  FallOutcome fall_;
  double fallen_s_ = 0.0;  // since it leans beyond any return, or has hit the ground
  double trunk_height_m_ = 0.0;
  bool trunk_down_ = false;
  Eigen::Vector3d up_;  // normal of the ground
};

}  // namespace gaitway::tools
