// What became of what a run was asked: whether the robot stayed up, and whether it went where it was told to
// go.
#pragma once

#include <cstdint>
#include <string>

#include "tools/run/run_metrics.hpp"

namespace gaitway::tools {

struct BatchCount {
  std::uint64_t handed_over = 0, refused = 0;
};

struct RunOutcome {
  enum class Verdict { done, not_done, fell };
  Verdict verdict = Verdict::done;
  std::string text;  // one line, for people
};

// Not done: less than half of the commanded way or turn (start-ups not counted), more than a tenth of the
// batches refused, or none handed over at all.
[[nodiscard]] RunOutcome outcome_of(const RunMetrics& metrics, const BatchCount& batches, double virtual_s);

// Of the program.
[[nodiscard]] int exit_code(RunOutcome::Verdict verdict) noexcept;
// For summary.json.
[[nodiscard]] const char* name(RunOutcome::Verdict verdict) noexcept;

}  // namespace gaitway::tools
