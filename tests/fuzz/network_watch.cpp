// How the message controller sorts what it hears (msgcontroller/network_watch.hpp). Whatever other stations
// send: every frame that is neither feedback nor a fault report of a known node is counted under exactly one
// cause; feedback is handed on with the joint that its identifier names and ends that joint's silence, and
// nothing else does; a joint that has said nothing for more than two slots is missing, and only such a joint.
#include "gaitway/msgcontroller/network_watch.hpp"

#include <array>
#include <cstdint>
#include <span>

#include "fuzz_frame.hpp"

namespace gaitway::fuzz {
namespace {

using can::NodeId;
using msgcontroller::NetworkWatch;

constexpr std::array<NodeId, 6> kNodes{1, 2, 7, 12, 0, 64};

std::uint64_t bad_frames(const NetworkHealth& health) {
  return health.unknown_identifiers + health.wrong_lengths + health.remote_frames + health.extended_frames +
         health.undefined_values + health.forged;
}

class Watched {
 public:
  explicit Watched(const can::Profile& profile) : profile_(profile), watch_(profile, nodes_of(profile)) {}

  void take(const can::Frame& frame) {
    const NetworkHealth before = watch_.health();
    const NetworkWatch::Arrival arrival = watch_.take(frame);
    const NetworkHealth& after = watch_.health();
    const std::uint64_t counted = bad_frames(after) - bad_frames(before);
    const auto identified = profile_.identify(frame.id);
    switch (arrival.heard) {
      case NetworkWatch::Heard::feedback:
        check_feedback(frame, arrival);
        require(counted == 0, "feedback is no offence");
        return;
      case NetworkWatch::Heard::fault_report:
        require(can::decode_fault_report(profile_, frame).has_value(), "only a fault report is one");
        require(counted == 0, "a fault report is no offence");
        return;
      case NetworkWatch::Heard::forged:
        require(identified && can::layout(identified->kind).sender == can::Sender::message_controller,
                "forged is what only the message controller may send");
        require(after.forged == before.forged + 1, "a forged frame is counted as one");
        [[fallthrough]];
      case NetworkWatch::Heard::nothing:
        require(counted == 1, "a frame that does not belong is counted under one cause");
    }
    require(after.missing == before.missing, "nothing but feedback ends a silence");
  }

  void begin_slot() {
    ++slot_;
    watch_.begin_slot(slot_);
    for (std::size_t joint = 0; joint < kNodes.size(); ++joint) {
      const bool missing = (watch_.health().missing >> joint & 1U) != 0;
      require(missing == (on_bus(kNodes[joint]) && slot_ - heard_in_slot_[joint] > 2),
              "who has been silent for more than two slots is missing");
    }
  }

  void on_bus_state(Input& input) {
    watch_.on_bus_state(static_cast<can::BusState>(input.choose(4)),
                        {.transmit = input.take<std::uint8_t>(), .receive = input.take<std::uint8_t>()});
  }

 private:
  [[nodiscard]] bool on_bus(NodeId node) const { return node != 0 && node <= profile_.largest_node; }
  static std::array<NodeId, kNodes.size()> nodes_of(const can::Profile& profile) {
    std::array<NodeId, kNodes.size()> nodes = kNodes;
    for (NodeId& node : nodes) {
      node = node <= profile.largest_node ? node : NodeId{0};
    }
    return nodes;
  }
  void check_feedback(const can::Frame& frame, const NetworkWatch::Arrival& arrival) {
    const auto identified = profile_.identify(frame.id);
    require(identified && identified->kind == can::MessageKind::feedback, "feedback has its identifier");
    require(arrival.joint >= 0 && kNodes[static_cast<std::size_t>(arrival.joint)] == identified->node,
            "feedback belongs to the joint that its identifier names");
    require(can::decode_feedback(profile_, frame) == arrival.feedback, "feedback is handed on as it came");
    heard_in_slot_[static_cast<std::size_t>(arrival.joint)] = slot_;
  }

  const can::Profile& profile_;
  NetworkWatch watch_;
  std::uint32_t slot_ = 0;
  std::array<std::uint32_t, kNodes.size()> heard_in_slot_{};
};

}  // namespace

void network_watch(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const can::Profile& profile = take_profile(input);
  Watched watched(profile);
  while (!input.empty()) {
    switch (input.choose(8)) {
      case 0:
      case 1:
        watched.begin_slot();
        break;
      case 2:
        watched.on_bus_state(input);
        break;
      case 3:
      case 4:
        watched.take(take_frame(input));
        break;
      default:
        watched.take(take_known_frame(input, profile, static_cast<NodeId>(1 + input.choose(64))));
    }
  }
}

}  // namespace gaitway::fuzz
