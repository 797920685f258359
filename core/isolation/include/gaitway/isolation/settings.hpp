// How the manager deals with the processes of plug-ins: how long it waits for one, what it may use, when it
// is replaced.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "gaitway/instance/configuration.hpp"

namespace gaitway::core {

// A step's own budget is the plug-in's, wherever it runs.
struct IsolationOptions {
  // Virtual time: the step waits for its process, and wall time decides nothing but when a child hangs.
  // False, real time: a step that has no answer within its budget is late.
  bool lock_step = true;
  std::int64_t hang_ns = 100'000'000;            // real time: no answer for so long ends the child
  std::int64_t watchdog_ns = 2'000'000'000;      // lock-step: the same, by the wall clock
  std::int64_t start_limit_ns = 30'000'000'000;  // of a start, by the wall clock
  // From a child's end to its replacement, by the robot's clock: the same in each run of one seed.
  std::int64_t restart_delay_ns = 40'000'000;
  std::uint32_t replacements = 3;  // at most so many (0..8) within the window; then out of service
  std::int64_t replacement_window_ns = 10'000'000'000;
  // Address space of the child. 0: it has no bounds at all; for a plug-in's trial before it runs in-process.
  std::uint64_t memory_limit_bytes = std::uint64_t{512} << 20U;
  std::uint32_t descriptor_limit = 64;  // open files of the child
};

// The same as a plug-in's own settings have it.
[[nodiscard]] inline IsolationOptions options_for(const ChildSettings& settings,
                                                  IsolationOptions options) noexcept {
  constexpr std::int64_t kLinkHang_ns = 500'000'000;
  if (settings.descriptor_limit != 0) {
    options.descriptor_limit = settings.descriptor_limit;
  }
  if (settings.memory_limit_bytes != 0 && options.memory_limit_bytes != 0) {
    options.memory_limit_bytes = settings.memory_limit_bytes;
  }
  if (settings.local_sockets) {
    options.hang_ns = std::max(options.hang_ns, kLinkHang_ns);  // nobody waits for what it does
  }
  return options;
}

// When the process of a plug-in that was lost is replaced, and when no more. Times are the robot's, so that
// each run of one seed does the same.
class RestartRule {
 public:
  RestartRule(const IsolationOptions& options, bool local_sockets) noexcept
      : options_(options), local_sockets_(local_sockets) {}

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
    return !local_sockets_ && recent(now_ns) >= options_.replacements;
  }
  // Of a loss now. One that users reach the robot through is always replaced, but the oftener the later.
  // `ran`: it was in service.
  [[nodiscard]] std::int64_t delay_ns(std::int64_t now_ns, bool ran) noexcept {
    if (!local_sockets_) {
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
  const bool local_sockets_;
  std::array<std::int64_t, 8> started_ns_{};  // ring of the last ones
  std::uint64_t starts_ = 0;
  std::int64_t returned_ns_ = 0;
  std::uint32_t losses_in_a_row_ = 0;  // that came soon after the one before
};

}  // namespace gaitway::core
