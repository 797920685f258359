// Who stands on what now, and is there anything to balance; then each feedback on its own.
#include "gaitway/stability/balance_controller.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::stability {
namespace {

constexpr std::uint32_t kUpright = 0;  // Estimate::fall
// A trunk that is to lean further is not balanced: near 90° roll and pitch do not say which way it falls.
constexpr double kMostLean_rad = 1.0;
constexpr std::int64_t kNetworkLifetime_ns = 50'000'000;
// A batch and some delay: when no batches come, nothing that is asked of them is done, and none of it is
// learned.
constexpr double kFresh_s = 0.12;

const BalanceParameters& checked(const BalanceParameters& parameters) {
  parameters.validate();
  return parameters;
}

// Nothing if the message controller is not heard: then every plan counts as accepted. 0: it plays none.
std::optional<std::uint32_t> accepted_sequence(const NetworkState* network, std::int64_t now_ns) noexcept {
  if (network == nullptr || now_ns - network->stamp_ns > kNetworkLifetime_ns) return std::nullopt;
  return network->accepted_sequence;
}

bool leans_little(const PlanMoment& meant) noexcept {
  return std::cos(meant.trunk_attitude_rad[0]) * std::cos(meant.trunk_attitude_rad[1]) >
         std::cos(kMostLean_rad);
}

// A push of 0.3 N·s turns the trunk faster; the sway of a robot that has just begun to stand is slower. What
// is learned from a trunk that is being caught makes it fall.
bool sways(const Estimate& estimate) noexcept {
  constexpr double kCalm_rad_per_s = 0.2;
  return !(std::hypot(estimate.angular_velocity[0], estimate.angular_velocity[1]) < kCalm_rad_per_s);
}

// As far as it is not what a key-frame motion wants.
msgclient::TrunkMotion motion_of(const Estimate& estimate, const PlanMoment& meant) noexcept {
  return {estimate.attitude[0] - meant.trunk_attitude_rad[0],
          estimate.attitude[1] - meant.trunk_attitude_rad[1],
          estimate.angular_velocity[0] - meant.trunk_rate_rad_per_s[0],
          estimate.angular_velocity[1] - meant.trunk_rate_rad_per_s[1]};
}

// A point of the estimate, in its support foot's frame, less the planned CoM; base axes.
Eigen::Vector2d beyond_plan_m(const Estimate& estimate, const Eigen::Vector2d& point_m,
                              const PlanMoment& meant) noexcept {
  const std::size_t foot = std::min<std::size_t>(estimate.support, 1);
  return Eigen::Rotation2Dd(meant.foot_from_base_rad[foot]) * (point_m - meant.com_in_foot_m[foot]);
}

}  // namespace

BalanceController::BalanceController(const urdf::RobotModel& model, const BalanceParameters& parameters)
    : parameters_(checked(parameters)),
      trims_(model, parameters),
      heading_(parameters),
      speed_(parameters),
      lean_(parameters, urdf::home_com_height_m(model)),
      fall_reaction_(parameters.fall),
      soles_(model, parameters),
      centring_(parameters),
      hips_(model, parameters) {}

bool BalanceController::is_usable(const Estimate* estimate, const PlanMoment& meant,
                                  std::int64_t now_ns) const noexcept {
  if (estimate == nullptr) return false;
  if (static_cast<double>(now_ns - estimate->stamp_ns) * 1e-9 > parameters_.estimate_lifetime_s) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(estimate->attitude[axis]) || !std::isfinite(estimate->angular_velocity[axis]))
      return false;
  }
  // A motion that gets up is balanced before the robot counts as upright again.
  return (estimate->fall == kUpright || meant.motion) &&
         std::abs(estimate->attitude[0] - meant.trunk_attitude_rad[0]) < parameters_.fallen_at_rad &&
         std::abs(estimate->attitude[1] - meant.trunk_attitude_rad[1]) < parameters_.fallen_at_rad;
}

bool BalanceController::is_airborne(const Estimate& estimate) noexcept {
  const bool contact = estimate.contact[0] != 0 || estimate.contact[1] != 0;
  without_contact_s_ = contact ? 0.0 : without_contact_s_ + facts::kSlot_s;
  return without_contact_s_ > parameters_.airborne_after_s;
}

std::optional<std::size_t> BalanceController::support_of(const std::optional<PlanMoment>& moment,
                                                         const Estimate& estimate) noexcept {
  if (moment && moment->support > kBothFeet) return std::nullopt;
  if (moment) return moment->support;
  const bool left = estimate.contact[0] != 0;
  const bool right = estimate.contact[1] != 0;
  if (left && right) return kBothFeet;
  if (left) return kLeftFoot;
  if (right) return kRightFoot;
  return std::nullopt;
}

void BalanceController::update(std::int64_t now_ns, const BalanceInputs& inputs, TrimCommand& trim,
                               Correction& correction) noexcept {
  if (inputs.plan != nullptr) timeline_.take(*inputs.plan);
  const std::optional<PlanMoment> moment = timeline_.at(now_ns, accepted_sequence(inputs.network, now_ns));
  correction = Correction{};
  correction.stamp_ns = now_ns;
  trim.stamp_ns = now_ns;
  // Without an estimate nothing is known of a fall: the softness stays.
  if (inputs.estimate != nullptr)
    trim.softness = fall_reaction_.update(inputs.estimate->fall,
                                          {moment && moment->on_ground, moment && moment->fall_posture});
  PlanMoment meant = moment.value_or(PlanMoment{});
  const msgclient::Bow bow = hips_.at(meant.sequence, meant.since_start_s);
  meant.trunk_attitude_rad.y() += bow.angle_rad;
  meant.trunk_rate_rad_per_s.y() += bow.rate_rad_per_s;
  bool stands = false;
  if (!is_usable(inputs.estimate, meant, now_ns)) {
    trims_.update(std::nullopt, kBothFeet, trim);
    heading_.pause();
    speed_.pause();
    lean_.fade();
  } else {
    const Estimate& estimate = *inputs.estimate;
    const std::optional<std::size_t> support = support_of(moment, estimate);
    const bool grounded = !is_airborne(estimate) && support.has_value() && leans_little(meant);
    stands = grounded && moment && !meant.walking && !meant.motion;
    msgclient::TrunkMotion trunk = motion_of(estimate, meant);
    if (hips_.bows()) {
      trunk.pitch_rate *= parameters_.bow_damping;
    } else if (stands && !sways(estimate)) {
      trunk.pitch_rate *= parameters_.calm_damping;
    }
    trims_.update(grounded ? std::optional(trunk) : std::nullopt, support.value_or(kBothFeet), trim);
    if (grounded && !meant.motion && (meant.walking || !sways(estimate))) {
      lean_.update(estimate.attitude[0], estimate.attitude[1] - bow.angle_rad, meant.walking);
      if (stands && support == kBothFeet && !hips_.bows()) {
        soles_.learn(estimate);
        if (meant.since_start_s < kFresh_s)
          centring_.learn(beyond_plan_m(estimate, Eigen::Vector2d(estimate.com), meant),
                          beyond_plan_m(estimate, Eigen::Vector2d(estimate.dcm), meant));
      }
    } else if (!grounded) {
      lean_.fade();
    }
    if (grounded && moment) {
      correction.turn_rate_offset =
          heading_.update(estimate.attitude[2], moment->commanded_yaw_rad, moment->walking);
      const Eigen::Map<const Eigen::Vector2d> com_velocity(estimate.com_velocity);
      Eigen::Map<Eigen::Vector2d>(correction.velocity_offset) =
          speed_.update(moment->com_velocity_m_per_s, com_velocity, moment->walking);
    } else {
      heading_.pause();
      speed_.pause();
    }
  }
  soles_.add_to(trim);
  hips_.follow(stands ? std::optional(HipStrategy::Standing{inputs.estimate->dcm[0], inputs.estimate->com[0]})
                      : std::nullopt);
  if (inputs.plan != nullptr)
    hips_.begin_batch(inputs.plan->sequence, inputs.plan->footstep_count > 0, inputs.plan->tail_count);
  correction.bow[1] = hips_.target().angle_rad;
  correction.bow_rate[1] = hips_.target().rate_rad_per_s;
  if (!timeline_.newest_stays_upright() || hips_.bows()) std::memset(trim.gain, 0, sizeof trim.gain);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    correction.base_attitude_offset[axis] = lean_.offset_rad()[axis];
    correction.com_offset[axis] =
        lean_.com_offset_m()[axis] + centring_.offset_m()[static_cast<Eigen::Index>(axis)];
  }
}

}  // namespace gaitway::stability
