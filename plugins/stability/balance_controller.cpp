// Who stands on what now, and is there anything to balance; then each feedback on its own.
#include "gaitway/stability/balance_controller.hpp"

#include <cmath>

namespace gaitway::stability {
namespace {

constexpr double kTick_s = 0.010;
constexpr std::int64_t kNetworkLifetime_ns = 50'000'000;

const BalanceParameters& checked(const BalanceParameters& parameters) {
  parameters.validate();
  return parameters;
}

// Nothing if the message controller is not heard: then every plan counts as accepted. 0: it plays none.
std::optional<std::uint32_t> accepted_sequence(const NetworkState* network, std::int64_t now_ns) noexcept {
  if (network == nullptr || now_ns - network->stamp_ns > kNetworkLifetime_ns) return std::nullopt;
  return network->accepted_sequence;
}

msgclient::TrunkMotion motion_of(const Estimate& estimate) noexcept {
  return {estimate.attitude[0], estimate.attitude[1], estimate.angular_velocity[0],
          estimate.angular_velocity[1]};
}

}  // namespace

BalanceController::BalanceController(const urdf::RobotModel& model, const BalanceParameters& parameters)
    : parameters_(checked(parameters)), trims_(model, parameters), heading_(parameters), lean_(parameters) {}

bool BalanceController::is_usable(const Estimate* estimate, std::int64_t now_ns) const noexcept {
  if (estimate == nullptr) return false;
  if (static_cast<double>(now_ns - estimate->stamp_ns) * 1e-9 > parameters_.estimate_lifetime_s) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(estimate->attitude[axis]) || !std::isfinite(estimate->angular_velocity[axis]))
      return false;
  }
  return std::abs(estimate->attitude[0]) < parameters_.fallen_at_rad &&
         std::abs(estimate->attitude[1]) < parameters_.fallen_at_rad;
}

bool BalanceController::is_airborne(const Estimate& estimate) noexcept {
  const bool contact = estimate.contact[0] != 0 || estimate.contact[1] != 0;
  without_contact_s_ = contact ? 0.0 : without_contact_s_ + kTick_s;
  return without_contact_s_ > parameters_.airborne_after_s;
}

std::optional<std::size_t> BalanceController::support_of(const std::optional<PlanMoment>& moment,
                                                         const Estimate& estimate) noexcept {
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
  if (!is_usable(inputs.estimate, now_ns)) {
    trims_.update(std::nullopt, kBothFeet, trim);
    heading_.pause();
    lean_.fade();
  } else {
    const Estimate& estimate = *inputs.estimate;
    const std::optional<std::size_t> support = support_of(moment, estimate);
    const bool grounded = !is_airborne(estimate) && support.has_value();
    trims_.update(grounded ? std::optional(motion_of(estimate)) : std::nullopt, support.value_or(kBothFeet),
                  trim);
    if (grounded) {
      lean_.update(estimate.attitude[0], estimate.attitude[1]);
    } else {
      lean_.fade();
    }
    if (grounded && moment) {
      correction.turn_rate_offset =
          heading_.update(estimate.attitude[2], moment->base_yaw_rad, moment->walking);
    } else {
      heading_.pause();
    }
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
    correction.base_attitude_offset[axis] = lean_.offset_rad()[axis];
}

}  // namespace gaitway::stability
