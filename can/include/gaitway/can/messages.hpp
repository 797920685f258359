// Every message of the network as a plain struct, with its encoder and decoder. Where each field lies in the
// frame is described once, in message_layout.hpp; encode and decode follow that table. Freestanding.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::can {

struct Profile;  // profile.hpp

using NodeId = std::uint8_t;  // 1..64: a local controller on the bus; 0 is the message controller

inline constexpr int kBatchPoints = facts::kSlotsPerCycle;  // points in one trajectory frame, one a time slot
inline constexpr int kTailParts = facts::kMostTailParts;    // frames that hold one joint's tail at most
inline constexpr int kTailPoints = kTailParts * kBatchPoints;
inline constexpr int kResyncDeltas = 5;      // points that follow the absolute one in a resynchronisation
inline constexpr int kFeedbackChannels = 2;  // 16-bit sensor channels in a feedback frame

// What the joints do on an emergency stop, or when it is released: they hold where they are measured, and
// take batches again. A profile without a message of its own for it sends a user command to node 0, with the
// mode as its target.
enum class StopMode : std::uint8_t { hold = 0, soft = 1, release = 2 };

// Highest priority: all joints at once.
struct EmergencyStop {
  StopMode mode = StopMode::hold;
  friend bool operator==(const EmergencyStop&, const EmergencyStop&) = default;
};

// Manual joint command: one joint moves to an absolute count, while standing.
struct UserCommand {
  NodeId node = 0;
  std::int16_t target_count = 0;
  std::uint8_t duration_slots = 0;  // time slots over which the joint moves there
  friend bool operator==(const UserCommand&, const UserCommand&) = default;
};

inline constexpr std::uint8_t kMostSoftness = 7;

// Sent at every slot edge; starts batches and keeps the joints' slots aligned.
struct Sync {
  std::uint16_t cycle = 0;       // low 16 bits of the cycle number = of the batch's sequence number
  std::uint8_t slot = 0;         // 0..7
  bool batch_committed = false;  // a batch is played in this cycle: whoever holds it starts it at slot 0
  bool toggle = false;           // toggle of that batch
  std::uint8_t softness = 0;     // of all joints: 0 the servo's whole torque .. kMostSoftness none
  // Of a committed batch: with so many points of the tail that bears this toggle, the joints bring both feet
  // down when no SYNC comes after the batch. 0: no joint has a tail of it, or none is needed.
  std::uint8_t tail_points = 0;
  bool tail_toggle = false;
  friend bool operator==(const Sync&, const Sync&) = default;
};

// Absolute corrections added to the servo's reference; units: trim counts of the network file.
struct Trim {
  std::array<std::int8_t, facts::kTrimChannels> count{};
  friend bool operator==(const Trim&, const Trim&) = default;
};

enum class JointState : std::uint8_t {
  running = 0,  // plays a batch or its tail, or holds compliantly because SYNC was lost
  holding = 1,  // no batch to play: holds its last reference
  soft = 2,     // torque off after an emergency stop
  stopped = 3   // holds after an emergency stop
};

// One joint's merged feedback, at every slot edge; also its heartbeat.
struct Feedback {
  NodeId node = 0;
  std::int16_t position = 0;  // measured angle, in 1/65536 of a turn, joint zero = 0
  std::int8_t current = 0;    // motor torque, in 1/8 N·m (rounded, saturating)
  JointState state = JointState::holding;
  bool pending_toggle = false;     // toggle of the newest trajectory frame that the joint holds
  bool executing_toggle = false;   // toggle of the batch that it plays (or played last)
  std::uint8_t reference_low = 0;  // low four bits of its own reference count, for this slot's end
  std::array<std::int16_t, kFeedbackChannels> channel{};  // sensor channels of the network file
  friend bool operator==(const Feedback&, const Feedback&) = default;
};

// Sent when a fault begins and when it ends, at most once in the profile's period.
struct FaultReport {
  NodeId node = 0;
  std::uint8_t faults = 0;  // bit mask of Fault
  friend bool operator==(const FaultReport&, const FaultReport&) = default;
};
enum class Fault : std::uint8_t {
  position_limit = 1,    // the reference was kept within the joint's limits
  torque_saturated = 2,  // the servo has wanted more torque than there is for a while
  sync_lost = 4,         // several SYNCs in a row did not come
  encoder = 8,           // the encoder jumps further than the joint can move
  restarted = 16,        // has started (again) and stands where its encoder says, not where it was told
  tail_missing = 32      // SYNC names a tail of which it does not hold every point
};

// One joint's batch: 8 changes of its reference count.
struct Trajectory {
  NodeId node = 0;
  bool toggle = false;
  std::array<std::int8_t, kBatchPoints> delta{};
  friend bool operator==(const Trajectory&, const Trajectory&) = default;
};

// Eight points of what follows one joint's batch when nobody is there to send another: the changes of its
// reference count after the batch's last point. Sent ahead; of use only when SYNC says that it is whole.
struct Tail {
  NodeId node = 0;
  bool toggle = false;
  std::uint8_t part = 0;  // 0..kTailParts-1: which eight points
  std::array<std::int8_t, kBatchPoints> delta{};
  friend bool operator==(const Tail&, const Tail&) = default;
};

// Repairs one joint: its absolute count at the end of `slot`, and the changes of the slots after it.
struct Resynchronisation {
  NodeId node = 0;
  bool toggle = false;     // of the batch that it belongs to
  std::uint8_t slot = 0;   // 0..7: the slot (of the running cycle) at whose SYNC it takes effect
  std::int16_t count = 0;  // reference count at the end of that slot
  std::array<std::int8_t, kResyncDeltas> delta{};  // of slot+1 ...; past the batch's end: zero, unused
  friend bool operator==(const Resynchronisation&, const Resynchronisation&) = default;
};

// The message controller's sign of life, every 80 ms.
struct Heartbeat {
  std::uint8_t mode = 0;
  std::uint32_t cycle = 0;
  friend bool operator==(const Heartbeat&, const Heartbeat&) = default;
};

Frame encode(const Profile& profile, const EmergencyStop& message) noexcept;
Frame encode(const Profile& profile, const UserCommand& message) noexcept;
Frame encode(const Profile& profile, const Sync& message) noexcept;
Frame encode(const Profile& profile, const Trim& message) noexcept;
Frame encode(const Profile& profile, const Feedback& message) noexcept;
Frame encode(const Profile& profile, const FaultReport& message) noexcept;
Frame encode(const Profile& profile, const Trajectory& message) noexcept;
Frame encode(const Profile& profile, const Resynchronisation& message) noexcept;
Frame encode(const Profile& profile, const Heartbeat& message) noexcept;
Frame encode(const Profile& profile, const Tail& message) noexcept;

// Decoders: nothing when format, id or size are not the message's own in that profile, or a field holds an
// undefined value.
std::optional<EmergencyStop> decode_emergency_stop(const Profile& profile, const Frame& frame) noexcept;
std::optional<UserCommand> decode_user_command(const Profile& profile, const Frame& frame) noexcept;
std::optional<Sync> decode_sync(const Profile& profile, const Frame& frame) noexcept;
std::optional<Trim> decode_trim(const Profile& profile, const Frame& frame) noexcept;
std::optional<Feedback> decode_feedback(const Profile& profile, const Frame& frame) noexcept;
std::optional<FaultReport> decode_fault_report(const Profile& profile, const Frame& frame) noexcept;
std::optional<Trajectory> decode_trajectory(const Profile& profile, const Frame& frame) noexcept;
std::optional<Resynchronisation> decode_resynchronisation(const Profile& profile,
                                                          const Frame& frame) noexcept;
std::optional<Heartbeat> decode_heartbeat(const Profile& profile, const Frame& frame) noexcept;
std::optional<Tail> decode_tail(const Profile& profile, const Frame& frame) noexcept;

}  // namespace gaitway::can
