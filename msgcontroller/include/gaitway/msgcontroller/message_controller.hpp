// The message controller: takes batches from the main controller, sends them over the bus slot by slot,
// gathers feedback into topics, repairs what was lost, and plays the safe tail when no batch comes. Passive:
// it is told the time once a millisecond and at each arrival.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "gaitway/can/messages.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/msgclient/hand_over.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgcontroller/count_plan.hpp"
#include "gaitway/msgcontroller/feedback_collector.hpp"
#include "gaitway/msgcontroller/playback.hpp"
#include "gaitway/msgcontroller/transmit_queue.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::msgcontroller {

enum class Mode : std::uint32_t { batches = 0, safe_tail = 1, holding = 2, emergency_stop = 3 };

class MessageController {
 public:
  // Writes its topics through `client`, and talks to the main controller through `adapter`.
  MessageController(const urdf::RobotModel& robot, msgclient::Client& client, msgclient::EmiMessage& adapter);

  // To be called at every millisecond of the clock, before the frames of that millisecond are exchanged.
  void step(std::int64_t now_ns) noexcept;
  // Takes what the main controller has put into the mailboxes; step() does so, too. To be called when a
  // doorbell rings between two milliseconds.
  void take_mails(std::int64_t now_ns) noexcept;
  // A frame arrived from the bus.
  void on_frame(const can::Frame& frame, std::int64_t now_ns) noexcept;
  // The most urgent frame to send; false when there is none.
  bool take_frame(can::Frame& frame) noexcept { return queue_.pop(frame); }
  // Identifier of that frame; past every identifier when there is none.
  [[nodiscard]] std::uint32_t next_id() const noexcept { return queue_.next_id(); }
  // A frame that was offered to the bus and taken back, because a more urgent one came.
  void put_back(const can::Frame& frame) noexcept { queue_.push_front(frame); }

  [[nodiscard]] const NetworkState& state() const noexcept { return state_; }
  [[nodiscard]] Mode mode() const noexcept { return static_cast<Mode>(state_.mode); }
  [[nodiscard]] const TransmitQueue& queue() const noexcept { return queue_; }
  // Reference of a joint at the end of the running slot, in counts.
  [[nodiscard]] std::int32_t expected_count(int joint) const noexcept {
    return playback_.expected_count(joint, playback_.slot());
  }

 private:
  void enter_slot(std::int64_t now_ns) noexcept;
  void begin_cycle() noexcept;
  void send_prepared() noexcept;
  void send_trajectory(int joint) noexcept;
  void resynchronise(int joint) noexcept;
  void supervise(int joint, const can::Feedback& feedback) noexcept;
  void take_hand_over(std::int64_t now_ns) noexcept;
  void judge(const msgclient::HandOver& hand_over, std::int64_t now_ns, msgclient::Answer& answer) noexcept;
  void play(const CountPlan& plan) noexcept;
  void answer(const msgclient::Answer& answer) noexcept;
  void take_user_command(std::int64_t now_ns) noexcept;
  msgclient::Reason move_joint(const msgclient::UserCommandMail& mail) noexcept;
  void publish_feedback(std::int64_t now_ns) noexcept;
  void send_trim(std::span<const double> angle_rad) noexcept;
  void send_own_trim() noexcept;
  void set_mode(Mode mode) noexcept { state_.mode = static_cast<std::uint32_t>(mode); }

  can::Profile profile_;
  int joint_count_;
  std::vector<double> count_rad_, lower_rad_, upper_rad_;
  std::vector<can::NodeId> node_;
  std::array<int, 65> joint_of_node_{};  // -1: no such node
  urdf::TrimSettings trim_settings_;

  msgclient::EmiMessage& adapter_;
  msgclient::Writer<JointStates> joint_states_writer_;
  msgclient::Writer<FootForces> foot_forces_writer_;
  msgclient::Writer<Imu> imu_writer_;
  msgclient::Writer<NetworkState> state_writer_;

  TransmitQueue queue_;
  Playback playback_;
  FeedbackCollector feedback_;
  NetworkState state_{};
  std::unique_ptr<msgclient::HandOver> hand_over_;  // large: kept off the stack
  std::unique_ptr<CountPlan> incoming_;
  msgclient::TrimGains gains_{};
  bool stop_requested_ = false;
  bool prepared_before_last_slot_ = false;  // the last slot's feedback can tell whether its frames arrived
  bool feedback_published_ = true;
  bool trim_sent_this_slot_ = false;
  std::uint32_t slots_since_start_ = 0;
  std::uint32_t last_host_trim_slot_ = 0;   // slot since start in which the main controller last sent a trim
  std::uint32_t moving_by_hand_until_ = 0;  // slot since start at which the last manual movement has ended
  std::uint64_t unanswered_ = 0;
  std::array<std::uint32_t, kMaxJoints>
      resync_until_{};  // until this slot a joint's count may differ: a repair is on its way
};

}  // namespace gaitway::msgcontroller
