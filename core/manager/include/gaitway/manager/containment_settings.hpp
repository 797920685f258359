// What the configuration says about a plug-in that fails: its fallback, its time budget, and when it is given
// up.
#pragma once

#include <cstdint>
#include <string_view>

namespace gaitway::input {
class YamlValue;
}

namespace gaitway::core {

// Who writes a plug-in's topics while it fails.
enum class FallbackKind : std::uint8_t {
  by_topics,         // the default: as its topics ask for
  none,              // nobody: the last values stay, and no batch is handed over that depends on them
  estimate,          // estimate from encoders and IMU
  trims_from_gains,  // trims go over to what the last gains make of the estimate, corrections fade to zero
  trims_to_zero,     // trims and corrections fade to zero
  stop,              // walk command: stop and stand
  safe_tail          // nobody: no batch is handed over, and the message controller plays its safe tail
};
[[nodiscard]] std::string_view fallback_kind_name(FallbackKind kind) noexcept;

// When a plug-in is put out of service.
struct GiveUpRule {
  static constexpr int kMostFaults = 100;
  int faults = 20;                         // of a plug-in that is stepped every tick: so many ...
  std::int64_t within_ns = 2'000'000'000;  // ... within this time
  int batches = 8;                         // of one that is stepped every batch: so many in a row
  bool never = false;                      // instead
};

// Under a plug-in's entry:
//   fallback: estimate | trims_from_gains | trims_to_zero | stop | safe_tail | none
//   budget: 200 us
//   give_up_after: {faults: 20, within: 2 s, batches: 8}
struct ContainmentSettings {
  FallbackKind fallback = FallbackKind::by_topics;
  std::int64_t budget_ns = 0;  // of a step; 0: the default of its period
  GiveUpRule give_up = {};
};

inline constexpr std::int64_t kTickBudget_ns = 2'000'000;
inline constexpr std::int64_t kBatchBudget_ns = 5'000'000;

// Of a step of a plug-in with these settings; `every_batch`: it is stepped in ticks that prepare a batch
// alone.
[[nodiscard]] constexpr std::int64_t step_budget_ns(const ContainmentSettings& settings,
                                                    bool every_batch) noexcept {
  return settings.budget_ns > 0 ? settings.budget_ns : every_batch ? kBatchBudget_ns : kTickBudget_ns;
}

// Reads these three keys of a plug-in's entry. Throws input::InputError.
ContainmentSettings read_containment(const input::YamlValue& plugin);

}  // namespace gaitway::core
