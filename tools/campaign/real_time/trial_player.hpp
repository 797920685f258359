// One trial in real time: waits until the robot walks, lets the fault happen at its instant, and watches.
#pragma once

#include <memory>
#include <optional>

#include "tools/campaign/real_time/real_time_row.hpp"
#include "tools/campaign/real_time/real_time_trial.hpp"
#include "tools/campaign/real_time/recovery_watch.hpp"
#include "tools/campaign/real_time/robot_sight.hpp"

namespace gaitway::tools {

// A robot, who commands it, and who looks at it.
struct TrialGround {
  TrialGround(const WalkingRobot::Options& options, double speed_m_per_s)
      : robot(options), person(robot.url(), speed_m_per_s), eye(robot.folder()) {}

  WalkingRobot robot;
  Person person;
  RobotEye eye;
};

class TrialPlayer {
 public:
  TrialPlayer(TrialGround& ground, const RealTimeRow& row, const RealTimeTrial& trial)
      : ground_(ground), row_(row), trial_(trial), watch_(trial.speed_m_per_s) {}

  // Nothing: a signal came meanwhile. Throws std::runtime_error when the robot does not walk before the
  // fault.
  [[nodiscard]] std::optional<RealTimeOutcome> play();

 private:
  [[nodiscard]] bool wait_for_walk();
  [[nodiscard]] bool wait_for_instant();
  void let_it_happen();
  void follow_stop(std::int64_t now_ns);
  [[nodiscard]] bool is_over(std::int64_t now_ns) const;
  std::int64_t look();

  TrialGround& ground_;
  const RealTimeRow& row_;
  const RealTimeTrial& trial_;
  RecoveryWatch watch_;
  std::int64_t instant_ns_ = 0, end_ns_ = 0, fall_looked_ns_ = 0, walk_again_ns_ = 0;
  bool well_ = false;
  std::unique_ptr<Noise> noise_;
  std::unique_ptr<StopAsker> stop_;
  std::string note_;
};

}  // namespace gaitway::tools
