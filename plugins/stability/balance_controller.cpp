// One tick: the situation, which says what may be balanced and learned; then each feedback on its own.
#include "gaitway/stability/balance_controller.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::stability {
namespace {

// A trunk that is to lean further is not balanced: near 90° roll and pitch do not say which way it falls.
constexpr double kMostLean_rad = 1.0;
constexpr double kHeldLean_rad = 0.15;  // more than a slope makes a robot lean that holds its home angles
constexpr double kHeldReturn =
    0.45;  // of the rate at which a bow returns: as the kinematics leads the joints
constexpr std::int64_t kNetworkLifetime_ns = 50'000'000;
// A batch and some delay: when no batches come, nothing that is asked of them is done, and none of it is
// learned.
constexpr double kFresh_s = 0.12;
// Without batches for so long, a lean is no longer learned: nothing takes it out, and it would be learned
// again and again.
constexpr double kShortBreak_s = 0.1;

const BalanceParameters& checked(const BalanceParameters& parameters) {
  parameters.validate();
  return parameters;
}

// Nothing if the message controller is not heard: then every plan counts as accepted. 0: it plays none.
std::optional<std::uint32_t> accepted_sequence(const NetworkState* network, std::int64_t now_ns) noexcept {
  if (network == nullptr || now_ns - network->stamp_ns > kNetworkLifetime_ns) return std::nullopt;
  return network->accepted_sequence;
}

HipStrategy::Batching batching(const MotionPlan& plan) noexcept {
  if (plan.motion == kFallPostureMotion) return HipStrategy::Batching::lies_down;
  return plan.footstep_count > 0 ? HipStrategy::Batching::steps : HipStrategy::Batching::stands;
}

bool leans_little(const PlanMoment& meant) noexcept {
  return std::cos(meant.trunk_attitude_rad[0]) * std::cos(meant.trunk_attitude_rad[1]) >
         std::cos(kMostLean_rad);
}

bool sways(const Estimate& estimate, double calm_rad_per_s) noexcept {
  return !(std::hypot(estimate.angular_velocity[0], estimate.angular_velocity[1]) < calm_rad_per_s);
}

// As far as it is not what a key-frame motion wants.
msgclient::TrunkMotion motion_of(const Estimate& estimate, const PlanMoment& meant) noexcept {
  return {estimate.attitude[0] - meant.trunk_attitude_rad[0],
          estimate.attitude[1] - meant.trunk_attitude_rad[1],
          estimate.angular_velocity[0] - meant.trunk_rate_rad_per_s[0],
          estimate.angular_velocity[1] - meant.trunk_rate_rad_per_s[1]};
}

// The estimate's CoM velocity, forward and left of the base: it is told in the support foot's frame.
Eigen::Vector2d com_velocity_m_per_s(const Estimate& estimate, const PlanMoment& meant) noexcept {
  const std::size_t foot = std::min<std::size_t>(estimate.support, 1);
  return Eigen::Rotation2Dd(meant.foot_turn_rad[foot]) * Eigen::Vector2d(estimate.com_velocity);
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
      trims_(model, parameters_),
      heading_(parameters_),
      speed_(parameters_),
      lean_(parameters_, urdf::home_com_height_m(model)),
      fall_reaction_(parameters_.fall),
      soles_(model, parameters_),
      centring_(parameters_),
      hips_(model, parameters_) {}

void BalanceController::update(std::int64_t now_ns, const BalanceInputs& inputs, TrimCommand& trim,
                               Correction& correction) noexcept {
  correction = Correction{};
  correction.stamp_ns = trim.stamp_ns = now_ns;
  if (inputs.plan != nullptr) timeline_.take(*inputs.plan);
  const Situation now = assess(now_ns, inputs);
  soften(inputs.estimate, now, trim);
  balance_trunk(now, trim);
  learn(now);
  soles_.add_to(trim);
  steer(now, correction);
  bow(now, inputs.plan, accepted_sequence(inputs.network, now_ns), correction);
  if (!timeline_.newest_stays_upright() || hips_.bows()) std::memset(trim.gain, 0, sizeof trim.gain);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    correction.base_attitude_offset[axis] = lean_.offset_rad()[axis];
    correction.com_offset[axis] =
        lean_.com_offset_m()[axis] + centring_.offset_m()[static_cast<Eigen::Index>(axis)];
  }
}

BalanceController::Situation BalanceController::assess(std::int64_t now_ns,
                                                       const BalanceInputs& inputs) noexcept {
  Situation now;
  now.moment = timeline_.at(now_ns, accepted_sequence(inputs.network, now_ns));
  now.meant = now.moment.value_or(PlanMoment{});
  now.bow = hips_.at(now.meant.sequence, now.meant.since_start_s);
  now.bows = hips_.bows();
  now.meant.trunk_attitude_rad.y() += now.bow.angle_rad;
  now.meant.trunk_rate_rad_per_s.y() += now.bow.rate_rad_per_s;
  lean_as_held(inputs, now.meant);
  now.obeys = inputs.network == nullptr || inputs.network->mode != network_state::mode::emergency_stop;
  const bool plays = inputs.network == nullptr || inputs.network->mode == network_state::mode::batches;
  without_batches_s_ = plays ? 0.0 : without_batches_s_ + facts::kSlot_s;
  if (!is_usable(inputs.estimate, now.meant, now_ns)) return now;
  now.estimate = inputs.estimate;
  const std::optional<std::size_t> support = support_of(now.moment, *now.estimate);
  now.support = support.value_or(kBothFeet);
  now.grounded = !is_airborne(*now.estimate) && support && leans_little(now.meant);
  now.stands = now.grounded && now.moment && !now.meant.walking && !now.meant.motion;
  now.sways = sways(*now.estimate, parameters_.calm_rate_rad_per_s);
  return now;
}

// A robot that was held still in a bow stands as it is: the next batches lead its joints out of it, and with
// them goes what its trunk is meant to lean. To bring it upright at once would throw it over.
void BalanceController::lean_as_held(const BalanceInputs& inputs, PlanMoment& meant) noexcept {
  if (inputs.network == nullptr || inputs.estimate == nullptr) return;
  namespace mode = network_state::mode;
  const bool holds = inputs.network->mode == mode::holding || inputs.network->mode == mode::emergency_stop;
  const double less_rad = kHeldReturn * parameters_.bow_return_rad_per_s * facts::kSlot_s;
  for (std::size_t axis = 0; axis < held_lean_rad_.size(); ++axis) {
    const auto row = static_cast<Eigen::Index>(axis);
    double& lean_rad = held_lean_rad_[axis];
    if (holds) {
      const double now_rad = inputs.estimate->attitude[axis] - meant.trunk_attitude_rad[row];
      const bool is_posture =
          std::abs(now_rad) > kHeldLean_rad && std::abs(now_rad) < parameters_.fallen_at_rad;
      lean_rad = is_posture ? now_rad : 0.0;
    } else if (lean_rad != 0.0) {
      meant.trunk_rate_rad_per_s[row] -= std::copysign(less_rad / facts::kSlot_s, lean_rad);
      lean_rad = std::copysign(std::max(std::abs(lean_rad) - less_rad, 0.0), lean_rad);
    }
    meant.trunk_attitude_rad[row] += lean_rad;
  }
}

bool BalanceController::is_usable(const Estimate* estimate, const PlanMoment& meant,
                                  std::int64_t now_ns) const noexcept {
  if (estimate == nullptr) return false;
  if (static_cast<double>(now_ns - estimate->stamp_ns) * 1e-9 > parameters_.estimate_lifetime_s) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(estimate->attitude[axis]) || !std::isfinite(estimate->angular_velocity[axis]))
      return false;
  }
  // A motion that gets up is balanced before the robot counts as upright again.
  return (estimate->fall == estimate::fall::upright || meant.motion) &&
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

// Without an estimate nothing is known of a fall: the softness stays.
void BalanceController::soften(const Estimate* estimate, const Situation& now, TrimCommand& trim) noexcept {
  if (estimate == nullptr) return;
  trim.softness = fall_reaction_.update(
      estimate->fall, {.on_ground = now.meant.on_ground, .fall_posture = now.meant.fall_posture});
}

void BalanceController::balance_trunk(const Situation& now, TrimCommand& trim) noexcept {
  if (!now.grounded) return trims_.update(std::nullopt, now.support, trim);
  msgclient::TrunkMotion trunk = motion_of(*now.estimate, now.meant);
  if (now.bows) {
    trunk.pitch_rate *= parameters_.bow_damping;
  } else if (now.stands && !now.sways) {
    trunk.pitch_rate *= parameters_.calm_damping;
  }
  trims_.update(trunk, now.support, trim);
}

// What is learned from a trunk that is being caught makes the robot fall; and so does a lean that was learned
// while no batch could take it out, as soon as one comes.
void BalanceController::learn(const Situation& now) noexcept {
  if (!now.grounded) return lean_.fade();
  if (now.meant.motion || !now.obeys || (now.sways && !now.meant.walking)) return;
  const Estimate& estimate = *now.estimate;
  if (without_batches_s_ < kShortBreak_s)
    lean_.update(estimate.attitude[0] - held_lean_rad_[0],
                 estimate.attitude[1] - now.bow.angle_rad - held_lean_rad_[1], now.meant.walking);
  if (!now.stands || now.support != kBothFeet || now.bows) return;
  soles_.learn(estimate);
  if (now.meant.since_start_s < kFresh_s)
    centring_.learn(beyond_plan_m(estimate, Eigen::Vector2d(estimate.com), now.meant),
                    beyond_plan_m(estimate, Eigen::Vector2d(estimate.dcm), now.meant));
}

void BalanceController::steer(const Situation& now, Correction& correction) noexcept {
  if (!now.grounded || !now.moment) {
    heading_.pause();
    speed_.pause();
    return;
  }
  const Estimate& estimate = *now.estimate;
  correction.turn_rate_offset =
      heading_.update(estimate.attitude[2], now.meant.commanded_yaw_rad, now.meant.walking);
  Eigen::Map<Eigen::Vector2d>(correction.velocity_offset) = speed_.update(
      now.meant.com_velocity_m_per_s, com_velocity_m_per_s(estimate, now.meant), now.meant.walking);
}

void BalanceController::bow(const Situation& now, const MotionPlan* plan,
                            std::optional<std::uint32_t> accepted_sequence, Correction& correction) noexcept {
  hips_.follow(now.stands ? std::optional(HipStrategy::Standing{now.estimate->dcm[0], now.estimate->com[0]})
                          : std::nullopt);
  if (plan != nullptr)
    hips_.begin_batch(plan->sequence, batching(*plan), plan->tail_count, accepted_sequence);
  correction.bow[1] = hips_.target().angle_rad;
  correction.bow_rate[1] = hips_.target().rate_rad_per_s;
}

}  // namespace gaitway::stability
