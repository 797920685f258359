// The proof of a robot's bus: from a profile's rows to messages with identifiers, periods and deadlines.
#include "gaitway/can/analysis/network_messages.hpp"

#include <algorithm>

namespace gaitway::can {
namespace {

AnalysedMessage message_of(const Profile& profile, const MessageLayout& layout, NodeId node,
                           std::int64_t jitter_ns, int part = 0) {
  const ProfileRow& row = profile.row(layout.kind);
  std::string name(layout.name);
  if (node > 0) {
    name.append(" ").append(std::to_string(node));
  }
  if (profile.parts(layout.kind) > 1) {
    name.append(" part ").append(std::to_string(part));
  }
  return {.name = name,
          .id = profile.id_of(layout.kind, node, false, part),
          .extended = false,
          .bytes = layout.size,
          .period_ns = row.period_ns,
          .jitter_ns = jitter_ns,
          .deadline_ns = row.deadline_ns,
          .fifo = std::nullopt,
          .length_bits = std::nullopt};
}

std::string in_ms(std::int64_t time_ns) {
  std::string text = std::to_string(time_ns / 1'000'000) + "." +
                     std::to_string(1'000'000 + time_ns % 1'000'000).substr(1, 3);
  return text + " ms";
}

}  // namespace

std::vector<AnalysedMessage> message_set(const Profile& profile, std::span<const NodeId> nodes,
                                         std::int64_t jitter_ns) {
  std::vector<AnalysedMessage> messages;
  for (const MessageLayout& layout : kMessageLayouts) {
    if (!profile.has(layout.kind)) {
      continue;
    }
    if (profile.row(layout.kind).rule == IdRule::one) {
      messages.push_back(message_of(profile, layout, 0, jitter_ns));
      continue;
    }
    for (const NodeId node : nodes) {
      if (node >= 1 && node <= profile.largest_node) {
        for (int part = 0; part < profile.parts(layout.kind); ++part) {
          messages.push_back(message_of(profile, layout, node, jitter_ns, part));
        }
      }
    }
  }
  std::ranges::sort(messages, {}, &AnalysedMessage::id);
  return messages;
}

ReleaseSign release_sign(const Profile& profile, MessageKind kind) noexcept {
  const bool synchronised = profile.has(MessageKind::sync);
  switch (kind) {
    case MessageKind::sync:
      return ReleaseSign::slot_edge;
    case MessageKind::feedback:
      return synchronised ? ReleaseSign::sync : ReleaseSign::trajectory;
    case MessageKind::trajectory:
      return synchronised ? ReleaseSign::batch : ReleaseSign::cycle_edge;
    default:
      return ReleaseSign::unseen;
  }
}

std::optional<std::size_t> Proof::first_miss() const noexcept {
  const auto miss = std::ranges::find_if_not(responses, &MessageResponse::schedulable);
  return miss == responses.end() ? std::nullopt
                                 : std::optional(static_cast<std::size_t>(miss - responses.begin()));
}

std::optional<std::int64_t> Proof::worst_response_ns(MessageKind kind) const noexcept {
  std::optional<std::int64_t> worst;
  for (std::size_t i = 0; i < responses.size(); ++i) {
    if (kinds[i] != kind) {
      continue;
    }
    if (!responses[i].worst_response_ns) {
      return std::nullopt;
    }
    worst = std::max(worst.value_or(0), *responses[i].worst_response_ns);
  }
  return worst;
}

std::string Proof::complaint() const {
  const auto miss = first_miss();
  if (!miss) {
    return {};
  }
  const AnalysedMessage& message = messages[*miss];
  const std::string whose = "the message '" + message.name + "' (id " + std::to_string(message.id) + ") ";
  const auto slack = responses[*miss].slack_ns();
  if (!slack) {
    return whose + "may wait without end: the bus is full for its priority";
  }
  return whose + "may arrive " + in_ms(-*slack) + " after its deadline of " + in_ms(message.deadline_ns);
}

Proof prove(const Profile& profile, std::span<const NodeId> nodes, const ProofAssumptions& assumptions) {
  Proof proof;
  proof.messages = message_set(profile, nodes, assumptions.jitter_ns);
  proof.responses =
      response_times(proof.messages, {.bit_time_ns = assumptions.bit_time_ns, .errors = assumptions.errors});
  for (const AnalysedMessage& message : proof.messages) {
    proof.kinds.push_back(profile.identify(message.id).value_or(Identified{}).kind);
  }
  proof.load = bus_load(proof.messages, assumptions.bit_time_ns);
  return proof;
}

int most_joints(const Profile& profile, const ProofAssumptions& assumptions) {
  std::vector<NodeId> nodes;
  while (nodes.size() < profile.largest_node) {
    nodes.push_back(static_cast<NodeId>(nodes.size() + 1));
    if (!prove(profile, nodes, assumptions).holds()) {
      return static_cast<int>(nodes.size()) - 1;
    }
  }
  return static_cast<int>(nodes.size());
}

}  // namespace gaitway::can
