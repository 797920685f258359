// What the message controller hears on the bus that it should not hear, and what it misses: sorts every
// frame, counts each cause, and says which node and in which time slot.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgcontroller {

// As in the topic's field `last_incident`.
enum class Incident : std::uint8_t {
  none = 0,
  feedback_missing,
  node_returned,
  node_restarted,
  trajectory_lost,
  count_differed,
  unknown_identifier,
  wrong_length,
  remote_frame,
  extended_frame,
  undefined_value,
  forged,
  doubled,
  second_sender,
  expired,
  flushed,
  queue_full,
  bus_off,
  stop_repeated,
  feedback_lost
};
inline constexpr std::size_t kIncidents = 20;

class NetworkWatch {
 public:
  // `nodes`: of all joints, in their order; 0 for joints that are not on the bus.
  NetworkWatch(const can::Profile& profile, std::span<const can::NodeId> nodes) noexcept;

  enum class Heard : std::uint8_t { feedback, fault_report, forged, nothing };
  struct Arrival {
    Heard heard = Heard::nothing;
    can::Identified message;  // of a forged one
    int joint = -1;
    can::Feedback feedback;
    std::uint8_t faults = 0;
    bool returned = false;  // feedback of a node that was missing
  };
  // A frame that another station sent. Frames of nodes that no joint has count as unknown.
  Arrival take(const can::Frame& frame) noexcept;

  // A time slot begins: nodes that have sent nothing in the last two slots are missing.
  void begin_slot(std::uint32_t slot_since_start) noexcept;
  void on_bus_state(can::BusState state, can::ErrorCounters errors) noexcept;
  void count(Incident incident, can::NodeId node = 0, std::uint64_t times = 1) noexcept;

  [[nodiscard]] const NetworkHealth& health() const noexcept { return health_; }
  [[nodiscard]] NetworkHealth& health() noexcept { return health_; }
  [[nodiscard]] can::BusState bus_state() const noexcept {
    return static_cast<can::BusState>(health_.bus_state);
  }
  // For how many slots a joint has been silent.
  [[nodiscard]] std::uint32_t silent_slots(int joint) const noexcept;
  // Two different stations have sent this joint's feedback for several slots.
  [[nodiscard]] bool has_second_sender(int joint) const noexcept;

 private:
  struct Node {
    can::NodeId node = 0;  // 0: not on the bus
    std::uint32_t last_slot = 0;
    can::Frame last_frame;
    bool late = false;        // nothing came in the slot before: what comes now may be of two slots
    bool differed = false;    // from another frame of the same slot
    int differing_slots = 0;  // in a row
    bool has_played = false;  // a batch: from then on, a start is a restart
  };
  [[nodiscard]] std::optional<Incident> malformed(const can::Frame& frame,
                                                  const std::optional<can::Identified>& identified) const;
  Arrival take_feedback(const can::Frame& frame, int joint) noexcept;
  void compare_with_last(const can::Frame& frame, Node& node) noexcept;

  can::Profile profile_;
  int joint_count_;
  std::array<Node, kMaxJoints> nodes_{};
  std::array<int, can::kLargestNode + 1> joint_of_node_{};  // -1: no such node
  std::uint32_t slot_ = 0;
  NetworkHealth health_{};
};

}  // namespace gaitway::msgcontroller
