// What a node of a behaviour tree can be, and what it can be at an instant.
#pragma once

#include <cstdint>
#include <string_view>

namespace gaitway::behaviour {

enum class NodeStatus : std::uint8_t {
  idle,
  running,
  success,  // the three results stay until the node, or one above it, begins anew or is halted
  failure,
  skipped,  // it had nothing to do
  halting  // it comes to its end: an action after on_halt(), or a node that waits for such an action below it
};
[[nodiscard]] std::string_view name(NodeStatus status) noexcept;

// What a leaf may answer; the values are those of NodeStatus.
enum class Outcome : std::uint8_t { running = 1, success = 2, failure = 3, skipped = 4 };

enum class NodeKind : std::uint8_t { control, decorator, sub_tree, condition, action };
// The element of the explicit syntax: "Control".
[[nodiscard]] std::string_view name(NodeKind kind) noexcept;

// Condition and action: the leaves that the user of the library registers.
enum class NodeType : std::uint8_t {
  sequence,
  sequence_with_memory,
  reactive_sequence,
  fallback,
  reactive_fallback,
  parallel,
  parallel_all,
  if_then_else,
  while_do_else,
  switch_cases,
  inverter,
  force_success,
  force_failure,
  repeat,
  retry_until_successful,
  keep_running_until_failure,
  run_once,
  timeout,
  delay,
  cooldown,
  sub_tree,
  always_success,
  always_failure,
  sleep,
  set_blackboard,
  condition,
  action
};

}  // namespace gaitway::behaviour
