// Carries out pushes that programs ask for.
#pragma once

#include <cstdint>
#include <vector>

#include "gaitway/simulation/control_messages.hpp"
#include "gaitway/simulator/cosimulation.hpp"

namespace gaitway::simulator {

class PushTaker {
 public:
  static constexpr std::size_t kMostPushes = 8;  // at once: more than people have hands, and no flood

  // `run` outlives it.
  explicit PushTaker(Cosimulation& run) : run_(run) {}

  // What was done, as a scenario does it again: it begins in the millisecond that comes next. Throws
  // std::invalid_argument: why not.
  ScenarioEvent take(const simulation::Push& asked);

 private:
  Cosimulation& run_;
  std::vector<std::int64_t> ends_ns_;  // of the pushes under way
};

}  // namespace gaitway::simulator
