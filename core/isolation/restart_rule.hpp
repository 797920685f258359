// When the process of a plug-in that was lost is replaced, and when no more.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "gaitway/isolation/settings.hpp"

namespace gaitway::core {

// Times are the robot's, so that each run of one seed does the same.
class RestartRule {
 public:
  RestartRule(const IsolationOptions& options, bool serves_network) noexcept
      : options_(options), serves_network_(serves_network) {}

  void note_start(std::int64_t now_ns) noexcept { started_ns_[starts_++ % started_ns_.size()] = now_ns; }
  void note_return(std::int64_t now_ns) noexcept { returned_ns_ = now_ns; }
  [[nodiscard]] bool has_started_again() const noexcept { return starts_ > 0; }

  // Replacements within the window.
  [[nodiscard]] std::uint64_t recent(std::int64_t now_ns) const noexcept {
    const std::uint64_t known = std::min<std::uint64_t>(starts_, started_ns_.size());
    return static_cast<std::uint64_t>(
        std::count_if(started_ns_.begin(), started_ns_.begin() + static_cast<std::ptrdiff_t>(known),
                      [&](std::int64_t at) { return now_ns - at < options_.replacement_window_ns; }));
  }
  [[nodiscard]] bool gives_up(std::int64_t now_ns) const noexcept {
    return !serves_network_ && recent(now_ns) >= options_.replacements;
  }
  // Of a loss now. One that serves the network is always replaced, or whoever can end it could shut the door;
  // but the oftener the later. `ran`: it was in service.
  [[nodiscard]] std::int64_t delay_ns(std::int64_t now_ns, bool ran) noexcept {
    if (!serves_network_) {
      return options_.restart_delay_ns;
    }
    if (ran && now_ns - returned_ns_ >= options_.replacement_window_ns) {
      losses_in_a_row_ = 0;
    }
    const std::int64_t delay_ns = options_.restart_delay_ns << std::min(losses_in_a_row_, kMostDoublings);
    ++losses_in_a_row_;
    return std::min(delay_ns, kLongest_ns);
  }

 private:
  static constexpr std::int64_t kLongest_ns = 800'000'000;
  static constexpr std::uint32_t kMostDoublings = 8;

  const IsolationOptions& options_;
  const bool serves_network_;
  std::array<std::int64_t, 8> started_ns_{};  // ring of the last ones
  std::uint64_t starts_ = 0;
  std::int64_t returned_ns_ = 0;
  std::uint32_t losses_in_a_row_ = 0;  // that came soon after the one before
};

}  // namespace gaitway::core
