// The figures of a run, and what they say became of what it was asked: whether the robot stayed up, and
// whether it went where it was told to go.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "gaitway/simulator/plant.hpp"

namespace gaitway::tools {

// Root mean square of what was added.
class RootMeanSquare {
 public:
  void add(double value) noexcept {
    sum_of_squares_ += value * value;
    ++count_;
  }
  [[nodiscard]] double value() const noexcept {
    return count_ == 0 ? 0.0 : std::sqrt(sum_of_squares_ / static_cast<double>(count_));
  }
  [[nodiscard]] std::uint64_t count() const noexcept { return count_; }

 private:
  double sum_of_squares_ = 0.0;
  std::uint64_t count_ = 0;
};

// Force-weighted mean of the physics engine's centre of pressure in each foot's true sole frame over the ten
// milliseconds that the force cells are averaged over, so that truth and measurement mean the same.
class CentreOfPressureMean {
 public:
  void add(const simulator::GroundContact& contact);
  // A time slot is over: its mean is kept until the next slot ends.
  void close_slot();
  // Of both feet together, in the sole frame of `side`; false when nothing touches the ground.
  [[nodiscard]] bool in_sole_frame(int side, Eigen::Vector2d& cop_m) const;
  // Mean normal force on a foot during that slot.
  [[nodiscard]] double mean_force_N(std::size_t foot) const {
    return closed_.foot_force[foot] / closed_.samples;
  }

 private:
  struct Sum {
    std::array<Eigen::Vector2d, 2> moment{Eigen::Vector2d::Zero(),
                                          Eigen::Vector2d::Zero()};  // in sole frame 0, 1
    double force = 0.0;
    std::array<double, 2> foot_force{};
    double samples = 1e-9;
  };
  Sum open_, closed_;
};

// What was commanded, and how far it was carried out.
struct CommandedMotion {
  double commanded = 0.0;  // integral of the commanded rate
  double due = 0.0;        // the same, without the first two seconds of each walk
  double done = 0.0;       // motion in the commanded direction while it was commanded

  void add(double commanded_by, double moved_by, bool started) noexcept {
    commanded += commanded_by;
    due += started ? commanded_by : 0.0;
    done += moved_by;
  }
};

struct RunMetrics {
  bool fell = false;
  double fell_at_s = 0.0;
  // Motion of the base between the first sample and the last.
  bool started = false;
  Eigen::Vector2d start_m = Eigen::Vector2d::Zero();
  double start_yaw_rad = 0.0;
  Eigen::Vector2d end_m = Eigen::Vector2d::Zero();
  double end_yaw_rad = 0.0;         // unwrapped
  double commanded_yaw_rad = 0.0;   // integral of the commanded turn rate
  CommandedMotion way_m, turn_rad;  // unsigned
  // From two seconds after the first walk command to its end: for the mean speed.
  double path_m = 0.0;      // along the heading that the robot has at each instant
  double sideways_m = 0.0;  // to its left
  double walked_s = 0.0;
  RootMeanSquare tracking_rad;           // reference (with trim) minus encoder, all joints
  RootMeanSquare zmp_reference_error_m;  // measured minus reference ZMP while walking
  RootMeanSquare zmp_estimate_error_m;   // ZMP of the cells minus centre of pressure while walking
  double zmp_margin_min_m = std::numeric_limits<double>::infinity();  // inside the polygon of the feet that
                                                                      // bear load, while walking

  [[nodiscard]] double distance_m() const { return (end_m - start_m).norm(); }
  [[nodiscard]] double mean_speed_m_per_s() const { return walked_s > 0.0 ? path_m / walked_s : 0.0; }
  [[nodiscard]] double mean_side_speed_m_per_s() const {
    return walked_s > 0.0 ? sideways_m / walked_s : 0.0;
  }
  [[nodiscard]] double lateral_drift_m() const {
    const Eigen::Rotation2Dd to_start(-start_yaw_rad);
    return (to_start * (end_m - start_m)).y();
  }
  [[nodiscard]] double heading_drift_rad() const { return end_yaw_rad - start_yaw_rad - commanded_yaw_rad; }
};

struct BatchCount {
  std::uint64_t handed_over = 0, refused = 0;
  std::uint64_t refused_by_a_stop = 0;  // of those refused: what is on its way when somebody stops the robot
};

struct RunOutcome {
  enum class Verdict { done, not_done, fell };
  Verdict verdict = Verdict::done;
  std::string text;  // one line, for people
};

// Not done: less than half of the commanded way or turn (start-ups not counted), more than a tenth of the
// batches refused (but by a stop), or none handed over at all. way_missing: of a way that was asked for, and
// not walked to its end.
[[nodiscard]] RunOutcome outcome_of(const RunMetrics& metrics, const BatchCount& batches, double virtual_s,
                                    const std::string& way_missing = {});

// What became of a mission. Its robot may fall, where it gets up again.
struct MissionEnd {
  std::string name;
  enum class State { runs, succeeded, failed } state = State::runs;
  double at_s = 0.0;          // of its end
  bool endless = false;       // it can't succeed, and needs no end
  bool is_of_people = false;  // who begin and end it as they like
  int falls = 0;
  bool waits = false;                      // at the end of the run: somebody else commanded
  bool on_feet = true;                     // then
  std::optional<double> silent_since_s{};  // nothing was heard of the behaviour since
  std::string reason{};                    // of a failure
};
// Of one with an end, in place of the outcome above: done when it has succeeded.
[[nodiscard]] RunOutcome outcome_of(const MissionEnd& mission);
// Of any. One without an end only adds to what the walk has come to, and is not done where it waits while
// somebody else commands, or has gone silent.
[[nodiscard]] RunOutcome outcome_of(const MissionEnd& mission, RunOutcome walked);

// Of the program.
[[nodiscard]] int exit_code(RunOutcome::Verdict verdict) noexcept;
// For summary.json.
[[nodiscard]] const char* name(RunOutcome::Verdict verdict) noexcept;

}  // namespace gaitway::tools
