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
#include "gaitway/msgcontroller/network_watch.hpp"
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
  // Takes what the main controller has put into the mailboxes, and people's commands from the queue
  // `user_command`; step() does so, too. To be called when a
  // doorbell rings between two milliseconds.
  void take_mails(std::int64_t now_ns) noexcept;
  // The state of this controller's own station, when it may have changed. While it is off the bus, nothing
  // waits: what would go out afterwards would be stale. Back on it, the prepared batch is sent once more.
  void on_bus_state(can::BusState state, can::ErrorCounters errors, std::int64_t now_ns) noexcept;
  // A frame of another station arrived from the bus.
  void on_frame(const can::Frame& frame, std::int64_t now_ns) noexcept;
  // The most urgent frame to send; false when there is none.
  bool take_frame(can::Frame& frame) noexcept { return queue_.pop(frame); }
  // Identifier of that frame; past every identifier when there is none.
  [[nodiscard]] std::uint32_t next_id() const noexcept { return queue_.next_id(); }
  // Whether that frame may go to a port that cannot take it back. While joints answer a SYNC, every frame
  // less urgent than their feedback would lose arbitration to all of them, and whatever is handed over
  // meanwhile, an emergency stop above all, would have to wait behind it: it may go once the feedback has
  // come and the bus has been quiet, or feedback has had its time.
  [[nodiscard]] bool next_finds_quiet_bus(std::int64_t now_ns) const noexcept;
  // A frame that was offered to the bus and taken back, because a more urgent one came.
  void put_back(const can::Frame& frame) noexcept { queue_.push_front(frame); }

  [[nodiscard]] const NetworkState& state() const noexcept { return state_; }
  [[nodiscard]] const NetworkHealth& health() const noexcept { return watch_.health(); }
  [[nodiscard]] const can::Profile& profile() const noexcept { return profile_; }
  [[nodiscard]] Mode mode() const noexcept { return static_cast<Mode>(state_.mode); }
  [[nodiscard]] const TransmitQueue& queue() const noexcept { return queue_; }
  // Reference of a joint at the end of the running slot, in counts.
  [[nodiscard]] std::int32_t expected_count(int joint) const noexcept {
    return playback_.expected_count(joint, playback_.slot());
  }

 private:
  void enter_slot(std::int64_t now_ns) noexcept;
  void begin_cycle() noexcept;
  void send(const can::Frame& frame, std::int64_t expires_ns = kNeverExpires_ns) noexcept;
  void send_sync(std::int64_t now_ns) noexcept;
  void send_waiting() noexcept;
  void send_running() noexcept;
  void send_waiting_trajectory(int joint) noexcept;
  void send_stop() noexcept;
  void resynchronise(int joint) noexcept;
  void restart_points(int joint) noexcept;
  void take_feedback(const NetworkWatch::Arrival& arrival, std::int64_t now_ns) noexcept;
  void on_forged(const NetworkWatch::Arrival& arrival) noexcept;
  void stop_safely() noexcept;
  void supervise(int joint, const NetworkWatch::Arrival& arrival) noexcept;
  void supervise_stop(const can::Feedback& feedback) noexcept;
  [[nodiscard]] bool plays_as_expected(int joint, const can::Feedback& feedback) const noexcept;
  void take_hand_over(std::int64_t now_ns) noexcept;
  void judge(const msgclient::HandOver& hand_over, std::int64_t now_ns, msgclient::Answer& answer) noexcept;
  [[nodiscard]] msgclient::Reason untimely(const msgclient::HandOver& hand_over,
                                           std::int64_t now_ns) const noexcept;
  [[nodiscard]] CountPlanProblem motion_without_node(const CountPlan& plan,
                                                     std::span<const std::int32_t> start) const noexcept;
  [[nodiscard]] CountPlanProblem away_by_hand(const CountPlan& plan,
                                              std::span<const std::int32_t> start) const noexcept;
  void play(const CountPlan& plan) noexcept;
  void answer(const msgclient::Answer& answer) noexcept;
  void take_user_command(std::int64_t now_ns) noexcept;
  msgclient::Reason obey(const msgclient::UserCommandMail& mail, std::int64_t now_ns) noexcept;
  void stop_at_once(bool soft) noexcept;
  void stop_early(std::int64_t now_ns) noexcept;
  void drop_waiting_trajectories() noexcept;
  void prepare_tail() noexcept;
  void send_tail() noexcept;
  msgclient::Reason move_joint(const msgclient::UserCommandMail& mail, std::int64_t now_ns) noexcept;
  void publish_feedback(std::int64_t now_ns) noexcept;
  void send_trim(std::span<const double> angle_rad) noexcept;
  void send_own_trim() noexcept;
  void set_mode(Mode mode) noexcept { state_.mode = static_cast<std::uint32_t>(mode); }

  can::Profile profile_;
  // Latest hand-over, before its cycle or its first slot begins: the trajectory frames must have arrived by
  // then.
  std::int64_t hand_over_lead_ns_;
  std::uint32_t revision_slot_;  // from which batches may be revised; 0: they may not
  int joint_count_;
  std::vector<double> count_rad_, lower_rad_, upper_rad_;
  std::vector<can::NodeId> node_;  // of each joint; 0: not on the bus, holds still
  std::vector<bool> in_a_leg_;     // of each joint
  urdf::TrimSettings trim_settings_;

  msgclient::EmiMessage& adapter_;
  msgclient::Writer<JointStates> joint_states_writer_;
  msgclient::Writer<FootForces> foot_forces_writer_;
  msgclient::Writer<Imu> imu_writer_;
  msgclient::Writer<NetworkState> state_writer_;
  msgclient::Writer<NetworkHealth> health_writer_;
  msgclient::QueueReader<UserCommand> user_commands_;
  msgclient::Writer<UserCommandAnswer> user_command_answers_;

  TransmitQueue queue_;
  NetworkWatch watch_;
  Playback playback_;
  FeedbackCollector feedback_;
  NetworkState state_{};
  std::unique_ptr<msgclient::HandOver> hand_over_;  // large: kept off the stack
  std::unique_ptr<CountPlan> incoming_;
  msgclient::TrimGains gains_{};
  std::uint32_t feedback_id_;       // least urgent identifier of feedback
  std::int64_t last_heard_ns_ = 0;  // end of the last frame of another station
  bool stop_requested_ = false;
  bool stop_is_soft_ = false;  // the emergency stop that holds
  std::int64_t slot_start_ns_ = 0;
  std::uint8_t softness_ = 0;            // of all joints, as heard last: a host that falls silent leaves it
  std::uint32_t stop_sent_in_slot_ = 0;  // slot since start in which the emergency stop was last sent
  bool waits_for_next_slot_ = false;  // sent before this slot: its feedback can tell whether it has arrived
  bool feedback_published_ = true;
  bool trim_sent_this_slot_ = false;
  std::uint32_t slots_since_start_ = 0;
  std::uint32_t last_host_trim_slot_ = 0;   // slot since start in which the main controller last sent a trim
  std::uint32_t moving_by_hand_until_ = 0;  // slot since start at which the last manual movement has ended
  std::int64_t next_user_command_ns_ = 0;   // not before: user commands keep their period
  std::uint64_t unanswered_ = 0;
  std::array<bool, kMaxJoints> moved_by_hand_{};  // since the last batch was accepted
  std::array<std::uint32_t, kMaxJoints>
      resync_until_{};  // until this slot a joint's count may differ: a repair is on its way
  // The last slot of the running cycle whose point the joint has after a repair.
  std::array<int, kMaxJoints> covered_until_{};
};

}  // namespace gaitway::msgcontroller
