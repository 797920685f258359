// What one plug-in may cost, how often it may fail, and who stands in for it.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/managed_plugin.hpp"
#include "gaitway/manager/fallback.hpp"
#include "gaitway/plugin/cycle.hpp"

namespace gaitway::core {

enum class ServiceState : std::uint8_t {
  works,
  failing,         // failed in its last step: its fallback stands in
  out_of_service,  // not stepped any more: its fallback stays
  stopped          // not loaded at the start, or stopped since: its fallback stays
};
[[nodiscard]] std::string_view service_state_name(ServiceState state) noexcept;

// All but set-up is for the cycle.
class Containment {
 public:
  Containment() = default;  // stepped without end, no fallback
  Containment(const ContainmentSettings& settings, Period period, FallbackSet fallbacks);

  [[nodiscard]] bool is_over_budget(std::int64_t cost_ns) const noexcept { return cost_ns > budget_ns_; }
  // True: the plug-in is out of service with this fault. While its recovery is under way, that has the say
  // instead of the rule.
  bool note_fault(const Tick& tick, bool overrun, Recovery recovery) noexcept;
  // Whether a fault says more than the one before: not while a plug-in waits for the same recovery.
  // One that is never given up tells of its late steps and refusals once a second at most.
  [[nodiscard]] bool is_news(const Tick& tick, Recovery recovery) noexcept;
  // How many faults in a row have ended with this step.
  std::uint64_t note_success(const Tick& tick) noexcept;
  void stop() noexcept { state_ = ServiceState::stopped; }

  [[nodiscard]] ServiceState state() const noexcept { return state_; }
  [[nodiscard]] bool is_stepped() const noexcept { return state_ <= ServiceState::failing; }
  [[nodiscard]] std::int64_t budget_ns() const noexcept { return budget_ns_; }
  [[nodiscard]] std::uint64_t overruns() const noexcept { return overruns_; }
  [[nodiscard]] std::uint64_t faults_in_a_row() const noexcept { return in_a_row_; }
  [[nodiscard]] std::int64_t failing_since_ns() const noexcept { return failing_since_ns_; }  // this row
  // Why note_fault() gave it up: so many faults since then.
  struct Reason {
    std::uint64_t faults = 0;
    std::int64_t since_ns = 0;
  };
  [[nodiscard]] const Reason& reason() const noexcept { return reason_; }
  [[nodiscard]] FallbackSet& fallbacks() noexcept { return fallbacks_; }
  [[nodiscard]] const FallbackSet& fallbacks() const noexcept { return fallbacks_; }

 private:
  // By the rule, with one more fault.
  [[nodiscard]] bool is_one_too_many(const Tick& tick) noexcept;

  GiveUpRule give_up_;
  Period period_ = Period::tick;
  std::int64_t budget_ns_ = step_budget_ns({}, false);
  FallbackSet fallbacks_;
  ServiceState state_ = ServiceState::works;
  Recovery recovery_ = Recovery::not_needed;  // at the last fault in this row
  Reason reason_;
  std::uint64_t overruns_ = 0;
  std::uint64_t in_a_row_ = 0;
  std::int64_t failing_since_ns_ = 0;
  std::int64_t told_ns_ = -1;                      // of one that is never given up; -1: nothing yet
  std::uint64_t faults_ = 0, ruled_in_a_row_ = 0;  // of those that the rule counts
  std::array<std::int64_t, GiveUpRule::kMostFaults> fault_ns_{};  // the last ones, as a ring
};

}  // namespace gaitway::core
