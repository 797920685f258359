// What becomes of one part of the robot, a process: when it is started, when it counts as hung, and how long
// it is left alone after it failed. Passive: it is told what happens and the time, and says what is to be
// done.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace gaitway::tools {

// How long a part may go without progress.
struct PartPatience {
  std::int64_t start_ns;  // from its start to its first progress
  std::int64_t hang_ns;   // afterwards
};

// The pause before a start: none at the first failure, then one that doubles. It never gives up.
inline constexpr std::int64_t kFirstPause_ns = 100'000'000, kLongestPause_ns = 10'000'000'000;
// After so much work without a failure the next one counts as the first: pauses are for what fails to start,
// or soon afterwards. Who worked is wanted back at once, however often it is killed.
inline constexpr std::int64_t kGoodWork_ns = 1'000'000'000;

enum class PartState {
  waits,   // to be started: for the end of a pause, or for the part that it needs
  starts,  // without progress so far
  works,
  ends,  // was killed, since it hung, and has not ended yet
  off    // was told to end
};
[[nodiscard]] const char* name_of(PartState state) noexcept;

class PartWatch {
 public:
  explicit PartWatch(PartPatience patience, std::int64_t now_ns = 0)
      : patience_(patience), since_ns_(now_ns), progress_ns_(now_ns) {}

  enum class Wish { nothing, start, kill };
  // `may_start`: what it needs works.
  [[nodiscard]] Wish step(std::int64_t now_ns, bool may_start);
  // When step() has something to do at the latest, unless something is told before.
  [[nodiscard]] std::int64_t due_ns() const noexcept;

  void on_start(std::int64_t now_ns);
  // It lives already: an earlier supervisor started it.
  void on_taken_over(std::int64_t now_ns);
  void on_end(const std::string& how, std::int64_t now_ns);
  // A number that grows with its work; true: this is its first progress since it was started.
  bool on_progress(std::uint64_t count, std::int64_t now_ns);
  // Its progress cannot be seen at the moment, for no fault of its own.
  void on_unseen(std::int64_t now_ns) noexcept;
  // What it works in is new: it is to make progress there within this time, by itself.
  void on_new_ground(std::int64_t within_ns, std::int64_t now_ns);
  // A sign that a part of its own was started again; it goes on meanwhile.
  void on_inner_restart(const std::string& why, std::int64_t now_ns);
  // What was seen of it when it was about to be ended as hung: "was stopped (SIGSTOP)".
  void describe_hang(const std::string& what) { hang_ += what; }
  void switch_off() noexcept { state_ = PartState::off; }

  [[nodiscard]] PartState state() const noexcept { return state_; }
  [[nodiscard]] std::int64_t since_ns() const noexcept { return since_ns_; }  // in this state
  [[nodiscard]] std::int64_t progress_ns() const noexcept { return progress_ns_; }
  [[nodiscard]] std::uint64_t restarts() const noexcept { return restarts_; }
  [[nodiscard]] std::uint64_t failures() const noexcept { return failures_; }  // without good work between
  [[nodiscard]] std::int64_t pause_ns() const noexcept;  // that the next start waits for
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }      // of its last end…
  [[nodiscard]] std::int64_t last_end_ns() const noexcept { return last_end_ns_; }  // …and when; 0: none
  // Since its last end, until it works; empty: it has worked all the time.
  [[nodiscard]] std::optional<std::int64_t> ended_ns() const noexcept { return ended_ns_; }

 private:
  void enter(PartState state, std::int64_t now_ns) noexcept;

  PartPatience patience_;
  PartState state_ = PartState::waits;
  std::int64_t since_ns_ = 0, progress_ns_ = 0, due_ns_ = 0, last_end_ns_ = 0;
  std::int64_t limit_ns_ = 0;  // of the present wait for progress
  std::uint64_t count_ = 0, restarts_ = 0, failures_ = 0;
  bool counted_ = false;  // count_ is of this process
  std::optional<std::int64_t> ended_ns_;
  std::string reason_, hang_;
};

}  // namespace gaitway::tools
