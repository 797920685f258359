// The message controller: takes batches from the main controller, sends them over the bus slot by slot,
// gathers feedback into topics, repairs what was lost, and plays the safe tail when no batch comes. Passive:
// it is told the time once a millisecond and at each arrival.
#pragma once

#include <cstdint>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgcontroller/batch_intake.hpp"
#include "gaitway/msgcontroller/bus_link.hpp"
#include "gaitway/msgcontroller/command_intake.hpp"
#include "gaitway/msgcontroller/emergency_stop.hpp"
#include "gaitway/msgcontroller/feedback_collector.hpp"
#include "gaitway/msgcontroller/hand_movement.hpp"
#include "gaitway/msgcontroller/joint_supervision.hpp"
#include "gaitway/msgcontroller/joint_takeover.hpp"
#include "gaitway/msgcontroller/playback.hpp"
#include "gaitway/msgcontroller/slot_record.hpp"
#include "gaitway/msgcontroller/trim_sender.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::msgcontroller {

class MessageController final : private CommandTaker {
 public:
  // Writes its topics through `client`, and talks to the main controller through `adapter`.
  MessageController(const urdf::RobotModel& robot, msgclient::Client& client, msgclient::EmiMessage& adapter);

  // Who is told what commands of mailbox and queue were carried out; outlives this.
  void tell_commands(CommandListener* listener) noexcept { commands_.tell(listener); }

  // To be called at every millisecond of the clock, before the frames of that millisecond are exchanged.
  // Takes what the main controller has put into the mailboxes, people's commands from the queue
  // `user_command` and, after them, so that they have the last word, people's stops from the topic
  // `stop_request`.
  void step(std::int64_t now_ns) noexcept;
  // Takes what is in the mailboxes. To be called when their doorbell rings between two milliseconds.
  void take_mails(std::int64_t now_ns) noexcept;
  // The state of this controller's own station, when it may have changed. While it is off the bus, nothing
  // waits: what would go out afterwards would be stale. Back on it, the prepared batch is sent once more.
  void on_bus_state(can::BusState state, can::ErrorCounters errors, std::int64_t now_ns) noexcept;
  // A frame of another station arrived from the bus.
  void on_frame(const can::Frame& frame, std::int64_t now_ns) noexcept;
  // A frame of its own was sent, or an error was signalled on the bus.
  void on_notice(const can::BusNotice& notice) noexcept;
  // The most urgent frame to send; false when there is none. Where no notice ever comes, it counts as sent.
  bool take_frame(can::Frame& frame) noexcept;
  // Identifier of that frame; past every identifier when there is none.
  [[nodiscard]] std::uint32_t next_id() const noexcept { return link_.queue.next_id(); }
  // Whether that frame may go to a port that cannot take it back. While joints answer a SYNC, every frame
  // less urgent than their feedback would lose arbitration to all of them, and whatever is handed over
  // meanwhile, an emergency stop above all, would have to wait behind it: it may go once the feedback has
  // come and the bus has been quiet, or feedback has had its time.
  [[nodiscard]] bool next_finds_quiet_bus(std::int64_t now_ns) const noexcept;
  // A frame that was offered to the bus and taken back, because a more urgent one came.
  void put_back(const can::Frame& frame) noexcept { link_.queue.push_front(frame); }

  [[nodiscard]] const NetworkState& state() const noexcept { return link_.state; }
  [[nodiscard]] const NetworkHealth& health() const noexcept { return link_.watch.health(); }
  [[nodiscard]] const can::Profile& profile() const noexcept { return link_.profile; }
  [[nodiscard]] Mode mode() const noexcept { return link_.mode(); }
  [[nodiscard]] const TransmitQueue& queue() const noexcept { return link_.queue; }
  // Reference of a joint at the end of the running slot, in counts.
  [[nodiscard]] std::int32_t expected_count(int joint) const noexcept {
    return playback_.expected_count(joint, playback_.slot());
  }

  // Of the hand-overs that were refused, those that a stop refused.
  [[nodiscard]] std::uint64_t refused_by_a_stop() const noexcept { return intake_.refused_by_a_stop(); }
  // Releases that people asked for and that have begun: their answers come later.
  [[nodiscard]] std::uint64_t releases_taken() const noexcept { return commands_.releases_taken(); }
  // Whether it is known where the joints stand: nothing is moved before.
  [[nodiscard]] bool joints_known() const noexcept { return takeover_.complete(); }

 private:
  void enter_slot(std::int64_t now_ns) noexcept;
  void pass_slots_until(std::int64_t slot_index) noexcept;
  void pass_slot(std::int64_t slot_index) noexcept;
  void begin_cycle() noexcept;
  void leave_to_joints() noexcept;
  [[nodiscard]] bool sync_gets_out() const noexcept;
  [[nodiscard]] bool counts_first() const noexcept;
  void recount() noexcept;
  void on_sent(const can::Frame& frame) noexcept;
  void note_sync(const can::Sync& sync) noexcept;
  void take_over() noexcept;
  void send_sync(std::int64_t now_ns) noexcept;
  void take_feedback(const NetworkWatch::Arrival& arrival, std::int64_t now_ns) noexcept;
  void take_fault_report(const NetworkWatch::Arrival& arrival) noexcept;
  void on_forged(const NetworkWatch::Arrival& arrival, const can::Frame& frame) noexcept;
  void publish_feedback(std::int64_t now_ns) noexcept;
  void take_plans(std::int64_t now_ns) noexcept;

  msgclient::Reason obey(const msgclient::UserCommandMail& mail, std::int64_t now_ns) noexcept override;
  void emergency_stop(bool soft) noexcept;
  void follow_release(std::int64_t now_ns) noexcept;
  void start_from_measured() noexcept;

  // The safe tail plays from the next batch on.
  void stop_safely() noexcept { stop_requested_ = stop_requested_ || mode() == Mode::batches; }
  void stop_early(std::int64_t now_ns) noexcept;
  void prepare_tail() noexcept;
  void send_tail() noexcept;

  BusLink link_;
  Playback playback_;
  FeedbackCollector feedback_;
  EmergencyStop emergency_stop_;
  JointSupervision supervision_;
  HandMovement hand_;
  BatchIntake intake_;
  TrimSender trims_;
  SlotRecord slot_record_;
  CommandIntake commands_;
  std::vector<bool> in_a_leg_;  // of each joint
  std::uint32_t feedback_id_;   // least urgent identifier of feedback

  msgclient::EmiMessage& adapter_;
  msgclient::Writer<JointStates> joint_states_writer_;
  msgclient::Writer<FootForces> foot_forces_writer_;
  msgclient::Writer<Imu> imu_writer_;
  msgclient::Writer<NetworkState> state_writer_;
  msgclient::Writer<NetworkHealth> health_writer_;
  msgclient::Writer<BusSlot> slot_writer_;
  JointTakeover takeover_;
  bool stop_requested_ = false;
  bool recount_waits_ = false;  // the joints were on their own and have not been told their counts since
  bool port_tells_sent_ = false;
  std::int64_t last_slot_index_ = -1;  // that was entered
  std::int64_t last_sync_index_ = -1;  // slot whose SYNC was on the bus
  int named_tail_points_ = 0;          // of the last SYNC on the bus that committed a batch
  std::int64_t last_heard_ns_ = 0;     // end of the last frame of another station
  bool feedback_published_ = true;
};

}  // namespace gaitway::msgcontroller
