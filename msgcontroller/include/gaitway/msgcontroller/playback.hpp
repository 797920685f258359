// What the joints are told to play: the running cycle's eight points, the prepared ones of the next cycle,
// and the newest accepted plan whose safe tail takes over when no newer batch arrives.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "gaitway/msgclient/hand_over.hpp"
#include "gaitway/msgclient/mails.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgcontroller {

// A hand-over in counts: the batch and its safe tail as the joints will count them. Rounding each absolute
// point, and sending differences of rounded points, is the error feedback: what one point loses, the next one
// gains.
struct CountPlan {
  std::uint32_t sequence = 0;  // 0: none
  int joint_count = 0;
  int point_count = 0;  // batch and tail
  std::array<std::array<std::int32_t, kMaxJoints>, kMaxPoints> count{};
  std::array<std::uint8_t, kMaxPoints> support{};
};

// Why a hand-over cannot be sent: which joint, at which point, by how much. Reason::none: it can.
struct CountPlanProblem {
  msgclient::Reason reason = msgclient::Reason::none;
  std::int32_t joint = -1;
  std::int32_t point = -1;
  double counts = 0.0;  // the change that was asked for
};

// Converts a hand-over. `count_rad`: size of a count of each joint. `start_count`: each joint's reference
// where the batch begins. Every change of 10 ms must fit the signed byte of a trajectory frame; nothing is
// clipped.
CountPlanProblem to_counts(const msgclient::HandOver& hand_over, std::span<const double> count_rad,
                           std::span<const std::int32_t> start_count, CountPlan& plan) noexcept;

// Eight points of every joint, absolute counts at the end of each time slot.
struct Segment {
  bool active = false;
  bool toggle = false;  // of its trajectory frames
  std::array<std::array<std::int32_t, kMaxJoints>, kBatchPoints> count{};
  std::array<std::uint8_t, kBatchPoints> support{};
};

class Playback {
 public:
  // `initial_count`: where the joints stand when nothing has been played yet.
  explicit Playback(std::span<const std::int32_t> initial_count) noexcept;

  // Takes an accepted plan: its batch becomes the prepared segment, its tail the one to fall back on.
  void accept(const CountPlan& plan) noexcept;
  // Prepares the next eight points of the tail; false when there is none left.
  bool prepare_from_tail() noexcept;
  // Instead of the plan that was accepted last and has not begun: the tail of the one that runs; if that is
  // over, nothing. False, and nothing changes: no plan was accepted since the cycle began, or none runs.
  bool return_to_running_tail() noexcept;
  // The joints got no SYNC of the cycle that runs: what it was to begin with has not begun. They have gone on
  // along the tail of the batch before, of which they hold so many points, and stand at its end afterwards.
  // What is left of that batch's safe tail follows from there, if it is prepared.
  void leave_to_joints(int tail_points) noexcept;
  // A new cycle begins: the prepared segment becomes the running one; without one, the joints hold.
  void begin_cycle() noexcept;
  void enter_slot(int slot) noexcept { slot_ = slot; }
  // Whether all that is left to play, with its tail, keeps each joint within its tolerance of where it is
  // now.
  [[nodiscard]] bool rests(std::span<const std::int32_t> tolerance_counts) const noexcept;
  // Leaves all of it behind, as at the start; the joints stand at `count`.
  void restart(std::span<const std::int32_t> count) noexcept;
  // A joint is moved by hand while nothing runs or all of it rests: from now on it stands there, and nothing
  // follows what runs.
  void hold(int joint, std::int32_t count) noexcept;

  [[nodiscard]] bool prepared() const noexcept { return prepared_.active; }
  [[nodiscard]] const Segment& running_segment() const noexcept { return running_; }
  // What is with the joints ahead of its start, if anything is.
  [[nodiscard]] const Segment* waiting_segment() const noexcept {
    return prepared_.active ? &prepared_ : nullptr;
  }
  [[nodiscard]] int slot() const noexcept { return slot_; }
  [[nodiscard]] std::uint32_t accepted_sequence() const noexcept { return plan_.sequence; }
  // After leave_to_joints, until a prepared segment begins or they have been through all.
  [[nodiscard]] bool left_to_joints() const noexcept { return alone_.on; }
  // How many points follow the segment that was prepared last until both feet are down: those that the joints
  // should have in advance. 0: both are down where it ends. Nothing: they come down later than after `most`
  // points.
  [[nodiscard]] std::optional<int> points_to_both_feet(int most) const noexcept;
  // Change of a joint at one of these points.
  [[nodiscard]] std::int32_t tail_delta(int joint, int point) const noexcept;
  [[nodiscard]] bool tail_left() const noexcept { return cursor_ < plan_.point_count; }
  [[nodiscard]] int joint_count() const noexcept { return joint_count_; }

  // The reference of a joint at the end of a slot of the running cycle, and where the next segment begins.
  [[nodiscard]] std::int32_t expected_count(int joint, int slot) const noexcept;
  [[nodiscard]] std::span<const std::int32_t> next_start() const noexcept;
  // Change of a joint in a slot of the segment that waits, which starts where the running one (or the hold)
  // ends.
  [[nodiscard]] std::int32_t waiting_delta(int joint, int slot) const noexcept;
  // The same of the running segment.
  [[nodiscard]] std::int32_t running_delta(int joint, int slot) const noexcept;
  // Which feet are meant to carry the robot now: 0 left, 1 right, 2 both.
  [[nodiscard]] std::uint8_t support() const noexcept;

 private:
  // How the joints go on without SYNC.
  struct Alone {
    bool on = false;
    int first = 0;   // point of plan_ that follows their batch
    int points = 0;  // that they have; 0: they hold where the batch ended
    int passed = 0;  // slots from the batch's end to the running cycle's begin
  };
  void prepare(int first_point) noexcept;
  void go_on_alone() noexcept;
  void keep_outgoing_plan() noexcept;
  [[nodiscard]] const std::int32_t* alone_counts(int slot) const noexcept;

  int joint_count_;
  int slot_ = 0;
  bool next_toggle_ = true;
  int cursor_ = 0;  // next point of plan_ to prepare
  CountPlan plan_;
  CountPlan running_plan_;  // the one before plan_, while plan_ has not begun
  int running_cursor_ = 0;
  bool plan_waits_ = false;  // plan_ was accepted in this cycle
  Segment running_, prepared_;
  std::array<std::int32_t, kMaxJoints> held_{};  // where the joints stand when no segment runs
  Alone alone_;
  // As it was when the running cycle began: what the joints have if its SYNC has not reached them.
  CountPlan outgoing_plan_;
  bool outgoing_is_plan_ = true;  // plan_, and not outgoing_plan_
  Alone outgoing_;
  int prepared_from_ = 0;  // point of plan_ that the prepared segment begins with
};

}  // namespace gaitway::msgcontroller
