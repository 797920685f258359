// The table of docs/commands.md, event by event.
#include "gaitway/msgcontroller/command_authority.hpp"

namespace gaitway::msgcontroller {

void CommandAuthority::enter(Commander commander, CommandReason reason) noexcept {
  if (commander == commander_ && reason == reason_) return;
  commander_ = commander;
  reason_ = reason;
  ++changes_;
}

bool CommandAuthority::person_commands(CommandReason reason) noexcept {
  if (commander_ == Commander::emergency_stop) return false;
  enter(Commander::person, reason);
  return true;
}

void CommandAuthority::person_stops() noexcept {
  may_get_up_ = false;
  if (commander_ != Commander::emergency_stop) enter(Commander::person, CommandReason::person_stops);
}

void CommandAuthority::person_is_lost() noexcept {
  // Who has stopped the robot before has the last word.
  if (commander_ == Commander::person && reason_ != CommandReason::person_stops &&
      reason_ != CommandReason::emergency_stop_released) {
    enter(Commander::person, CommandReason::person_is_lost);
  }
}

bool CommandAuthority::person_lets_go() noexcept {
  if (commander_ == Commander::emergency_stop) return false;
  may_get_up_ = false;
  if (commander_ == Commander::person) enter(Commander::nobody, CommandReason::person_lets_go);
  return true;
}

void CommandAuthority::emergency_stop(bool in_force) noexcept {
  if (in_force) {
    may_get_up_ = false;
    enter(Commander::emergency_stop, CommandReason::emergency_stop);
  } else if (commander_ == Commander::emergency_stop) {
    enter(Commander::person, CommandReason::emergency_stop_released);
  }
}

void CommandAuthority::fall(bool fallen) noexcept {
  const bool begins = fallen && !fallen_;
  fallen_ = fallen;
  if (begins && commander_ == Commander::person && reason_ != CommandReason::person_stops &&
      reason_ != CommandReason::emergency_stop_released) {
    may_get_up_ = true;
  }
}

bool CommandAuthority::behaviour_commands() noexcept {
  if (commander_ != Commander::nobody && commander_ != Commander::behaviour) return false;
  enter(Commander::behaviour, CommandReason::behaviour_orders);
  return true;
}

void CommandAuthority::behaviour_is_done() noexcept {
  if (commander_ == Commander::behaviour) enter(Commander::nobody, CommandReason::behaviour_is_done);
}

std::string_view sentence(Commander commander, CommandReason reason) noexcept {
  switch (reason) {
    case CommandReason::start:
      return "nobody commands the robot yet";
    case CommandReason::behaviour_orders:
      return "the behaviour commands";
    case CommandReason::behaviour_is_done:
      return "nobody commands: the behaviour has come to an end";
    case CommandReason::person_orders:
      return "a person commands: has given an order. The behaviour waits until the command is let go";
    case CommandReason::person_takes:
      return "a person commands: has taken the command. The behaviour waits until it is let go";
    case CommandReason::person_stops:
      return "a person has stopped the robot: it stands until somebody orders something, or lets the command "
             "go";
    case CommandReason::person_lets_go:
      return "nobody commands: a person has let the command go, and the behaviour may have it";
    case CommandReason::person_is_lost:
      return "the person who commands is lost: the robot stands until somebody orders something, or lets the "
             "command go";
    case CommandReason::person_moves_joint:
      return "a person commands: moves a joint. The behaviour waits until the command is let go";
    case CommandReason::emergency_stop:
      return "nobody commands: an emergency stop is in force";
    case CommandReason::emergency_stop_released:
      return "the emergency stop is released: the robot stands until somebody orders something, or lets the "
             "command go";
  }
  return commander == Commander::nobody ? "nobody commands the robot" : "";
}

}  // namespace gaitway::msgcontroller
