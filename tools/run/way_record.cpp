// Steps are measured when the next one lands: by then their foot stands, and nothing has moved it since.
#include "tools/run/way_record.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace gaitway::tools {
namespace {

constexpr double kMillimetres = 1e3, kDegrees = 180.0 / std::numbers::pi;

std::array<double, 3> place_of(const Eigen::Isometry3d& sole) {
  return {sole.translation().x(), sole.translation().y(),
          std::atan2(sole.linear()(1, 0), sole.linear()(0, 0))};
}

double way_m(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  return std::hypot(to[0] - from[0], to[1] - from[1]);
}

double turn_rad(const std::array<double, 3>& from, const std::array<double, 3>& to) {
  return std::abs(std::remainder(to[2] - from[2], 2.0 * std::numbers::pi));
}

const char* name_of(std::uint32_t result) {
  constexpr std::array kNames{"none", "arrived", "cancelled", "refused", "failed"};
  return result < kNames.size() ? kNames[result] : "unknown";
}

}  // namespace

void WayRecord::look(std::int64_t now_ns, const simulator::Plant& plant) {
  const bool was_ended = ended();
  if (!navigation_.read(state_) || !walk_.read(footsteps_)) return;
  take_plan();
  if (footsteps_.landed != landed_) measure_landed(plant);
  if (ended() && !was_ended) ended_s_ = static_cast<double>(now_ns) * 1e-9;
  const std::array left = place_of(plant.ground_contact().sole[0]),
                   right = place_of(plant.ground_contact().sole[1]);
  stand_ = {0.5 * (left[0] + right[0]), 0.5 * (left[1] + right[1]),
            left[2] + 0.5 * std::remainder(right[2] - left[2], 2.0 * std::numbers::pi)};
}

void WayRecord::take_plan() {
  NavigationWay way;
  if (!way_.read(way)) return;
  for (std::uint32_t i = 0; i < std::min<std::uint32_t>(way.step_count, kMaxWaySteps); ++i) {
    const float* const step = way.step[i];
    planned_[way.first + i] = {way.side[i], {double{step[0]}, double{step[1]}, double{step[2]}}};
  }
}

void WayRecord::measure_landed(const simulator::Plant& plant) {
  if (const auto before = planned_.find(landed_); before != planned_.end()) {
    const std::array true_place = place_of(plant.ground_contact().sole[before->second.side]);
    const double off_m = way_m(before->second.pose, true_place);
    placement_m_.add(off_m);
    placement_rad_.add(turn_rad(before->second.pose, true_place));
    worst_m_ = std::max(worst_m_, off_m);
  }
  landed_ = footsteps_.landed;
}

bool WayRecord::ended() const noexcept {
  return asked_ && state_.answered != 0 && state_.state == navigation_state::state::idle;
}

std::string WayRecord::missing() const {
  namespace results = navigation_state::result;
  if (!asked_ || state_.result == results::arrived) return {};
  if (ended() && state_.result == results::cancelled) return {};  // somebody wanted that
  if (!ended()) return fmt::format("the way was not walked to its end, {} steps are left", state_.steps_left);
  return fmt::format("the way was {}: {}", name_of(state_.result),
                     reinterpret_cast<const char*>(state_.text));
}

nlohmann::ordered_json WayRecord::json() const {
  if (!asked_) return nullptr;
  const std::array goal{state_.goal[0], state_.goal[1], state_.goal[2]};
  return {{"result", ended() ? name_of(state_.result) : "not ended"},
          {"text", reinterpret_cast<const char*>(state_.text)},
          {"ended_s", ended_s_},
          {"replans", state_.replans},
          {"footsteps", placement_m_.count()},
          {"placement_rms_mm", placement_m_.value() * kMillimetres},
          {"placement_worst_mm", worst_m_ * kMillimetres},
          {"placement_rms_deg", placement_rad_.value() * kDegrees},
          {"goal_error_mm", way_m(goal, stand_) * kMillimetres},
          {"goal_error_deg", turn_rad(goal, stand_) * kDegrees},
          {"pose_error_mm", way_m({state_.pose[0], state_.pose[1], state_.pose[2]}, stand_) * kMillimetres},
          {"pose_error_deg", turn_rad({state_.pose[0], state_.pose[1], state_.pose[2]}, stand_) * kDegrees}};
}

}  // namespace gaitway::tools
