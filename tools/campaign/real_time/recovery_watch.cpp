// From sights to times and counts.
#include "tools/campaign/real_time/recovery_watch.hpp"

#include <cmath>

namespace gaitway::tools {
namespace {

constexpr std::int64_t kWindow_ns = 1'000'000'000;
constexpr std::int64_t kOldPlace_ns = 300'000'000;  // the estimate comes each 10 ms: whoever makes it is away
constexpr double kJump_m = 0.05;                    // between two estimates: it would be 5 m/s
constexpr double kOfItsWay = 0.5;
// A trunk that leans like this, for so long, belongs to a robot that lies.
constexpr double kLies_rad = 0.9;
constexpr std::int64_t kLies_ns = 300'000'000;

}  // namespace

void WalkMeter::look(std::int64_t at_ns, double x_m, double y_m) {
  if (!places_.empty()) {
    const Place& last = places_.back();
    const bool is_new_frame = std::hypot(x_m - last.x_m, y_m - last.y_m) > kJump_m;
    if (is_new_frame || at_ns - last.at_ns > kOldPlace_ns) places_.clear();
  }
  places_.push_back({at_ns, x_m, y_m});
  while (places_.size() > 2 && at_ns - places_[1].at_ns >= kWindow_ns) places_.pop_front();
}

bool WalkMeter::walks(std::int64_t now_ns) const {
  if (places_.empty() || now_ns - places_.back().at_ns > kOldPlace_ns) return false;
  const Place &first = places_.front(), &last = places_.back();
  const std::int64_t span_ns = last.at_ns - first.at_ns;
  if (span_ns < kWindow_ns) return false;
  const double way_m = std::hypot(last.x_m - first.x_m, last.y_m - first.y_m);
  return way_m >= kOfItsWay * speed_m_per_s_ * static_cast<double>(span_ns) * 1e-9;
}

void RecoveryWatch::on_fault(std::int64_t at_ns) {
  fault_ns_ = at_ns;
  before_ = losses();
  outcome_ = {};
  was_still_ = false;
  well_since_ns_ = 0;
}

void RecoveryWatch::on_fall(std::int64_t at_ns) {
  if (outcome_.fell) return;
  outcome_.fell = true;
  outcome_.fell_s = since_fault_s(at_ns);
}

void RecoveryWatch::count(const RobotSight& sight) {
  if (sight.counts) {
    late_.look(sight.counts->late);
    refused_.look(sight.counts->refused);
    tails_.look(sight.counts->tail_played);
    joints_.look(sight.counts->left_to_joints);
  }
  if (sight.plugin_faults) plugin_faults_.look(*sight.plugin_faults);
  restarts_.look(sight.restarts);
  lines_.look(sight.lost_lines);
}

void RecoveryWatch::judge(const RobotSight& sight) {
  const double at_s = since_fault_s(sight.at_ns);
  if (!sight.is_commandable) {
    outcome_.was_interrupted = true;
    outcome_.commandable_s.reset();
  } else if (!outcome_.commandable_s) {
    outcome_.commandable_s = outcome_.was_interrupted ? at_s : 0.0;
  }
  const bool is_obeyed = sight.is_commandable && sight.walk_order_ns && *sight.walk_order_ns > fault_ns_;
  if (is_obeyed && !outcome_.order_s) outcome_.order_s = at_s;
  if (!walks_) {
    was_still_ = true;
    outcome_.walks_s.reset();
  } else if (!outcome_.walks_s) {
    outcome_.walks_s = was_still_ ? at_s : 0.0;
  }
  // What was said before the fault says nothing of it.
  if (!sight.all_parts_work || sight.told_ns <= fault_ns_) {
    outcome_.parts_s.reset();
  } else if (!outcome_.parts_s) {
    outcome_.parts_s = at_s;
  }
}

void RecoveryWatch::look(const RobotSight& sight) {
  if (sight.place && sight.place->stamp_ns != place_ns_) {
    place_ns_ = sight.place->stamp_ns;
    meter_.look(sight.at_ns, sight.place->x_m, sight.place->y_m);
  }
  walks_ = meter_.walks(sight.at_ns);
  if (std::abs(sight.lean_rad) < kLies_rad) leans_ns_ = sight.at_ns;
  if (leans_ns_ != 0 && sight.at_ns - leans_ns_ > kLies_ns) on_fall(leans_ns_);
  if (sight.counts) {
    const std::uint64_t stops = sight.counts->stops;
    const bool is_obeyed = stops_ && (stops > *stops_ || (stops < *stops_ && stops > 0));
    if (stop_asked_ns_ != 0 && is_obeyed && !outcome_.stop_s) {
      outcome_.stop_s = static_cast<double>(sight.at_ns - stop_asked_ns_) * 1e-9;
    }
    stops_ = stops;
  }
  count(sight);
  if (fault_ns_ == 0) return;
  judge(sight);
  const bool is_well = walks_ && sight.is_commandable && sight.all_parts_work;
  if (!is_well) {
    well_since_ns_ = 0;
  } else if (well_since_ns_ == 0) {
    well_since_ns_ = sight.at_ns;
  }
}

std::int64_t RecoveryWatch::well_ns(std::int64_t now_ns) const noexcept {
  return well_since_ns_ == 0 ? 0 : now_ns - well_since_ns_;
}

RealTimeLosses RecoveryWatch::losses() const noexcept {
  return {.batches = late_.sum() + refused_.sum(),
          .tail_cycles = tails_.sum(),
          .joint_cycles = joints_.sum(),
          .restarts = restarts_.sum(),
          .plugin_faults = plugin_faults_.sum(),
          .event_lines = lines_.sum()};
}

RealTimeOutcome RecoveryWatch::outcome() const {
  RealTimeOutcome outcome = outcome_;
  outcome.walked_on = !outcome.fell && !was_still_;
  const RealTimeLosses all = losses();
  outcome.lost = {.batches = all.batches - before_.batches,
                  .tail_cycles = all.tail_cycles - before_.tail_cycles,
                  .joint_cycles = all.joint_cycles - before_.joint_cycles,
                  .restarts = all.restarts - before_.restarts,
                  .plugin_faults = all.plugin_faults - before_.plugin_faults,
                  .event_lines = all.event_lines - before_.event_lines};
  return outcome;
}

}  // namespace gaitway::tools
