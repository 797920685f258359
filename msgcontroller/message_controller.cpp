// Slot by slot: SYNC, trajectory frames of the next cycle, feedback, repairs, trims and the safe tail.
#include "gaitway/msgcontroller/message_controller.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/trim_law.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/msgcontroller/network_proof.hpp"

namespace gaitway::msgcontroller {
namespace {

using facts::kMillisecond_ns;
using facts::kSlot_ns;
using facts::kSlotsPerCycle;

constexpr int kLastSlot = kSlotsPerCycle - 1;
// Feedback that has not come by then is taken as missing for this slot; the main controller's tick follows.
constexpr std::int64_t kPublishInSlot_ns = 4 * kMillisecond_ns;
// No trim from the main controller by then: the message controller makes its own. Once the main controller
// has been silent for two slots, it does so as soon as the feedback is in, since every millisecond costs
// stability.
constexpr std::int64_t kOwnTrimInSlot_ns = 7 * kMillisecond_ns;
constexpr std::uint32_t kSilentSlots = 2;
// A leg whose joint has been silent for so long cannot be relied on: the robot stops.
constexpr std::uint32_t kSilentSlotsOfALeg = 10;

std::uint32_t least_urgent_feedback(const can::Profile& profile, const std::vector<can::NodeId>& nodes) {
  const can::NodeId last_node =
      nodes.empty() ? can::NodeId{0} : *std::max_element(nodes.begin(), nodes.end());
  return profile.id_of(can::MessageKind::feedback, last_node);
}

std::vector<std::int32_t> home_counts(const urdf::RobotModel& robot) {
  std::vector<std::int32_t> counts;
  counts.reserve(robot.joints.size());
  for (const urdf::Joint& joint : robot.joints) {
    counts.push_back(static_cast<std::int32_t>(std::lround(joint.home_rad / joint.count_rad)));
  }
  return counts;
}

}  // namespace

MessageController::MessageController(const urdf::RobotModel& robot, msgclient::Client& client,
                                     msgclient::EmiMessage& adapter)
    : profile_(network_profile(robot)),
      hand_over_lead_ns_(hand_over_lead_ns(robot)),
      revision_slot_(static_cast<std::uint32_t>(robot.network.revision_slot)),
      joint_count_(static_cast<int>(robot.joints.size())),
      node_(joint_nodes(robot, profile_)),
      in_a_leg_(robot.joints.size(), false),
      trim_settings_(robot.trim),
      adapter_(adapter),
      joint_states_writer_(client.write<JointStates>("joint_states")),
      foot_forces_writer_(client.write<FootForces>("foot_forces")),
      imu_writer_(client.write<Imu>("imu")),
      state_writer_(client.write<NetworkState>("network_state")),
      health_writer_(client.write<NetworkHealth>("network_health")),
      user_commands_(client.read_queue<UserCommand>("user_command")),
      user_command_answers_(client.write_stream<UserCommandAnswer>("user_command_answer")),
      watch_(profile_, node_),
      playback_(home_counts(robot)),
      feedback_(robot, node_),
      hand_over_(std::make_unique<msgclient::HandOver>()),
      incoming_(std::make_unique<CountPlan>()),
      feedback_id_(least_urgent_feedback(profile_, node_)) {
  for (int joint = 0; joint < joint_count_; ++joint) {
    const urdf::Joint& description = robot.joints[static_cast<std::size_t>(joint)];
    count_rad_.push_back(description.count_rad);
    lower_rad_.push_back(description.lower_rad);
    upper_rad_.push_back(description.upper_rad);
  }
  for (const urdf::Leg& leg : robot.legs) {
    for (const int joint : leg.joints) {
      in_a_leg_[static_cast<std::size_t>(joint)] = true;
    }
  }
  set_mode(Mode::holding);
  state_writer_.publish(state_, 0);
  health_writer_.publish(watch_.health(), 0);
}

void MessageController::step(std::int64_t now_ns) noexcept {
  const std::int64_t in_slot_ns = now_ns % kSlot_ns;
  watch_.count(Incident::expired, 0, queue_.expire(now_ns));
  if (in_slot_ns == 0) {
    enter_slot(now_ns);
  }
  take_mails(now_ns);
  if (now_ns % facts::kCycle_ns == facts::kCycle_ns - hand_over_lead_ns_) {
    prepare_tail();
  }
  if (!feedback_published_ && in_slot_ns >= kPublishInSlot_ns) {
    publish_feedback(now_ns);
  }
  const bool host_is_silent = slots_since_start_ - last_host_trim_slot_ > kSilentSlots;
  if (!trim_sent_this_slot_ && (host_is_silent ? feedback_published_ : in_slot_ns == kOwnTrimInSlot_ns)) {
    send_own_trim();
  }
}

void MessageController::prepare_tail() noexcept {
  if (!playback_.prepared() && mode() != Mode::emergency_stop && playback_.prepare_from_tail()) {
    send_tail();
  }
}

void MessageController::send_tail() noexcept {
  set_mode(Mode::safe_tail);
  ++state_.tail_played;
  if (profile_.has(can::MessageKind::sync)) {
    send_waiting();
  }
}

void MessageController::enter_slot(std::int64_t now_ns) noexcept {
  const std::int64_t slot_index = now_ns / kSlot_ns;
  const int slot = static_cast<int>(slot_index % kSlotsPerCycle);
  if (!feedback_published_) {
    publish_feedback(now_ns);
  }
  slot_start_ns_ = now_ns;
  if (slot == 0) {
    begin_cycle();
  }
  if (playback_.enter_slot(slot)) {
    covered_until_.fill(kLastSlot);
    if (stop_requested_) {
      prepare_tail();  // the revision's
    }
  }
  waits_for_next_slot_ = playback_.waiting_segment() != nullptr && playback_.waiting_from() == slot + 1;
  state_.cycle = static_cast<std::uint32_t>(slot_index / kSlotsPerCycle);
  state_.slot = static_cast<std::uint32_t>(slot);
  state_.stamp_ns = now_ns;
  send_sync(now_ns);
  ++slots_since_start_;
  watch_.begin_slot(slots_since_start_);
  feedback_.begin_slot(slots_since_start_);
  for (int joint = 0; joint < joint_count_; ++joint) {
    if (in_a_leg_[static_cast<std::size_t>(joint)] && watch_.silent_slots(joint) == kSilentSlotsOfALeg) {
      stop_safely();
    }
  }
  feedback_published_ = false;
  trim_sent_this_slot_ = false;
  state_writer_.publish(state_, now_ns);
  watch_.health().stamp_ns = now_ns;
  health_writer_.publish(watch_.health(), now_ns);
}

void MessageController::begin_cycle() noexcept {
  const bool was_tail = mode() == Mode::safe_tail;
  covered_until_.fill(kLastSlot);
  playback_.begin_cycle();
  if (mode() == Mode::emergency_stop) {
    return;
  }
  if (stop_requested_) {
    prepare_tail();  // as early as can be
  }
  if (!playback_.running_segment().active) {
    set_mode(Mode::holding);
    stop_requested_ = false;
  } else if (!was_tail && !stop_requested_) {
    set_mode(Mode::batches);
  }
}

void MessageController::publish_feedback(std::int64_t now_ns) noexcept {
  feedback_.joint_states().missing = feedback_.missing();
  joint_states_writer_.publish(feedback_.joint_states(), now_ns);
  foot_forces_writer_.publish(feedback_.foot_forces(), now_ns);
  imu_writer_.publish(feedback_.imu(), now_ns);
  feedback_published_ = true;
}

void MessageController::send_trim(std::span<const double> angle_rad) noexcept {
  if (!profile_.has(can::MessageKind::trim)) {
    return;
  }
  can::Trim trim;
  for (std::size_t channel = 0; channel < trim.count.size(); ++channel) {
    const double limited =
        std::clamp(angle_rad[channel], -trim_settings_.limit_rad, trim_settings_.limit_rad);
    trim.count[channel] =
        static_cast<std::int8_t>(std::clamp(std::lround(limited / trim_settings_.count_rad), -127L, 127L));
  }
  send(can::encode(profile_, trim), slot_start_ns_ + 2 * kSlot_ns);
  trim_sent_this_slot_ = true;
}

void MessageController::send_own_trim() noexcept {
  if (!profile_.has(can::MessageKind::trim) || gains_.channel_count == 0 || mode() == Mode::emergency_stop) {
    return;
  }
  const Imu& imu = feedback_.imu();
  const msgclient::TrunkMotion motion{.roll = imu.inclination[0],
                                      .pitch = imu.inclination[1],
                                      .roll_rate = imu.angular_velocity[0],
                                      .pitch_rate = imu.angular_velocity[1]};
  send_trim(msgclient::trim_angles(gains_, playback_.support(), motion, trim_settings_.limit_rad));
}

}  // namespace gaitway::msgcontroller
