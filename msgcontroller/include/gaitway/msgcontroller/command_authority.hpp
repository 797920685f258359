// Who commands the robot, and why: emergency stop before person before behaviour. Knows no topic and no
// order; the CommandArbiter asks it. docs/commands.md has its table.
#pragma once

#include <cstdint>
#include <string_view>

namespace gaitway::msgcontroller {

// As CommandState has them.
enum class Commander : std::uint8_t { nobody, behaviour, person, emergency_stop };
enum class CommandReason : std::uint8_t {
  start,
  behaviour_orders,
  behaviour_is_done,
  person_orders,
  person_takes,
  person_stops,
  person_lets_go,
  person_is_lost,
  person_moves_joint,
  emergency_stop,
  emergency_stop_released
};

class CommandAuthority {
 public:
  // A person has given an order, taken the command, or moved a joint. False: an emergency stop is in force,
  // and nobody commands.
  bool person_commands(CommandReason reason) noexcept;
  // The robot stands until somebody orders something, or lets the command go.
  void person_stops() noexcept;
  // Their orders end; the command stays theirs: nothing goes on by itself.
  void person_is_lost() noexcept;
  // The behaviour may command. False: an emergency stop is in force.
  bool person_lets_go() noexcept;
  // In force or not, each millisecond. Whoever has stopped the robot so commands afterwards.
  void emergency_stop(bool in_force) noexcept;
  // The robot falls or lies, or it is upright, each millisecond. A fall ends what a person has ordered; if
  // nobody has stopped the robot, the behaviour may play the motions that get it up.
  void fall(bool fallen) noexcept;
  // A person's order that a robot which lies can obey, for which the behaviour makes room.
  void person_gets_it_up() noexcept { may_get_up_ = false; }
  // The behaviour has given an order, or has none in force any more. False: it does not command.
  bool behaviour_commands() noexcept;
  void behaviour_is_done() noexcept;
  // A motion that got the robot up has ended.
  void got_up() noexcept { may_get_up_ = may_get_up_ && fallen_; }

  [[nodiscard]] Commander commander() const noexcept { return commander_; }
  [[nodiscard]] CommandReason reason() const noexcept { return reason_; }
  [[nodiscard]] bool may_get_up() const noexcept { return may_get_up_; }
  // Of commander or reason, since the start.
  [[nodiscard]] std::uint32_t changes() const noexcept { return changes_; }

 private:
  void enter(Commander commander, CommandReason reason) noexcept;

  Commander commander_ = Commander::nobody;
  CommandReason reason_ = CommandReason::start;
  bool fallen_ = false;
  bool may_get_up_ = false;
  std::uint32_t changes_ = 0;
};

// For people: "a person commands: it was stopped, and stands until ...".
[[nodiscard]] std::string_view sentence(Commander commander, CommandReason reason) noexcept;

}  // namespace gaitway::msgcontroller
