// Edit distance, one row of the table at a time.
#include "gaitway/input/nearest_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace gaitway::input {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::vector<std::size_t> next(b.size() + 1, i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      next[j + 1] = std::min({row[j] + (a[i] == b[j] ? 0 : 1), row[j + 1] + 1, next[j] + 1});
      if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j]) {
        next[j + 1] = std::min(next[j + 1], before[j - 1] + 1);
      }
    }
    before = std::move(row);
    row = std::move(next);
  }
  return row.back();
}

std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> candidates) {
  const auto nearer = [name](const std::string& a, const std::string& b) {
    return edit_distance(name, a) < edit_distance(name, b);
  };
  const auto best = std::min_element(candidates.begin(), candidates.end(), nearer);
  if (best == candidates.end() || edit_distance(name, *best) > std::max(name.size(), best->size()) / 2) {
    return std::nullopt;
  }
  return *best;
}

std::string suggest(std::string_view name, std::span<const std::string> candidates) {
  if (const auto nearest = nearest_name(name, candidates)) {
    return fmt::format("Did you mean '{}'?", *nearest);
  }
  return candidates.empty() ? "There is none." : fmt::format("Known here: {}.", fmt::join(candidates, ", "));
}

}  // namespace gaitway::input
