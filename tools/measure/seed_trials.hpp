// One seed at one level of a row: what is to be played of it, and the pieces in which it may be handed out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tools/measure/gait_table.hpp"

namespace gaitway::tools {

// Its trials count one after the other, up to the first that decides.
struct SeedTrials {
  SeedTrials(const GaitRow& row, double level, std::uint64_t seed);

  const GaitRow* row;  // outlives this
  double level;
  std::uint64_t seed;
  std::vector<Trial> trials;

  // The trials behind this one change nothing.
  [[nodiscard]] bool end_with(const Trial& trial, const TrialOutcome& outcome) const;
};

[[nodiscard]] double seconds_of(std::span<const Trial> trials);

// Trials that follow one another.
struct TrialSeries {
  std::size_t first = 0;
  std::size_t count = 0;
};

// What is best played in one go: trials that share the walk before their pushes, at most 16 of them, so that
// little is lost with whoever plays them; each other trial alone. All trials, in their order.
[[nodiscard]] std::vector<TrialSeries> series_of(std::span<const Trial> trials);

}  // namespace gaitway::tools
