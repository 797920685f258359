// Falls, stands, walks and losses of one trial.
#include "tools/campaign/fault_watch.hpp"

#include <algorithm>

#include "gaitway/can/messages.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::tools {
namespace {

using facts::kMillisecond_ns;

constexpr std::int64_t kSample_ns = 10 * kMillisecond_ns;
constexpr double kSample_s = 0.01;
constexpr std::size_t kCycleSamples = 80;  // of a gait cycle of 0.8 s
constexpr double kLeaning_rad = 0.35;      // of the trunk: a robot that walks does not lean so far
// Of a robot that stands: its centre of mass is still, each foot bears its part, and all that for a while.
constexpr double kStill_m_per_s = 0.03;
constexpr double kBornByEach = 0.1;
constexpr double kStillFor_s = 0.2;
// Of a robot that walks: it covers so much of the way that it was told to.
constexpr double kWayCovered = 0.5;

std::uint64_t more(std::uint64_t now, std::uint64_t before) {
  return now >= before ? now - before : now;  // a controller that has restarted counts from zero
}

}  // namespace

FaultWatch::FaultWatch(simulator::Cosimulation& run, double speed_m_per_s)
    : run_(run),
      speed_m_per_s_(speed_m_per_s),
      from_ns_(run.now_ns()),
      estimate_(run.client().read<Estimate>("estimate")),
      before_(counts()) {}

double FaultWatch::since_s() const {
  return static_cast<double>(run_.now_ns() - from_ns_) * 1e-9;
}

void FaultWatch::on_frame(const can::SimulatedBus::Delivery& delivery) {
  if (outcome_.soft_s) return;
  const auto sync = can::decode_sync(run_.message_controller().profile(), delivery.frame);
  const bool soft = sync && sync->softness > 0;
  const auto stop = can::decode_emergency_stop(run_.message_controller().profile(), delivery.frame);
  if (soft || (stop && stop->mode == can::StopMode::soft)) {
    outcome_.soft_s = static_cast<double>(delivery.end_ns - from_ns_) * 1e-9;
  }
}

void FaultWatch::on_millisecond(std::int64_t now_ns) {
  watch_fall();
  if (now_ns % kSample_ns == 9 * kMillisecond_ns) compare_references();
  if (now_ns % kSample_ns == 0 && !outcome_.fell) {
    const simulator::PlantTruth truth = run_.plant().truth();
    watch_stand(truth.com_m);
    watch_walk(truth.base.translation().head<2>());
  }
}

void FaultWatch::watch_fall() {
  const simulator::Plant& plant = run_.plant();
  Estimate estimate{};
  if (!outcome_.told_s && estimate_.read(estimate).status == msgclient::ReadStatus::value &&
      estimate.fall != 0) {
    outcome_.told_s = since_s();
  }
  if (plant.fallen() && !outcome_.fell) {
    outcome_.fell = true;
    outcome_.fell_s = since_s();
  }
  // A standing robot whose shank touches something has not hit the ground.
  if (!outcome_.impact_s && plant.ground_contact().body_force_N > 0.0 &&
      (outcome_.fell || plant.truth().trunk_tilt_rad > kLeaning_rad)) {
    outcome_.impact_s = since_s();
  }
  if (outcome_.fell) ++fallen_ms_;
}

void FaultWatch::watch_stand(const Eigen::Vector3d& com_m) {
  const auto& force_N = run_.plant().ground_contact().normal_force_N;
  const double least_N = kBornByEach * (force_N[0] + force_N[1]);
  const bool still = last_com_m_ && (com_m - *last_com_m_).head<2>().norm() < kStill_m_per_s * kSample_s;
  last_com_m_ = com_m;
  if (outcome_.stands_s) return;
  if (!still || force_N[0] <= least_N || force_N[1] <= least_N) {
    still_since_s_.reset();
    return;
  }
  still_since_s_ = still_since_s_.value_or(since_s());
  if (since_s() - *still_since_s_ >= kStillFor_s) outcome_.stands_s = still_since_s_;
}

void FaultWatch::watch_walk(const Eigen::Vector2d& base_m) {
  way_m_.push_back(base_m);
  if (way_m_.size() <= kCycleSamples) return;
  way_m_.pop_front();
  const double cycle_s = kSample_s * static_cast<double>(kCycleSamples);
  const bool walks = (way_m_.back() - way_m_.front()).norm() >= kWayCovered * speed_m_per_s_ * cycle_s;
  stopped_ = stopped_ || !walks;
  if (!walks) {
    walks_since_s_.reset();
  } else if (!walks_since_s_) {
    walks_since_s_ = since_s();
  }
}

void FaultWatch::compare_references() {
  outcome_.lost.wrong_joints = 0;
  for (int joint = 0; joint < run_.joints().size(); ++joint) {
    const bool as_expected =
        run_.joints().joint(joint).reference_count() == run_.message_controller().expected_count(joint);
    outcome_.lost.wrong_joints += as_expected ? 0 : 1;
  }
}

FaultLosses FaultWatch::counts() const {
  const NetworkState& state = run_.message_controller().state();
  const NetworkHealth& health = run_.message_controller().health();
  return {.late = state.late,
          .refused = state.refused,
          .tail_played = state.tail_played,
          .repaired = state.repaired,
          .resynchronised = state.resynchronised,
          .trajectories_lost = health.trajectories_lost,
          .feedback_lost = health.feedback_lost};
}

FaultOutcome FaultWatch::outcome() const {
  FaultOutcome outcome = outcome_;
  const FaultLosses now = counts();
  outcome.lost.late = more(now.late, before_.late);
  outcome.lost.refused = more(now.refused, before_.refused);
  outcome.lost.tail_played = more(now.tail_played, before_.tail_played);
  outcome.lost.repaired = more(now.repaired, before_.repaired);
  outcome.lost.resynchronised = more(now.resynchronised, before_.resynchronised);
  outcome.lost.trajectories_lost = more(now.trajectories_lost, before_.trajectories_lost);
  outcome.lost.feedback_lost = more(now.feedback_lost, before_.feedback_lost);
  if (!outcome.fell) {
    outcome.walked_on = !stopped_;
    outcome.walks_s = outcome.walked_on ? std::optional(0.0) : walks_since_s_;
  }
  return outcome;
}

void StopWatch::on_frame(const can::SimulatedBus::Delivery& delivery) {
  const auto stop = can::decode_emergency_stop(profile_, delivery.frame);
  if (!sent_ns_ && stop && !delivery.lost) sent_ns_ = delivery.end_ns;
}

}  // namespace gaitway::tools
