// Sorts frames into messages and keeps their figures.
#include "tools/bus/bus_watch.hpp"

#include <numeric>

#include "gaitway/can/analysis/network_messages.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::tools {
namespace {

using can::MessageKind;

constexpr std::int64_t kSilent_ns = 2 * facts::kSlot_ns;
// Frames of one batch follow each other within this time: it is sent as one.
constexpr std::int64_t kLongestBatch_ns = 2 * facts::kSlot_ns;

double milliseconds(std::int64_t time_ns) {
  return static_cast<double>(time_ns) * 1e-6;
}

}  // namespace

BusWatch::BusWatch(const can::Profile& profile, std::span<const can::NodeId> nodes, BusClock clock)
    : profile_(profile), clock_(clock) {
  for (const can::NodeId node : nodes) {
    nodes_[node] = {};
  }
}

void BusWatch::take(const can::TimedFrame& frame) {
  const std::int64_t busy_ns = (can::frame_bits(frame.frame) + can::kInterframeBits) * facts::kBitTime_ns;
  if (frames_++ == 0) {
    first_ns_ = frame.start_ns;
  }
  if (!window_start_ns_) {
    window_start_ns_ = frame.start_ns;
  }
  last_ns_ = frame.end_ns;
  busy_ns_ += busy_ns;
  ++frames_in_window_;
  busy_in_window_ns_ += busy_ns;

  const auto message = frame.frame.extended ? std::nullopt : profile_.identify(frame.frame.id);
  if (const auto cause = stranger(frame.frame, message)) {
    ++strangers_[static_cast<std::size_t>(*cause)];
    last_stranger_ = frame.frame;
    return;
  }
  const double length_us = static_cast<double>(busy_ns) * 1e-3;
  // Both toggles of a trajectory, or of a part of a tail, are one message.
  std::int64_t& last_end_ns =
      last_end_ns_[profile_.id_of(message->kind, message->node, false, message->part)];
  const auto response_from_ns = released_ns(frame, *message);
  for (MessageFigures* const figures :
       {&messages_[static_cast<std::size_t>(message->kind)], &identifiers_[frame.frame.id]}) {
    ++figures->frames;
    ++figures->frames_in_window;
    figures->length_us.add(length_us);
    if (last_end_ns != 0) {
      figures->interval_ms.add(milliseconds(frame.end_ns - last_end_ns));
    }
    if (response_from_ns) {
      figures->response_ms.add(milliseconds(frame.end_ns - *response_from_ns));
    }
  }
  last_end_ns = frame.end_ns;
  learn(frame, *message);
}

std::optional<Stranger> BusWatch::stranger(const can::Frame& frame,
                                           const std::optional<can::Identified>& message) const noexcept {
  if (frame.extended) {
    return Stranger::extended;
  }
  if (frame.remote) {
    return Stranger::remote;
  }
  if (!message) {
    return Stranger::unknown_identifier;
  }
  return frame.size == can::layout(message->kind).size ? std::nullopt : std::optional(Stranger::wrong_size);
}

void BusWatch::learn(const can::TimedFrame& frame, const can::Identified& message) {
  switch (message.kind) {
    case MessageKind::sync:
      for (const auto& [node, figures] : nodes_) {
        unanswered_since_ns_[node] = frame.end_ns;
      }
      break;
    case MessageKind::trajectory:
      if (!profile_.has(MessageKind::sync)) {
        unanswered_since_ns_[message.node] = frame.end_ns;
      }
      break;
    case MessageKind::feedback:
      if (const auto feedback = can::decode_feedback(profile_, frame.frame)) {
        NodeFigures& node = nodes_[message.node];
        node.last_heard_ns = frame.end_ns;
        ++node.feedbacks;
        node.state = feedback->state;
      }
      break;
    case MessageKind::fault_report:
      if (const auto report = can::decode_fault_report(profile_, frame.frame)) {
        nodes_[message.node].faults = report->faults;
      }
      break;
    default:
      break;
  }
}

std::optional<std::int64_t> BusWatch::released_ns(const can::TimedFrame& frame,
                                                  const can::Identified& message) {
  const bool synchronised = profile_.has(MessageKind::sync);
  if (message.kind == MessageKind::feedback) {
    return feedback_released_ns(frame, message.node);
  }
  if (message.kind == MessageKind::sync && clock_ == BusClock::robot) {
    return frame.start_ns / facts::kSlot_ns * facts::kSlot_ns;
  }
  if (message.kind != MessageKind::trajectory) {
    return std::nullopt;
  }
  if (synchronised) {
    return batch_began_ns(frame, message);
  }
  const std::int64_t edge_ns = frame.start_ns / facts::kCycle_ns * facts::kCycle_ns;
  // What comes later in the cycle is a repair.
  const bool in_first_slot = frame.start_ns < edge_ns + facts::kSlot_ns;
  return clock_ == BusClock::robot && in_first_slot ? std::optional(edge_ns) : std::nullopt;
}

std::optional<std::int64_t> BusWatch::feedback_released_ns(const can::TimedFrame& frame, can::NodeId node) {
  const auto since = unanswered_since_ns_.find(node);
  if (since == unanswered_since_ns_.end()) {
    return std::nullopt;
  }
  const std::int64_t released_ns = since->second;
  unanswered_since_ns_.erase(since);
  // One that was on the wire or waited already answers something earlier.
  const bool answers = frame.start_ns >= released_ns && frame.end_ns < released_ns + facts::kSlot_ns;
  return answers ? std::optional(released_ns) : std::nullopt;
}

std::int64_t BusWatch::batch_began_ns(const can::TimedFrame& frame, const can::Identified& message) {
  const bool another = in_batch_.empty() || in_batch_.contains(message.node) ||
                       in_batch_.begin()->second != message.toggle ||
                       frame.start_ns > batch_start_ns_ + kLongestBatch_ns;
  if (another) {
    in_batch_.clear();
    batch_start_ns_ = frame.start_ns;
  }
  in_batch_[message.node] = message.toggle;
  return batch_start_ns_;
}

BusWindow BusWatch::close_window(std::int64_t now_ns) {
  BusWindow window;
  const std::int64_t elapsed_ns = window_start_ns_ ? now_ns - *window_start_ns_ : 0;
  if (elapsed_ns > 0) {
    window.seconds = static_cast<double>(elapsed_ns) * 1e-9;
    window.load = static_cast<double>(busy_in_window_ns_) / static_cast<double>(elapsed_ns);
    window.frames_per_s = static_cast<double>(frames_in_window_) / window.seconds;
    for (std::size_t kind = 0; kind < messages_.size(); ++kind) {
      window.rate_per_s[kind] = static_cast<double>(messages_[kind].frames_in_window) / window.seconds;
    }
  }
  for (MessageFigures& message : messages_) {
    message.frames_in_window = 0;
  }
  for (auto& [id, message] : identifiers_) {
    message.frames_in_window = 0;
  }
  frames_in_window_ = 0;
  busy_in_window_ns_ = 0;
  window_start_ns_ = now_ns;
  return window;
}

double BusWatch::seconds() const noexcept {
  return static_cast<double>(last_ns_ - first_ns_) * 1e-9;
}

double BusWatch::load() const noexcept {
  // The interframe space after the last frame has passed, too.
  const std::int64_t elapsed_ns = last_ns_ - first_ns_ + can::kInterframeBits * facts::kBitTime_ns;
  return frames_ == 0 ? 0.0 : static_cast<double>(busy_ns_) / static_cast<double>(elapsed_ns);
}

std::string_view BusWatch::response_from(MessageKind kind) const noexcept {
  const bool edges = clock_ == BusClock::robot;
  switch (can::release_sign(profile_, kind)) {
    case can::ReleaseSign::slot_edge:
      return edges ? "slot's edge" : "";
    case can::ReleaseSign::cycle_edge:
      return edges ? "cycle's edge" : "";
    case can::ReleaseSign::sync:
      return "SYNC's end";
    case can::ReleaseSign::batch:
      return "its batch's first bit";
    case can::ReleaseSign::trajectory:
      return "its trajectory's end";
    case can::ReleaseSign::unseen:
      break;
  }
  return "";
}

std::uint64_t BusWatch::strangers() const noexcept {
  return std::accumulate(strangers_.begin(), strangers_.end(), std::uint64_t{0});
}

std::vector<can::NodeId> BusWatch::silent_nodes() const {
  std::vector<can::NodeId> silent;
  for (const auto& [node, figures] : nodes_) {
    if (figures.feedbacks == 0 || figures.last_heard_ns + kSilent_ns < last_ns_) {
      silent.push_back(node);
    }
  }
  return silent;
}

}  // namespace gaitway::tools
