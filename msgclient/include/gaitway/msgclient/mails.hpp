// The smaller mails between main controller and message controller, and the answers to all of them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgclient {

// Host to message controller every 10 ms: absolute corrections, and how soft the joints are. Not answered:
// the next one replaces it.
struct TrimUpdate {
  std::int64_t stamp_ns = 0;
  std::uint32_t channel_count = 0;  // valid channels, in the order of the network file's trim channels
  std::array<float, kTrimChannels> angle{};  // [rad]
  float softness = 0.0F;                     // of all joints: 0 the servos' whole torque .. 1 none

  friend bool operator==(const TrimUpdate&, const TrimUpdate&) = default;
};

enum class UserCommandKind : std::uint32_t {
  stop = 0,                 // play the safe tail now: finish the step and stand
  emergency_stop_hold = 1,  // all joints hold at once
  emergency_stop_soft = 2,  // all joints without torque at once
  manual_joint = 3,         // one joint moves to a position while the robot stands
  release = 4  // ends an emergency stop: the joints hold where they are, and batches are taken again
};

// Host to message controller, at any time; answered.
struct UserCommandMail {
  std::uint32_t sequence = 0;  // counted by the sender, 1 for the first
  UserCommandKind kind = UserCommandKind::stop;
  std::uint32_t joint = 0;           // of a manual joint command: index in RobotModel::joints
  float position = 0.0F;             // [rad]
  std::uint32_t duration_slots = 0;  // time slots of 10 ms over which the joint moves there

  friend bool operator==(const UserCommandMail&, const UserCommandMail&) = default;
};

enum class MailKind : std::uint32_t { hand_over = 0, trim = 1, user_command = 2 };
inline constexpr std::size_t kMailKinds = 3;

enum class Verdict : std::uint32_t { accepted = 0, late = 1, refused = 2, corrupt = 3 };

enum class Reason : std::uint32_t {
  none = 0,
  checksum,           // the mail was damaged on its way
  too_late,           // no time left to send it before its cycle begins
  old_sequence,       // a batch for this cycle, or a later one, was accepted before
  early_sequence,     // for a cycle after the next one
  wrong_size,         // joints or points don't fit the robot
  not_finite,         // a position is no finite number
  jump,               // doesn't begin where the joint's reference ends
  too_fast,           // a change between two points that doesn't fit a trajectory frame
  beyond_limits,      // outside the joint's limits
  stopping,           // a stop was asked for: the safe tail plays to its end first
  moving_by_hand,     // a manual joint command is still being carried out
  emergency_stopped,  // not while an emergency stop holds
  not_standing,       // a manual joint command while the robot moves
  unknown_joint,
  unknown_command,
  node_fault,        // a local controller that is needed is missing or reports a fault
  not_stopped = 18,  // a release without an emergency stop; 17 is not given
  releasing          // a release while another one is being carried out
};
// One sentence for people.
std::string_view reason_text(Reason reason) noexcept;
std::string_view verdict_name(Verdict verdict) noexcept;

// Message controller to host: exactly one for each hand-over and each user command.
struct Answer {
  MailKind mail = MailKind::hand_over;
  std::uint32_t sequence = 0;  // of the mail that is answered; of a corrupt one: as far as it could be read
  Verdict verdict = Verdict::accepted;
  Reason reason = Reason::none;
  std::int32_t joint = -1;  // the joint that the reason is about; -1: none
  std::int32_t point = -1;  // the point that the reason is about; -1: none
  float value = 0.0F;       // what was found there, e.g. counts; see the reason

  friend bool operator==(const Answer&, const Answer&) = default;
};

}  // namespace gaitway::msgclient
