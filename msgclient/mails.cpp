// Texts of verdicts and reasons.
#include "gaitway/msgclient/mails.hpp"

#include <array>

namespace gaitway::msgclient {
namespace {

constexpr std::array<std::string_view, 20> kReasons{
    "no reason",
    "the mail's checksum is wrong: it was damaged on its way",
    "it came too late to be sent before its cycle begins",
    "a batch for this or a later cycle was accepted before",
    "it is for a cycle after the next one",
    "its number of joints or points doesn't fit the robot",
    "a position is not a finite number",
    "it doesn't begin where the joint's reference ends",
    "a change between two points is too large for a trajectory frame",
    "a position is outside the joint's limits",
    "a stop was asked for: the safe tail plays to its end first",
    "a joint is moving by a manual command, or was left away from where the plan has it: move it back",
    "the robot is in emergency stop, which /release ends",
    "joints are commanded by hand only while the robot stands",
    "the robot has no such joint",
    "the command is not known",
    "a local controller that is needed is missing or reports a fault",
    "unknown reason",
    "the robot is not in emergency stop",
    "the emergency stop is being released already",
};
static_assert(kReasons.size() == static_cast<std::size_t>(Reason::releasing) + 1);

constexpr std::array<std::string_view, 4> kVerdicts{"accepted", "late", "refused", "corrupt"};

}  // namespace

// They come out of shared memory, where anything may stand.
std::string_view reason_text(Reason reason) noexcept {
  const auto index = static_cast<std::size_t>(reason);
  return index < kReasons.size() ? kReasons[index] : "unknown reason";
}

std::string_view verdict_name(Verdict verdict) noexcept {
  const auto index = static_cast<std::size_t>(verdict);
  return index < kVerdicts.size() ? kVerdicts[index] : "unknown verdict";
}

}  // namespace gaitway::msgclient
