// A hand-over in counts: the batch and its safe tail as the joints will count them. Rounding each absolute
// point, and sending differences of rounded points, is the error feedback: what one point loses, the next one
// gains.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "gaitway/msgclient/hand_over.hpp"
#include "gaitway/msgclient/mails.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgcontroller {

struct CountPlan {
  std::uint32_t sequence = 0;  // 0: none
  int joint_count = 0;
  int point_count = 0;  // batch and tail
  int first_point = 0;  // of a revision: those before it have been played, and are not here
  std::array<std::array<std::int32_t, kMaxJoints>, kMaxPoints> count{};
  std::array<std::uint8_t, kMaxPoints> support{};
};

// Why a hand-over cannot be sent: which joint, at which point, by how much. Reason::none: it can.
struct CountPlanProblem {
  msgclient::Reason reason = msgclient::Reason::none;
  std::int32_t joint = -1;
  std::int32_t point = -1;
  double counts = 0.0;  // the change that was asked for
};

// Converts a hand-over. `count_rad`: size of a count of each joint. `start_count`: each joint's reference
// where the batch, or the revised part of it, begins. Every change of 10 ms must fit the signed byte of a
// trajectory frame; nothing is clipped.
CountPlanProblem to_counts(const msgclient::HandOver& hand_over, std::span<const double> count_rad,
                           std::span<const std::int32_t> start_count, CountPlan& plan) noexcept;

}  // namespace gaitway::msgcontroller
