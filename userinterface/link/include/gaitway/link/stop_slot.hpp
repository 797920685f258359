// Stops, beside everything else: counts that only rise, and go round, so there is nothing that could be full.
#pragma once

#include <cstdint>
#include <optional>

#include "gaitway/link/messages.hpp"

namespace gaitway::link {

enum class StopKind : std::uint8_t { stop, emergency_hold, emergency_soft };

// The module's side. What is asked for is said at once, ahead of everything, and again every `stop_repeat_ns`
// until it is known to be obeyed. Unlike an order a stop does not become too old: one that was asked for
// while the link was cut is the first thing that the controller hears when it is there again.
class StopAsker {
 public:
  // `settled`: where it begins to count.
  explicit StopAsker(std::int64_t repeat_ns, const StopCounts& settled = {}) noexcept
      : repeat_ns_(repeat_ns), asked_(settled), obeyed_(settled) {}

  void ask(StopKind kind) noexcept;
  void on_answer(const StopAnswer& answer) noexcept;
  // What to send now; nothing while all is obeyed or has just been said.
  std::optional<StopMessage> next(std::int64_t now_ns) noexcept;
  // For a new session: what is not obeyed is said again at once.
  void reset() noexcept { said_ns_.reset(); }

  [[nodiscard]] const StopCounts& asked() const noexcept { return asked_; }
  [[nodiscard]] const StopCounts& obeyed() const noexcept { return obeyed_; }

 private:
  std::int64_t repeat_ns_;
  StopCounts asked_, obeyed_;
  std::optional<std::int64_t> said_ns_;
};

// The controller's side: counts each module's stop once, however often it is said, and over sessions.
class StopListener {
 public:
  // A session begins with the module `boot`.
  void meet(std::uint64_t boot) noexcept;
  // `boot`: of the module that says so.
  void on_stop(const StopMessage& stop, std::uint64_t boot) noexcept;
  // Stops of all modules since this was made: for the topic `stop_request`.
  [[nodiscard]] const StopCounts& asked() const noexcept { return asked_; }
  // The same of the module that is linked now, in its own counts.
  [[nodiscard]] const StopCounts& heard() const noexcept { return heard_; }
  // Which of them are obeyed: from the topic `stop_answer`.
  void obeyed(const StopCounts& obeyed) noexcept;
  // What to answer now; nothing while nobody asked and nothing has changed.
  std::optional<StopAnswer> next() noexcept;

 private:
  std::uint64_t boot_ = 0;       // 0: a module that has said none yet
  StopCounts heard_, answered_;  // of the module `boot_`, in its counts
  StopCounts asked_, obeyed_;
  bool answer_due_ = false;
};

}  // namespace gaitway::link
