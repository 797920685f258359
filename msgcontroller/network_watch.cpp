// Sorts what comes from the bus.
#include "gaitway/msgcontroller/network_watch.hpp"

namespace gaitway::msgcontroller {
namespace {

constexpr std::uint32_t kSlotsUntilMissing = 2;
// A joint may answer twice in a slot, differently, when its SYNC comes late, and what it said in one slot may
// arrive in the next. A second station does it slot by slot.
constexpr int kSlotsUntilSecondSender = 3;

// Indexed by Incident.
constexpr std::array<std::uint64_t NetworkHealth::*, kIncidents> kCounter{nullptr,
                                                                          &NetworkHealth::feedback_missing,
                                                                          &NetworkHealth::nodes_returned,
                                                                          &NetworkHealth::nodes_restarted,
                                                                          &NetworkHealth::trajectories_lost,
                                                                          &NetworkHealth::counts_differed,
                                                                          &NetworkHealth::unknown_identifiers,
                                                                          &NetworkHealth::wrong_lengths,
                                                                          &NetworkHealth::remote_frames,
                                                                          &NetworkHealth::extended_frames,
                                                                          &NetworkHealth::undefined_values,
                                                                          &NetworkHealth::forged,
                                                                          &NetworkHealth::doubled,
                                                                          &NetworkHealth::second_senders,
                                                                          &NetworkHealth::expired,
                                                                          &NetworkHealth::flushed,
                                                                          &NetworkHealth::queue_full,
                                                                          &NetworkHealth::bus_offs,
                                                                          &NetworkHealth::stops_repeated,
                                                                          &NetworkHealth::feedback_lost};

constexpr std::uint64_t bit(int joint) noexcept {
  return std::uint64_t{1} << static_cast<unsigned>(joint);
}

}  // namespace

NetworkWatch::NetworkWatch(const can::Profile& profile, std::span<const can::NodeId> nodes) noexcept
    : profile_(profile), joint_count_(static_cast<int>(nodes.size())) {
  joint_of_node_.fill(-1);
  for (std::size_t joint = 0; joint < nodes.size(); ++joint) {
    nodes_[joint].node = nodes[joint];
    if (nodes[joint] != 0) {
      joint_of_node_[nodes[joint]] = static_cast<int>(joint);
    }
  }
}

void NetworkWatch::count(Incident incident, can::NodeId node, std::uint64_t times) noexcept {
  if (times == 0) {
    return;
  }
  health_.*kCounter[static_cast<std::size_t>(incident)] += times;
  health_.last_incident = static_cast<std::uint32_t>(incident);
  health_.last_incident_node = node;
  health_.last_incident_slot = slot_;
}

std::optional<Incident> NetworkWatch::malformed(const can::Frame& frame,
                                                const std::optional<can::Identified>& identified) const {
  if (frame.extended) {
    return Incident::extended_frame;
  }
  if (frame.remote) {
    return Incident::remote_frame;
  }
  if (!identified) {
    return Incident::unknown_identifier;
  }
  const bool from_node = can::layout(identified->kind).sender == can::Sender::local_controller;
  if (from_node && joint_of_node_[identified->node] < 0) {
    return Incident::unknown_identifier;
  }
  if (from_node && frame.size != can::layout(identified->kind).size) {
    return Incident::wrong_length;
  }
  return std::nullopt;
}

NetworkWatch::Arrival NetworkWatch::take(const can::Frame& frame) noexcept {
  const auto identified = profile_.identify(frame.id);
  if (const auto incident = malformed(frame, identified)) {
    count(*incident, identified && !frame.extended ? identified->node : can::NodeId{0});
    return {};
  }
  if (can::layout(identified->kind).sender == can::Sender::message_controller) {
    // Whatever its length: nobody else may use these identifiers.
    count(Incident::forged, identified->node);
    return {.heard = Heard::forged,
            .message = *identified,
            .joint = joint_of_node_[identified->node],
            .feedback = {}};
  }
  const int joint = joint_of_node_[identified->node];
  if (identified->kind == can::MessageKind::feedback) {
    return take_feedback(frame, joint);
  }
  Arrival arrival{.heard = Heard::fault_report, .message = *identified, .joint = joint, .feedback = {}};
  if (const auto report = can::decode_fault_report(profile_, frame)) {
    arrival.faults = report->faults;
    std::uint8_t& known = health_.faults[static_cast<std::size_t>(joint)];
    constexpr auto kRestarted = static_cast<std::uint8_t>(can::Fault::restarted);
    const bool has_played = nodes_[static_cast<std::size_t>(joint)].has_played;
    if (has_played && (report->faults & kRestarted) != 0 && (known & kRestarted) == 0) {
      count(Incident::node_restarted, identified->node);
    }
    known = report->faults;
  }
  return arrival;
}

NetworkWatch::Arrival NetworkWatch::take_feedback(const can::Frame& frame, int joint) noexcept {
  Node& node = nodes_[static_cast<std::size_t>(joint)];
  Arrival arrival{.heard = Heard::nothing, .message = {}, .joint = joint, .feedback = {}};
  const auto feedback = can::decode_feedback(profile_, frame);
  if (!feedback) {
    count(Incident::undefined_value, node.node);
    return arrival;
  }
  if (node.last_slot == slot_ && slot_ != 0) {
    compare_with_last(frame, node);
  } else {
    node.late = slot_ - node.last_slot > 1;
    node.differing_slots = node.differed ? node.differing_slots : 0;
    node.differed = false;
  }
  arrival.returned = (health_.missing & bit(joint)) != 0;
  if (arrival.returned) {
    count(Incident::node_returned, node.node);
    health_.missing &= ~bit(joint);
  }
  node.last_slot = slot_;
  node.last_frame = frame;
  node.has_played = node.has_played || feedback->state == can::JointState::running;
  arrival.heard = Heard::feedback;
  arrival.feedback = *feedback;
  return arrival;
}

void NetworkWatch::compare_with_last(const can::Frame& frame, Node& node) noexcept {
  if (node.late) {
    return;
  }
  if (frame == node.last_frame) {
    count(Incident::doubled, node.node);
    return;
  }
  count(Incident::second_sender, node.node);
  node.differing_slots += node.differed ? 0 : 1;
  node.differed = true;
}

void NetworkWatch::begin_slot(std::uint32_t slot_since_start) noexcept {
  for (int joint = 0; joint < joint_count_; ++joint) {
    const Node& node = nodes_[static_cast<std::size_t>(joint)];
    if (node.node != 0 && node.last_slot != 0 && node.last_slot != slot_) {
      count(Incident::feedback_lost, node.node);
    }
  }
  slot_ = slot_since_start;
  for (int joint = 0; joint < joint_count_; ++joint) {
    const Node& node = nodes_[static_cast<std::size_t>(joint)];
    if (node.node != 0 && silent_slots(joint) > kSlotsUntilMissing && (health_.missing & bit(joint)) == 0) {
      health_.missing |= bit(joint);
      count(Incident::feedback_missing, node.node);
    }
  }
}

std::uint32_t NetworkWatch::silent_slots(int joint) const noexcept {
  return slot_ - nodes_[static_cast<std::size_t>(joint)].last_slot;
}

bool NetworkWatch::has_second_sender(int joint) const noexcept {
  return nodes_[static_cast<std::size_t>(joint)].differing_slots >= kSlotsUntilSecondSender;
}

void NetworkWatch::on_bus_state(can::BusState state, can::ErrorCounters errors) noexcept {
  const bool was_on = bus_state() < can::BusState::bus_off;
  if (was_on && state >= can::BusState::bus_off) {
    count(Incident::bus_off);
  }
  health_.bus_state = static_cast<std::uint32_t>(state);
  health_.transmit_errors = static_cast<std::uint32_t>(errors.transmit);
  health_.receive_errors = static_cast<std::uint32_t>(errors.receive);
}

}  // namespace gaitway::msgcontroller
