// Speed, heading, ZMP and feet of one trial.
#include "tools/measure/trial_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gaitway/facts/facts.hpp"
#include "gaitway/plugin/cycle.hpp"

namespace gaitway::tools {
namespace {

constexpr double kTolerance_s = 1e-6;
constexpr double kLeaning_rad = 0.35;  // of the trunk: a robot that walks does not lean so far
constexpr double kWatchedFall_s = 1.0;
// Of a robot that stands again.
constexpr double kUpright_rad = 0.1;
constexpr double kStandingHeight = 0.9;  // of the hips, as a share of that in the stand
using facts::kDegreePerRad;

double yaw_of(const Eigen::Isometry3d& pose) {
  return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
}

}  // namespace

TrialWatch::TrialWatch(simulator::Cosimulation& run, const Trial& trial)
    : run_(run), trial_(trial), estimate_(run.client().read<Estimate>("estimate")) {
  const Eigen::Vector2d& slope = trial.conditions.ground.slope_rad;
  up_ = Eigen::Vector3d(-std::tan(slope.x()), -std::tan(slope.y()), 1.0).normalized();
}

void TrialWatch::look() {
  const simulator::Plant& plant = run_.plant();
  const std::int64_t now_ns = run_.now_ns();
  outcome_.ended_s = plant.time_s();
  if (trial_.watches_fall) {
    watch_fall();
  }
  if (trial_.rise) {
    watch_stand();
  }
  if (plant.fallen()) {
    outcome_.fell = true;
    return;
  }
  cop_mean_.add(plant.ground_contact());
  if (now_ns % facts::kSlot_ns == 0) {
    cop_mean_.close_slot();
  }
  // A millisecond after the main controller's tick, so that its estimate is of the slot that has just ended.
  if (core::is_tick(now_ns - facts::kMillisecond_ns)) {
    take_sample(static_cast<double>(now_ns) * 1e-9);
  }
}

// A standing robot that touches the edge of a step with its shank has not hit the ground.
void TrialWatch::watch_fall() {
  const simulator::Plant& plant = run_.plant();
  const simulator::GroundContact& contact = plant.ground_contact();
  const simulator::PlantTruth truth = plant.truth();
  const bool down = plant.fallen() || truth.trunk_tilt_rad > kLeaning_rad;
  if (!fall_.impact_s && contact.body_force_N > 0.0 && down) {
    fall_.impact_s = plant.time_s();
  }
  if (fall_.impact_s) {
    fall_.hardest_force_N = std::max(fall_.hardest_force_N, contact.hardest_force_N);
  }
  const double height_m = truth.trunk.translation().z();
  if (!trunk_down_ && contact.trunk_force_N > 0.0) {
    trunk_down_ = true;
    fall_.trunk_speed_m_per_s = (trunk_height_m_ - height_m) * 1e3;
  }
  trunk_height_m_ = height_m;
  if (plant.fallen() || fall_.impact_s) {
    fallen_s_ += 1e-3;
  }
  Estimate estimate{};
  if (!fall_.told_s && estimate_.read(estimate).status == msgclient::ReadStatus::value &&
      estimate.fall != 0) {
    fall_.told_s = plant.time_s();
  }
}

void TrialWatch::watch_stand() {
  const simulator::PlantTruth truth = run_.plant().truth();
  const bool stands = truth.trunk_tilt_rad < kUpright_rad &&
                      truth.base.translation().z() > kStandingHeight * run_.robot().hip_height_m &&
                      run_.plant().ground_contact().body_force_N == 0.0;
  if (!stands) {
    outcome_.stands_since_s.reset();
  } else if (!outcome_.stands_since_s) {
    outcome_.stands_since_s = run_.plant().time_s();
  }
}

bool TrialWatch::falls() const {
  return fallen_s_ > 0.0;
}
bool TrialWatch::fall_is_over() const {
  return fallen_s_ > kWatchedFall_s;
}

void TrialWatch::take_sample(double time_s) {
  const Eigen::Isometry3d base = run_.plant().truth().base;
  yaw_rad_ += std::remainder(yaw_of(base) - yaw_rad_, 2.0 * std::numbers::pi);
  const Pose pose{time_s, base.translation().head<2>(), yaw_rad_};
  cycle_.push_back(pose);
  while (pose.time_s - cycle_.front().time_s > trial_.gait_cycle_s - kTolerance_s) {
    cycle_.pop_front();
  }
  measure_heading(pose);
  measure_progress(pose);
  if (!trial_.commands.empty() && time_s >= trial_.steady_from_s) {
    compare_zmp();
  }
  watch_feet(time_s);
}

void TrialWatch::measure_heading(const Pose& pose) {
  if (trial_.commands.empty() || pose.time_s <= trial_.commands.front().at_s) {
    stand_yaw_sum_rad_ += pose.yaw_rad;
    ++stand_samples_;
    return;
  }
  double sum_rad = 0.0;
  for (const Pose& one : cycle_) {
    sum_rad += one.yaw_rad;
  }
  outcome_.heading_drift_rad =
      sum_rad / static_cast<double>(cycle_.size()) - stand_yaw_sum_rad_ / std::max(stand_samples_, 1);
  if (pose.time_s >= static_cast<double>(outcome_.heading_deg.size() + 1)) {
    outcome_.heading_deg.push_back(static_cast<float>(outcome_.heading_drift_rad * kDegreePerRad));
  }
}

// The body sways with each step and turns with it: what it covers in a whole gait cycle is laid along the
// cycle's mean heading.
void TrialWatch::measure_progress(const Pose& pose) {
  if (trial_.commands.empty() || pose.time_s < trial_.steady_from_s) {
    return;
  }
  if (progressing_ && pose.time_s - progress_from_.time_s < trial_.gait_cycle_s - kTolerance_s) {
    return;
  }
  if (progressing_) {
    double heading_rad = 0.0;
    for (const Pose& one : cycle_) {
      heading_rad += one.yaw_rad / static_cast<double>(cycle_.size());
    }
    progress_.head<2>() += Eigen::Rotation2Dd(-heading_rad) * (pose.position_m - progress_from_.position_m);
    progress_.z() += pose.yaw_rad - progress_from_.yaw_rad;
    progress_s_ += pose.time_s - progress_from_.time_s;
  }
  progressing_ = true;
  progress_from_ = pose;
}

void TrialWatch::compare_zmp() {
  Estimate estimate{};
  if (estimate_.read(estimate).status != msgclient::ReadStatus::value) {
    return;
  }
  Eigen::Vector2d true_cop;
  if (cop_mean_.in_sole_frame(static_cast<int>(estimate.support), true_cop)) {
    zmp_error_m_.add((Eigen::Vector2d(estimate.zmp[0], estimate.zmp[1]) - true_cop).norm());
  }
}

double TrialWatch::lowest_corner_m(std::size_t foot) const {
  const Eigen::Isometry3d& sole = run_.plant().ground_contact().sole[foot];
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& corner : run_.robot().feet[foot].corners_m())
    lowest_m = std::min(lowest_m, up_.dot(sole * Eigen::Vector3d(corner.x(), corner.y(), 0.0)));
  return lowest_m;
}

void TrialWatch::watch_feet(double time_s) {
  if (!trial_.push || time_s < trial_.push->at_s - kTolerance_s) {
    return;
  }
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const Eigen::Vector3d& place_m = run_.plant().ground_contact().sole[foot].translation();
    if (!feet_noted_) {
      feet_at_push_m_[foot] = place_m;
      lowest_at_push_m_[foot] = lowest_corner_m(foot);
      continue;
    }
    const Eigen::Vector3d moved_m = place_m - feet_at_push_m_[foot];
    outcome_.foot_moved_m = std::max(outcome_.foot_moved_m, (moved_m - up_ * up_.dot(moved_m)).norm());
    outcome_.foot_lifted_m =
        std::max(outcome_.foot_lifted_m, lowest_corner_m(foot) - lowest_at_push_m_[foot]);
  }
  feet_noted_ = true;
}

TrialOutcome TrialWatch::outcome() const {
  TrialOutcome outcome = outcome_;
  if (progress_s_ > 0.0) {
    outcome.mean_velocity = progress_ / progress_s_;
  }
  if (zmp_error_m_.count() > 0) {
    outcome.zmp_error_rms_m = zmp_error_m_.value();
  }
  if (trial_.watches_fall) {
    outcome.fall = fall_;
  }
  if (trial_.times_compute) {
    outcome.batch_compute_p99_us = run_.main_controller().statistics().batch_compute_us.p99;
  }
  return outcome;
}

}  // namespace gaitway::tools
