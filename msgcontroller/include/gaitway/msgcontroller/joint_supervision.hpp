// Keeps each joint at what it is meant to play: sends it its batches and the tails that follow them, compares
// its feedback, and repairs what was lost.
#pragma once

#include <array>
#include <cstdint>

#include "gaitway/can/messages.hpp"
#include "gaitway/msgcontroller/bus_link.hpp"
#include "gaitway/msgcontroller/playback.hpp"

namespace gaitway::msgcontroller {

class JointSupervision {
 public:
  JointSupervision(BusLink& link, const Playback& playback) noexcept : link_(link), playback_(playback) {}

  void begin_cycle() noexcept;
  // After the playback has entered the slot.
  void enter_slot(int slot) noexcept;
  void take_feedback(int joint, const NetworkWatch::Arrival& arrival) noexcept;

  // The batch that has not started, to every joint, and after it its tail.
  void send_waiting() noexcept;
  // The same to one joint, whose frame somebody may have replaced.
  void repair_waiting(int joint) noexcept;
  // Frames of this kind that have not been sent yet.
  void drop(can::MessageKind kind) noexcept;
  void drop_waiting() noexcept {
    drop(can::MessageKind::trajectory);
    forget_waiting_tail();
  }
  // A tail's frame was on the bus.
  void on_tail_sent(bool toggle) noexcept;
  // The joint does not have every point of the tail that SYNC names.
  void on_tail_missing(int joint) noexcept;
  // Tails that were sent go to this joint once more: it was away, or has lost them.
  void repair_tails(int joint) noexcept;
  void forget_tails() noexcept {
    forget_waiting_tail();
    running_tail_.points = 0;
  }
  // How many points of the running segment's tail every joint holds, or is being sent again; 0 while some
  // joint gets none of them whatever is sent.
  [[nodiscard]] int tail_points() const noexcept;
  [[nodiscard]] bool tail_toggle() const noexcept { return running_tail_.toggle; }
  // What runs, where there is no SYNC and the trajectory frames themselves start it.
  void send_running() noexcept;
  // The joint moves by itself for so many slots from now on: its count may differ.
  void leave_alone(int joint, std::uint32_t slots) noexcept;
  // Every joint gets its absolute count at the end of this slot, whatever it has reported. Not in the last
  // slot of a cycle.
  void set_counts() noexcept;

 private:
  // What was sent in advance for the time after a segment.
  struct SentTail {
    bool toggle = false;
    int points = 0;
    int frames_left = 0;  // that have not been on the bus
    std::array<std::array<std::int8_t, can::kTailPoints>, kMaxJoints> delta{};  // past the last point 0
    [[nodiscard]] int usable_points() const noexcept { return frames_left == 0 ? points : 0; }
  };
  // Of a joint that lacked a tail.
  struct Lack {
    std::uint32_t told = 0;      // slot since start in which it did so last; 0: never
    std::uint32_t repaired = 0;  // slot in which its tails were sent again; 0: never
    int in_a_row = 0;            // times that it did, although it had got its points again
  };
  void start_waiting_tail() noexcept;
  void send_waiting_tail() noexcept;
  [[nodiscard]] int slots_to_end_of_waiting() const noexcept;
  void send_tail(int joint, SentTail& tail, int slots_to_end) noexcept;
  void forget_waiting_tail() noexcept {
    drop(can::MessageKind::tail);
    waiting_tail_.points = 0;
  }
  void send_waiting_trajectory(int joint) noexcept;
  [[nodiscard]] bool plays_as_expected(int joint, const can::Feedback& feedback) const noexcept;
  void resynchronise(int joint) noexcept;
  void restart_points(int joint) noexcept;
  [[nodiscard]] std::int32_t expected_count(int joint) const noexcept {
    return playback_.expected_count(joint, playback_.slot());
  }

  BusLink& link_;
  const Playback& playback_;
  bool waits_for_next_slot_ = false;  // sent before this slot: its feedback can tell whether it has arrived
  // Until this slot since start a joint's count may differ: a repair is on its way, or a manual movement.
  std::array<std::uint32_t, kMaxJoints> resync_until_{};
  // The last slot of the running cycle whose point the joint has after a repair.
  std::array<int, kMaxJoints> covered_until_{};
  SentTail waiting_tail_, running_tail_;
  std::array<Lack, kMaxJoints> lack_{};
};

}  // namespace gaitway::msgcontroller
