// Counting faults, and when there have been enough of them.
#include "gaitway/manager/containment.hpp"

#include <utility>

namespace gaitway::core {

std::string_view service_state_name(ServiceState state) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"works", "failing", "out of service", "stopped"};
  return kNames[static_cast<std::size_t>(state)];
}

Containment::Containment(const ContainmentSettings& settings, Period period, FallbackSet fallbacks)
    : give_up_(settings.give_up),
      period_(period),
      budget_ns_(step_budget_ns(settings, period == Period::batch)),
      fallbacks_(std::move(fallbacks)) {}

bool Containment::is_news(const Tick& tick, Recovery recovery) noexcept {
  constexpr std::int64_t kBetween_ns = 1'000'000'000;
  const bool told = recovery == recovery_ || (recovery == Recovery::under_way && recovery_ == Recovery::lost);
  const bool news = !told || (recovery != Recovery::awaited && recovery != Recovery::under_way);
  const bool its_own = recovery == Recovery::not_needed || recovery == Recovery::awaited;
  if (!news || !give_up_.never || !its_own) {
    return news;
  }
  if (told_ns_ >= 0 && tick.now_ns - told_ns_ < kBetween_ns) {
    return false;
  }
  told_ns_ = tick.now_ns;
  return true;
}

bool Containment::is_one_too_many(const Tick& tick) noexcept {
  if (give_up_.never) {
    return false;
  }
  fault_ns_[faults_ % fault_ns_.size()] = tick.now_ns;
  ++faults_;
  ++ruled_in_a_row_;
  if (period_ == Period::batch) {
    return ruled_in_a_row_ >= static_cast<std::uint64_t>(give_up_.batches);
  }
  const auto wanted = static_cast<std::uint64_t>(give_up_.faults);
  if (faults_ < wanted) {
    return false;
  }
  reason_ = {wanted, fault_ns_[(faults_ - wanted) % fault_ns_.size()]};
  return tick.now_ns - reason_.since_ns <= give_up_.within_ns;
}

bool Containment::note_fault(const Tick& tick, bool overrun, Recovery recovery) noexcept {
  failing_since_ns_ = in_a_row_ == 0 ? tick.now_ns : failing_since_ns_;
  ++in_a_row_;
  recovery_ = recovery;
  reason_ = {in_a_row_, failing_since_ns_};
  overruns_ += overrun ? 1U : 0U;
  const bool given_up =
      recovery == Recovery::given_up ||
      ((recovery == Recovery::not_needed || recovery == Recovery::awaited) && is_one_too_many(tick));
  state_ = given_up ? ServiceState::out_of_service : ServiceState::failing;
  return given_up;
}

std::uint64_t Containment::note_success(const Tick& tick) noexcept {
  const std::uint64_t ended = in_a_row_;
  in_a_row_ = ruled_in_a_row_ = 0;
  recovery_ = Recovery::not_needed;
  if (state_ != ServiceState::stopped) {
    state_ = ServiceState::works;
    fallbacks_.follow(tick);
  }
  return ended;
}

}  // namespace gaitway::core
