// Finds how far a measure holds: tries the floor first, then goes up level by level until one does not hold,
// or down until one does. A level holds when at least 19 of 20 seeds pass it (all of them, if there are fewer
// than 20).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace gaitway::tools {

// How many of so many seeds may fail a level that still holds.
[[nodiscard]] constexpr int allowed_failures(int seeds) noexcept {
  return seeds / 20;
}

// The verdicts of the seeds at one level. They may come in any order; what is said of the level depends on
// the seeds' own order alone, so that it is the same however many of them run side by side.
class LevelTally {
 public:
  // `all_matter`: the level is not given up before each seed has its verdict.
  LevelTally(int seeds, bool all_matter);

  void note(int seed_index, bool passed);
  // Nothing that is still missing can change the result.
  [[nodiscard]] bool decided() const noexcept;
  [[nodiscard]] bool holds() const noexcept;  // of a level that is decided
  // Seeds that count: all, or up to the one whose failure decided. And how many of them passed.
  [[nodiscard]] int judged() const noexcept;
  [[nodiscard]] int passed() const noexcept;
  [[nodiscard]] int seeds() const noexcept { return static_cast<int>(verdicts_.size()); }

 private:
  std::vector<std::optional<bool>> verdicts_;
  bool all_matter_;
};

class LevelSearch {
 public:
  // `levels`: ascending, each harder than the one before; `floor` is an index into them. Throws
  // std::invalid_argument if it is none, or they do not ascend.
  LevelSearch(std::vector<double> levels, std::size_t floor);

  // The level to try next; none: the search is over.
  [[nodiscard]] std::optional<std::size_t> next() const noexcept { return next_; }
  void judged(bool holds);  // that level

  [[nodiscard]] const std::vector<double>& levels() const noexcept { return levels_; }
  [[nodiscard]] std::size_t floor() const noexcept { return floor_; }
  // Highest level that holds with each one tried below it; none: not even the lowest, or not known yet.
  [[nodiscard]] std::optional<double> limit() const noexcept;
  // The highest level of all holds: the true limit may lie beyond.
  [[nodiscard]] bool open_ended() const noexcept;

 private:
  std::vector<double> levels_;
  std::size_t floor_;
  std::optional<std::size_t> next_;
  std::optional<std::size_t> limit_;
};

}  // namespace gaitway::tools
