// The messages of a profile as the response-time analysis sees them, and the proof that a robot's bus keeps
// every deadline. Both come from the table that codecs and scheduler read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/can/analysis/response_time.hpp"
#include "gaitway/can/profile.hpp"

namespace gaitway::can {

// What is promised about a robot's stations and its surroundings.
struct ProofAssumptions {
  std::int64_t jitter_ns = 0;  // release jitter of every message
  ErrorModel errors;
  std::int64_t bit_time_ns = 1000;
};

// Every message of the profile for these nodes, the most urgent first. A message that comes on events is
// taken at its shortest interval, all nodes' at once. The two identifiers of a trajectory alternate: they are
// one message. Nodes that the profile has no identifiers for are left out.
[[nodiscard]] std::vector<AnalysedMessage> message_set(const Profile& profile, std::span<const NodeId> nodes,
                                                       std::int64_t jitter_ns = 0);

// By what somebody who only listens knows when a message was released, so that its arrival can be held
// against its worst response.
enum class ReleaseSign : std::uint8_t {
  unseen,
  slot_edge,   // of the robot's clock
  cycle_edge,  // likewise
  sync,        // the last bit of the SYNC that it answers
  batch,       // the first bit of the first trajectory frame of its batch, at the latest
  trajectory   // the last bit of its node's trajectory frame, in cycles that have one
};
[[nodiscard]] ReleaseSign release_sign(const Profile& profile, MessageKind kind) noexcept;

// The analysis of a robot's bus.
struct Proof {
  std::vector<AnalysedMessage> messages;   // the most urgent first
  std::vector<MessageResponse> responses;  // one a message
  std::vector<MessageKind> kinds;          // one a message
  double load = 0.0;

  // Index of the most urgent message that misses its deadline.
  [[nodiscard]] std::optional<std::size_t> first_miss() const noexcept;
  [[nodiscard]] bool holds() const noexcept { return !first_miss(); }
  // The longest of all nodes; nothing when one of them has no bound, or the profile has no such message.
  [[nodiscard]] std::optional<std::int64_t> worst_response_ns(MessageKind kind) const noexcept;
  // A sentence that names the first message that misses and by how much; empty when all meet their deadlines.
  [[nodiscard]] std::string complaint() const;
};
[[nodiscard]] Proof prove(const Profile& profile, std::span<const NodeId> nodes,
                          const ProofAssumptions& assumptions = {});

// How many joints, on nodes 1, 2, ..., the bus carries before the first deadline is missed; at most the
// profile's largest node.
[[nodiscard]] int most_joints(const Profile& profile, const ProofAssumptions& assumptions = {});

}  // namespace gaitway::can
