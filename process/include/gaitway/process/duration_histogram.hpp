// Percentiles of durations in fixed memory: add() neither allocates nor searches.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace gaitway::process {

struct DurationSummary {  // [µs]
  double p50 = 0.0;
  double p99 = 0.0;
  double max = 0.0;
};

// Buckets grow with the duration: each is at most 1/32 of its lower edge wide. A percentile is its bucket's
// upper edge, but never more than the largest duration, which is kept exactly.
class DurationHistogram {
 public:
  // Negative durations count as 0.
  void add(std::int64_t duration_ns) noexcept {
    const auto ns = static_cast<std::uint64_t>(std::max<std::int64_t>(duration_ns, 0));
    const std::size_t index = bucket(ns);
    ++counts_[index];
    ++row_counts_[index / kPerOctave];
    ++total_;
    largest_ns_ = std::max(largest_ns_, ns);
  }

  [[nodiscard]] std::uint64_t count() const noexcept { return total_; }
  [[nodiscard]] std::int64_t max_ns() const noexcept { return static_cast<std::int64_t>(largest_ns_); }
  // The duration that `share` (0..1) of all don't exceed; 0 when there are none.
  [[nodiscard]] double percentile_ns(double share) const noexcept {
    const auto rank = static_cast<std::uint64_t>(share * static_cast<double>(total_));
    std::uint64_t seen = 0;
    for (std::size_t row = 0; row < kRows; ++row) {
      if (row_counts_[row] == 0 || !is_reached(seen + row_counts_[row], rank)) {
        seen += row_counts_[row];
        continue;
      }
      for (std::size_t i = row * kPerOctave;; ++i) {
        seen += counts_[i];
        if (counts_[i] > 0 && is_reached(seen, rank)) {
          return static_cast<double>(std::min(upper_edge(i), largest_ns_));
        }
      }
    }
    return 0.0;
  }
  [[nodiscard]] DurationSummary summary() const noexcept {
    return {percentile_ns(0.5) * 1e-3, percentile_ns(0.99) * 1e-3, static_cast<double>(largest_ns_) * 1e-3};
  }

 private:
  static constexpr unsigned kBits = 5;  // 32 buckets an octave
  static constexpr std::size_t kPerOctave = std::size_t{1} << kBits;
  static constexpr std::size_t kRows = 36;  // up to 2^40 ns = 18 min; longer ones fall into the last bucket
  static constexpr std::size_t kBuckets = kPerOctave * kRows;

  [[nodiscard]] bool is_reached(std::uint64_t seen, std::uint64_t rank) const noexcept {
    return seen > rank || seen == total_;
  }

  static constexpr std::size_t bucket(std::uint64_t ns) noexcept {
    if (ns < kPerOctave) {
      return static_cast<std::size_t>(ns);
    }
    const unsigned octave = static_cast<unsigned>(std::bit_width(ns)) - 1 - kBits;  // ns >> octave is 32..63
    const std::size_t index = octave * kPerOctave + static_cast<std::size_t>(ns >> octave);
    return std::min(index, kBuckets - 1);
  }
  static constexpr std::uint64_t upper_edge(std::size_t index) noexcept {
    if (index < 2 * kPerOctave) {
      return index;
    }
    const std::size_t octave = index / kPerOctave - 1;
    const std::uint64_t mantissa = index - octave * kPerOctave;
    return ((mantissa + 1) << octave) - 1;
  }

  std::array<std::uint64_t, kBuckets> counts_{};
  std::array<std::uint64_t, kRows> row_counts_{};  // of kPerOctave buckets each: a percentile skips rows
  std::uint64_t total_ = 0;
  std::uint64_t largest_ns_ = 0;
};

}  // namespace gaitway::process
