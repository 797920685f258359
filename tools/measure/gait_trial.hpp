// One trial of the gait measurement: a seeded robot, what is done to it and to the ground, what it is asked
// for; and what came of it. A trial is data alone: the same description gives the same outcome to the bit.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/plugin_library.hpp"
#include "gaitway/simulator/conditions.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

inline constexpr double kTrialPush_s = 0.1;  // how long a push lasts

// From `at_s` on the robot is asked to walk so: forward m/s, left m/s, turn rad/s.
struct TimedVelocity {
  double at_s = 0.0;
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
};

// At the trunk's centre of mass, horizontal.
struct TrialPush {
  double at_s = 0.0;
  double direction_rad =
      0.0;  // where it drives the robot: 0 is ahead of the heading at that instant, π/2 left
  double impulse_Ns = 0.0;
};

// A robot that has fallen is told to play it.
struct TrialRise {
  double at_s = 0.0;
  std::string motion;
};

struct Trial {
  std::uint64_t seed = 1;
  double seconds = 10.0;  // ends earlier when the robot falls, unless it shall rise
  simulator::Conditions conditions = {};
  double corrupted_share = 0.0;         // of the frames on the bus, from the first instant on
  std::vector<TimedVelocity> commands;  // in order of time; none: it stands
  std::optional<TrialPush> push;
  // A fall is watched to its impact and half a second beyond; otherwise a trial ends with it.
  bool watches_fall = false;
  // The shipped stability plug-in leaves the joints stiff: shows whether a robot would have fallen.
  bool stiff_in_fall = false;
  std::optional<TrialRise> rise;  // the trial goes on after a fall, up to its end
  double steady_from_s = 0.0;     // speeds and the ZMP's error are taken from here on
  double gait_cycle_s = 0.8;      // two steps: body sway is averaged over it
  // Measures what batches cost the processor: of that alone the outcome is not the same each time.
  bool times_compute = false;
};

// Of a trial that watches it.
struct FallOutcome {
  std::optional<double> told_s;      // when the estimate said so first
  std::optional<double> impact_s;    // first contact of a link that is no foot, of a robot that leans or lies
  double hardest_force_N = 0.0;      // on one link that is no foot, in one millisecond
  double trunk_speed_m_per_s = 0.0;  // of the trunk, downwards, when it hits the ground; 0 if it does not

  // From being told to the impact; 0 if it was not told before. None without an impact.
  [[nodiscard]] std::optional<double> lead_s() const;
};

struct TrialOutcome {
  bool fell = false;
  double ended_s = 0.0;  // when it fell, or the trial's end
  // From steady_from_s on: forward and left m/s along the robot's own heading, turn rad/s.
  Eigen::Vector3d mean_velocity = Eigen::Vector3d::Zero();
  double heading_drift_rad = 0.0;  // mean of the last gait cycle against the stand before walking
  std::vector<float> heading_deg;  // against that stand, once a second
  std::optional<double>
      zmp_error_rms_m;  // distance of the estimated ZMP from the contact solver's; none: not walked
  // From the push on, of the foot that did so most.
  double foot_moved_m = 0.0;   // of the sole's origin, along the ground
  double foot_lifted_m = 0.0;  // of the lowest corner of the sole above where it stood
  double batch_compute_p99_us = 0.0;
  std::optional<FallOutcome> fall;
  std::optional<double> stands_since_s;  // of a trial with a rise: since then to its end; none: it does not
};

// What a trial's key is made of, and what stands beside its outcome in the file.
nlohmann::ordered_json describe(const Trial& trial);

nlohmann::ordered_json to_json(const TrialOutcome& outcome);
// Throws nlohmann::json::exception where a field is missing or of another type.
TrialOutcome outcome_from_json(const nlohmann::ordered_json& json);

// Whose gait is measured.
struct TrialRobot {
  urdf::RobotModel model;
  core::Configuration plugins;
  core::SearchPath plugin_path = {};  // before the usual places
};

// Runs the trial in virtual time. Several may run side by side, each in its thread. Throws what the
// co-simulation's construction throws: a configuration or a plug-in that cannot be used.
TrialOutcome run_trial(const TrialRobot& robot, const Trial& trial);

}  // namespace gaitway::tools
