// The states of a fall.
#include "gaitway/zmp/fall_recognition.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gaitway/facts/facts.hpp"

namespace gaitway::zmp {
namespace {

constexpr int kMostTicks = 1000;        // counters stay there
constexpr double kLoadedShare = 0.04;   // of the weight: with less the feet stand on nothing
constexpr int kCarriedTicks = 20;       // without load: somebody holds the robot
constexpr double kStraight_rad = 0.35;  // a standing robot's trunk leans no further
constexpr double kStandingShare = 0.5;  // of the weight on the feet of one that stands
constexpr int kStandsAfterTicks = 50;
constexpr double kLying_rad = 1.0;
constexpr int kLiesAfterTicks = 50;
constexpr int kImpactPastTicks = 20;  // after the predicted impact

const FallParameters& checked(const FallParameters& parameters) {
  parameters.validate();
  return parameters;
}

void count(int& ticks, bool holds) noexcept {
  ticks = holds ? std::min(ticks + 1, kMostTicks) : 0;
}

}  // namespace

std::array<NumberParameter, 4> FallParameters::numbers() {
  return {{{margin, "fall_margin", "1", 0.0, 2.0,
            "of the tipping state, beyond which no foot can be put down in time"},
           {confirm_s, "fall_confirm", "s", 0.0, 0.2,
            "for so long without a break the robot tips: then it falls"},
           {model.impact_tilt_rad, "fall_impact_tilt", "rad", 0.3, 1.5,
            "tilt of the line from the edge to the CoM when the first link hits the ground"},
           {model.inertia_factor, "fall_inertia", "1", 1.0, 3.0,
            "inertia about the edge, over that of all the mass in the CoM"}}};
}

void FallParameters::validate() const {
  FallParameters copy = *this;
  require_in_range(copy.numbers());
}

FallRecognition::FallRecognition(const FallParameters& parameters)
    : parameters_(checked(parameters)),
      confirm_ticks_(std::max(1, static_cast<int>(std::lround(parameters.confirm_s / facts::kSlot_s)))) {}

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
  count(beyond_ticks_, tipping_.state > parameters_.margin && airborne_ticks_ < kCarriedTicks);
  if (beyond_ticks_ >= confirm_ticks_) {
    begin_fall(inputs);
  } else if (lying_ticks_ >= kLiesAfterTicks) {
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
  } else if (overdue_ticks_ >= kImpactPastTicks || lying_ticks_ >= kLiesAfterTicks) {
    fall_ = Fall::lies;
  }
}

bool FallRecognition::stands_again(const FallInputs& inputs) noexcept {
  count(straight_ticks_,
        inputs.trunk_tilt_rad < kStraight_rad && inputs.load_share > kStandingShare && tipping_.state < 0.0);
  return straight_ticks_ >= kStandsAfterTicks;
}

}  // namespace gaitway::zmp
