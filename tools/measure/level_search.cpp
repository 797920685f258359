// Tries levels upwards from the floor; downwards where the floor does not hold.
#include "tools/measure/level_search.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace gaitway::tools {

LevelTally::LevelTally(int seeds, bool all_matter)
    : verdicts_(static_cast<std::size_t>(seeds)), all_matter_(all_matter) {}

void LevelTally::note(int seed_index, bool passed) {
  verdicts_.at(static_cast<std::size_t>(seed_index)) = passed;
}

int LevelTally::judged() const noexcept {
  int failures = 0, count = 0;
  for (const std::optional<bool>& verdict : verdicts_) {
    if (!verdict) {
      break;
    }
    ++count;
    failures += *verdict ? 0 : 1;
    if (!all_matter_ && failures > allowed_failures(seeds())) {
      break;
    }
  }
  return count;
}

int LevelTally::passed() const noexcept {
  const auto end = verdicts_.begin() + judged();
  return static_cast<int>(std::count(verdicts_.begin(), end, std::optional<bool>(true)));
}

bool LevelTally::decided() const noexcept {
  return judged() == seeds() || (!all_matter_ && judged() - passed() > allowed_failures(seeds()));
}

bool LevelTally::holds() const noexcept {
  return judged() == seeds() && seeds() - passed() <= allowed_failures(seeds());
}

LevelSearch::LevelSearch(std::vector<double> levels, std::size_t floor)
    : levels_(std::move(levels)), floor_(floor), next_(floor) {
  if (floor_ >= levels_.size() || !std::ranges::is_sorted(levels_, std::less_equal<>())) {
    throw std::invalid_argument("a level search needs ascending levels, and its floor among them");
  }
}

void LevelSearch::judged(bool holds) {
  const std::size_t level = next_.value();
  next_.reset();
  if (holds) {
    limit_ = level;
    // Below the floor the first one that holds is the limit: the one above has failed.
    if (level >= floor_ && level + 1 < levels_.size()) {
      next_ = level + 1;
    }
  } else if (level <= floor_ && level > 0) {
    next_ = level - 1;
  }
}

std::optional<double> LevelSearch::limit() const noexcept {
  return limit_ ? std::optional(levels_[*limit_]) : std::nullopt;
}

bool LevelSearch::open_ended() const noexcept {
  return limit_ && *limit_ + 1 == levels_.size();
}

}  // namespace gaitway::tools
