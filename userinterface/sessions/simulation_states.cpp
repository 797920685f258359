// Velocities out of two poses.
#include "simulation_states.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace gaitway::api {
namespace {

using Quaternion = std::array<double, 4>;  // x, y, z, w

// a * b.
Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
          a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
          a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
          a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]};
}

// The shorter way from one attitude to the other as a rotation vector [rad] in the world's frame: axis times
// angle of now * before^-1.
std::array<double, 3> rotation_between(const PoseNumbers& before, const PoseNumbers& now) {
  Quaternion turn =
      product({now[3], now[4], now[5], now[6]}, {-before[3], -before[4], -before[5], before[6]});
  if (turn[3] < 0.0) {
    std::ranges::transform(turn, turn.begin(), [](double value) { return -value; });
  }
  const double sine = std::hypot(turn[0], turn[1], turn[2]);
  const double angle_of_sine = sine > 0.0 ? 2.0 * std::atan2(sine, turn[3]) / sine : 0.0;
  return {turn[0] * angle_of_sine, turn[1] * angle_of_sine, turn[2] * angle_of_sine};
}

const PoseNumbers* pose_in(const std::optional<StateAnswer>& state, const std::string& name) {
  if (!state) {
    return nullptr;
  }
  const auto thing = std::ranges::find(state->things, name, &ThingAnswer::name);
  return thing == state->things.end() ? nullptr : &thing->pose;
}

}  // namespace

void SimulationStates::take(StateAnswer state) {
  const bool is_of_run = newest_ && newest_->run == state.run && newest_->world == state.world;
  if (!is_of_run || state.time_s < newest_->time_s) {
    before_.reset();
  } else if (state.time_s > newest_->time_s) {
    before_ = std::move(newest_);
  }
  newest_ = std::move(state);
}

ros::Twist SimulationStates::twist_of_base() const {
  return twist(before_ ? &before_->base : nullptr, newest_ ? &newest_->base : nullptr);
}

ros::Twist SimulationStates::twist_of_thing(const std::string& name) const {
  return twist(pose_in(before_, name), pose_in(newest_, name));
}

ros::Twist SimulationStates::twist(const PoseNumbers* before, const PoseNumbers* now) const {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  constexpr ros::Vector3 kUnknownVector{kUnknown, kUnknown, kUnknown};
  if (before == nullptr || now == nullptr || newest_->time_s - before_->time_s > kLongestMean_s) {
    return {kUnknownVector, kUnknownVector};
  }
  const double duration_s = newest_->time_s - before_->time_s;
  const auto turned = rotation_between(*before, *now);
  const auto moved = [&](std::size_t axis) { return ((*now)[axis] - (*before)[axis]) / duration_s; };
  return {{moved(0), moved(1), moved(2)},
          {turned[0] / duration_s, turned[1] / duration_s, turned[2] / duration_s}};
}

}  // namespace gaitway::api
