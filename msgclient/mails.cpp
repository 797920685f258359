// Texts of verdicts and reasons.
#include "gaitway/msgclient/mails.hpp"

namespace gaitway::msgclient {

std::string_view reason_text(Reason reason) noexcept {
  switch (reason) {
    case Reason::none:
      return "no reason";
    case Reason::checksum:
      return "the mail's checksum is wrong: it was damaged on its way";
    case Reason::too_late:
      return "it came too late to be sent before its cycle begins";
    case Reason::old_sequence:
      return "a batch for this or a later cycle was accepted before";
    case Reason::early_sequence:
      return "it is for a cycle after the next one";
    case Reason::wrong_size:
      return "its number of joints or points doesn't fit the robot";
    case Reason::not_finite:
      return "a position is not a finite number";
    case Reason::jump:
      return "it doesn't begin where the joint's reference ends";
    case Reason::too_fast:
      return "a change between two points is too large for a trajectory frame";
    case Reason::beyond_limits:
      return "a position is outside the joint's limits";
    case Reason::stopping:
      return "a stop was asked for: the safe tail plays to its end first";
    case Reason::moving_by_hand:
      return "a joint is moving by a manual command, or was left away from where the plan has it: move it "
             "back";
    case Reason::emergency_stopped:
      return "the robot is in emergency stop, which /release ends";
    case Reason::not_standing:
      return "joints are commanded by hand only while the robot stands";
    case Reason::unknown_joint:
      return "the robot has no such joint";
    case Reason::unknown_command:
      return "the command is not known";
    case Reason::node_fault:
      return "a local controller that is needed is missing or reports a fault";
    case Reason::nothing_to_revise:
      return "it revises a batch that doesn't run, or from a time slot from which this network revises none";
    case Reason::not_stopped:
      return "the robot is not in emergency stop";
    case Reason::releasing:
      return "the emergency stop is being released already";
  }
  return "unknown reason";
}

std::string_view verdict_name(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::accepted:
      return "accepted";
    case Verdict::late:
      return "late";
    case Verdict::refused:
      return "refused";
    case Verdict::corrupt:
      return "corrupt";
  }
  return "unknown verdict";
}

}  // namespace gaitway::msgclient
