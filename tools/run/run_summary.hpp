// summary.json and the table for people: one set of figures, two forms.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gaitway/simulator/cosimulation.hpp"
#include "tools/run/run_outcome.hpp"
#include "tools/run/run_recorder.hpp"

namespace gaitway::tools {

struct RunTiming {
  double wall_s = 0.0;               // of the whole chain with its logs, without pictures and report
  double physics_only_wall_s = 0.0;  // of the bare replay of the same torques
};

[[nodiscard]] RunOutcome outcome_of(const simulator::Cosimulation& run, const RunRecorder& recorder);

nlohmann::ordered_json summary(const simulator::Cosimulation& run, const RunRecorder& recorder,
                               const RunTiming& timing, std::uint64_t seed, double mismatch);

// Lines for a terminal.
std::string summary_table(const nlohmann::ordered_json& summary);

}  // namespace gaitway::tools
