// The inverted pendulum over each edge of the soles' convex hull, and the states of a fall.
#include "gaitway/zmp/fall_recognition.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/convex_hull.hpp"

namespace gaitway::zmp {
namespace {

using facts::kGravity_m_per_s2;

constexpr double kShortestEdge_m = 1e-4;

struct Pendulum {
  double tilt_rad = 0.0;  // from the vertical above the edge, outwards
  double rate_rad_per_s = 0.0;
  double omega2_per_s2 = 0.0;

  [[nodiscard]] double state() const noexcept {
    return 2.0 * std::sin(0.5 * tilt_rad) + rate_rad_per_s / std::sqrt(omega2_per_s2);
  }
};

Pendulum pendulum_over(const Eigen::Vector3d& edge, const Eigen::Vector2d& outwards, const BodyOverFeet& body,
                       const TippingModel& model) noexcept {
  const Eigen::Vector3d arm = body.com_m - edge;
  const double out = outwards.dot(arm.head<2>());
  const double up = std::max(arm.z(), model.lowest_com_m);
  const double speed_out = outwards.dot(body.com_velocity_m_per_s.head<2>());
  const double length2 = out * out + up * up;
  return {.tilt_rad = std::atan2(out, up),
          .rate_rad_per_s = (speed_out * up - body.com_velocity_m_per_s.z() * out) / length2,
          .omega2_per_s2 = kGravity_m_per_s2 / (std::sqrt(length2) * model.inertia_factor)};
}

double time_to_impact_s(Pendulum pendulum, const TippingModel& model) noexcept {
  double time_s = 0.0;
  for (; pendulum.tilt_rad < model.impact_tilt_rad; time_s += facts::kSlot_s) {
    if (time_s >= model.longest_fall_s) return kNoImpact_s;
    pendulum.rate_rad_per_s += facts::kSlot_s * pendulum.omega2_per_s2 * std::sin(pendulum.tilt_rad);
    pendulum.tilt_rad += facts::kSlot_s * pendulum.rate_rad_per_s;
  }
  return time_s;
}

constexpr int kMostTicks = 1000;       // counters stay there
constexpr double kLoadedShare = 0.04;  // of the weight: with less the feet stand on nothing

constexpr double kStraight_rad = 0.35;  // a standing robot's trunk leans no further
constexpr double kStandingShare = 0.5;  // of the weight on the feet of one that stands

constexpr double kLying_rad = 1.0;
int whole_ticks(double time_s) noexcept {
  return std::max(1, static_cast<int>(std::lround(time_s / facts::kSlot_s)));
}

const FallParameters& checked(const FallParameters& parameters) {
  parameters.validate();
  return parameters;
}

void count(int& ticks, bool holds) noexcept {
  ticks = holds ? std::min(ticks + 1, kMostTicks) : 0;
}

}  // namespace

Tipping tipping_of(const BodyOverFeet& body, const TippingModel& model) noexcept {
  std::array<Eigen::Vector3d, 8> soles;
  for (std::size_t i = 0; i < soles.size(); ++i) soles[i] = body.sole_corner_m[i / 4][i % 4];
  const geometry::ConvexHull<Eigen::Vector3d> hull{soles};
  const std::span<const Eigen::Vector3d> corners = hull.corners();
  Tipping worst;
  worst.state = -std::numeric_limits<double>::infinity();
  worst.time_to_impact_s = kNoImpact_s;
  Pendulum falling;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& from = corners[i];
    const Eigen::Vector3d& to = corners[(i + 1) % corners.size()];
    const Eigen::Vector2d along = (to - from).head<2>();
    const double length_m = along.norm();
    if (!(length_m > kShortestEdge_m)) continue;
    const Eigen::Vector2d outwards = Eigen::Vector2d(along.y(), -along.x()) / length_m;
    // Of a tilted sole the lower end of the edge is the one that touches the ground.
    const Pendulum pendulum = pendulum_over(from.z() < to.z() ? from : to, outwards, body, model);
    if (pendulum.state() > worst.state) {
      worst.state = pendulum.state();
      worst.direction = outwards;
      falling = pendulum;
    }
  }
  if (worst.state > 0.0) worst.time_to_impact_s = time_to_impact_s(falling, model);
  return worst;
}

std::array<NumberParameter, 10> FallParameters::numbers() {
  return {
      {{margin, "fall_margin", "1", 0.0, 2.0,
        "of the tipping state, beyond which no foot can be put down in time"},
       {confirm_s, "fall_confirm", "s", 0.0, 0.2,
        "for so long without a break the robot tips: then it falls"},
       {model.impact_tilt_rad, "fall_impact_tilt", "rad", 0.3, 1.5,
        "tilt of the line from the edge to the CoM when the first link hits the ground"},
       {model.inertia_factor, "fall_inertia", "1", 1.0, 3.0,
        "inertia about the edge, over that of all the mass in the CoM"},
       {model.lowest_com_m, "fall_lowest_com", "m", 1e-3, 1.0,
        "height of the CoM above the edge, from which on the pendulum says something"},
       {model.longest_fall_s, "fall_longest", "s", 0.1, kNoImpact_s,
        "until the impact: of what takes longer none is told"},
       {carried_s, "fall_carried", "s", 0.01, 5.0,
        "without load on the feet: then somebody carries the robot, and it does not fall"},
       {stands_after_s, "fall_stands_after", "s", 0.01, 5.0, "straight on its feet: then it stands again"},
       {lies_after_s, "fall_lies_after", "s", 0.01, 5.0,
        "tilted far, without its weight on the feet: then it lies"},
       {impact_past_s, "fall_impact_past", "s", 0.01, 5.0, "after the predicted impact: then it lies"}}};
}

void FallParameters::validate() const {
  FallParameters copy = *this;
  require_in_range(copy.numbers());
}

FallRecognition::FallRecognition(const FallParameters& parameters)
    : parameters_(checked(parameters)),
      confirm_ticks_(whole_ticks(parameters.confirm_s)),
      carried_ticks_(whole_ticks(parameters.carried_s)),
      stands_after_ticks_(whole_ticks(parameters.stands_after_s)),
      lies_after_ticks_(whole_ticks(parameters.lies_after_s)),
      impact_past_ticks_(whole_ticks(parameters.impact_past_s)) {}

void FallRecognition::update(const FallInputs& inputs) noexcept {
  tipping_ = tipping_of(inputs.body, parameters_.model);
  count(airborne_ticks_, inputs.load_share < kLoadedShare);
  count(lying_ticks_, inputs.trunk_tilt_rad > kLying_rad && inputs.load_share < kStandingShare);
  switch (fall_) {
    case Fall::upright:
      return watch_upright(inputs);
    case Fall::falls:
      return watch_falling(inputs);
    case Fall::lies:
      if (stands_again(inputs)) fall_ = Fall::upright;
      return;
  }
}

void FallRecognition::watch_upright(const FallInputs& inputs) noexcept {
  // The first ticks after the feet have left the ground are still those of a fall.
  count(beyond_ticks_, tipping_.state > parameters_.margin && airborne_ticks_ < carried_ticks_);
  if (beyond_ticks_ >= confirm_ticks_) {
    begin_fall(inputs);
  } else if (lying_ticks_ >= lies_after_ticks_) {
    begin_fall(inputs);
    fall_ = Fall::lies;
  }
}

void FallRecognition::begin_fall(const FallInputs& inputs) noexcept {
  fall_ = Fall::falls;
  direction_rad_ =
      std::remainder(std::atan2(tipping_.direction.y(), tipping_.direction.x()) - inputs.heading_rad,
                     2.0 * std::numbers::pi);
  time_to_impact_s_ = tipping_.time_to_impact_s;
  beyond_ticks_ = straight_ticks_ = overdue_ticks_ = 0;
}

void FallRecognition::watch_falling(const FallInputs& inputs) noexcept {
  // Once told, the impact only comes nearer: on the ground the pendulum says nothing any more.
  time_to_impact_s_ =
      std::clamp(std::min(time_to_impact_s_ - facts::kSlot_s, tipping_.time_to_impact_s), 0.0, kNoImpact_s);
  count(overdue_ticks_, time_to_impact_s_ <= 0.0);
  if (stands_again(inputs)) {
    fall_ = Fall::upright;
  } else if (overdue_ticks_ >= impact_past_ticks_ || lying_ticks_ >= lies_after_ticks_) {
    fall_ = Fall::lies;
  }
}

bool FallRecognition::stands_again(const FallInputs& inputs) noexcept {
  count(straight_ticks_,
        inputs.trunk_tilt_rad < kStraight_rad && inputs.load_share > kStandingShare && tipping_.state < 0.0);
  return straight_ticks_ >= stands_after_ticks_;
}

}  // namespace gaitway::zmp
