// The table of built-in nodes: names, children and ports as in BehaviorTree.CPP 4.
#include "builtin_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

namespace gaitway::behaviour {
namespace {

constexpr std::size_t kMany = std::numeric_limits<std::size_t>::max();

PortSpec whole(std::string name, double lowest, std::optional<std::string> standard = {}) {
  return {.name = std::move(name),
          .type = {.kind = ValueKind::integer, .lowest = lowest, .highest = 2147483647.0},
          .standard = std::move(standard)};
}
PortSpec duration(std::string name) {
  return {.name = std::move(name), .type = {.kind = ValueKind::duration}};
}

Builtin control(std::string id, NodeType type, std::size_t least, std::size_t most,
                std::vector<PortSpec> ports = {}) {
  return {std::move(id), type, NodeKind::control, least, most, std::move(ports)};
}
Builtin decorator(std::string id, NodeType type, std::vector<PortSpec> ports = {}) {
  return {std::move(id), type, NodeKind::decorator, 1, 1, std::move(ports)};
}

Builtin switch_of(std::size_t cases) {
  std::vector<PortSpec> ports{{.name = "variable", .type = {.kind = ValueKind::any}}};
  for (std::size_t i = 1; i <= cases; ++i) {
    ports.push_back({.name = fmt::format("case_{}", i), .type = {.kind = ValueKind::any}});
  }
  return control(fmt::format("Switch{}", cases), NodeType::switch_cases, cases + 1, cases + 1,
                 std::move(ports));
}

std::vector<Builtin> make_builtins() {
  constexpr double kLeast = -2147483648.0;
  std::vector<Builtin> all{
      control("Sequence", NodeType::sequence, 1, kMany),
      control("SequenceWithMemory", NodeType::sequence_with_memory, 1, kMany),
      control("ReactiveSequence", NodeType::reactive_sequence, 1, kMany),
      control("Fallback", NodeType::fallback, 1, kMany),
      control("ReactiveFallback", NodeType::reactive_fallback, 1, kMany),
      control("Parallel", NodeType::parallel, 1, kMany,
              {whole("success_count", kLeast, "-1"), whole("failure_count", kLeast, "1")}),
      control("ParallelAll", NodeType::parallel_all, 1, kMany, {whole("max_failures", kLeast, "1")}),
      control("IfThenElse", NodeType::if_then_else, 2, 3),
      control("WhileDoElse", NodeType::while_do_else, 2, 3),
      decorator("Inverter", NodeType::inverter),
      decorator("ForceSuccess", NodeType::force_success),
      decorator("ForceFailure", NodeType::force_failure),
      decorator("Repeat", NodeType::repeat, {whole("num_cycles", -1.0)}),
      decorator("RetryUntilSuccessful", NodeType::retry_until_successful, {whole("num_attempts", -1.0)}),
      decorator("KeepRunningUntilFailure", NodeType::keep_running_until_failure),
      decorator("RunOnce", NodeType::run_once,
                {{.name = "then_skip", .type = {.kind = ValueKind::boolean}, .standard = "true"}}),
      decorator("Timeout", NodeType::timeout, {duration("msec")}),
      decorator("Delay", NodeType::delay, {duration("delay_msec")}),
      decorator("Cooldown", NodeType::cooldown, {duration("msec")}),
      {"AlwaysSuccess", NodeType::always_success, NodeKind::action},
      {"AlwaysFailure", NodeType::always_failure, NodeKind::action},
      {"Sleep", NodeType::sleep, NodeKind::action, 0, 0, {duration("msec")}},
      {"SetBlackboard",
       NodeType::set_blackboard,
       NodeKind::action,
       0,
       0,
       {{.name = "value", .type = {.kind = ValueKind::any}},
        {.name = "output_key", .type = {.kind = ValueKind::any}, .direction = PortDirection::output}}},
  };
  for (std::size_t cases = 2; cases <= 6; ++cases) all.push_back(switch_of(cases));
  return all;
}

constexpr std::string_view kNoScripts =
    "Register a condition or an action, and connect it with the blackboard";
constexpr std::array<Unsupported, 19> kNodes{{
    {"Script", kNoScripts},
    {"ScriptCondition", kNoScripts},
    {"Precondition", "Put a condition before the node, in a Sequence or a ReactiveSequence"},
    {"AsyncSequence", "Use Sequence: nothing blocks here"},
    {"AsyncFallback", "Use Fallback: nothing blocks here"},
    {"SequenceStar", "It is called SequenceWithMemory since version 4"},
    {"RetryUntilSuccesful", "It is written RetryUntilSuccessful"},
    {"ManualSelector", "Use Switch2 to Switch6 with an entry of the blackboard"},
    {"TryCatch", "Use Fallback, and on_halt() for what must be done at an end"},
    {"UnsetBlackboard", "Write a value that means nothing by SetBlackboard"},
    {"WasEntryUpdated", kNoScripts},
    {"SkipUnlessUpdated", kNoScripts},
    {"WaitValueUpdate", kNoScripts},
    {"LoopInt", "Use Repeat"},
    {"LoopBool", "Use Repeat"},
    {"LoopDouble", "Use Repeat"},
    {"LoopString", "Use Repeat"},
    {"ConsumeQueue", "Use Repeat and an action that takes one item"},
    {"SubTreePlus", "It is called SubTree, with _autoremap, since version 4"},
}};
constexpr std::string_view kNoPreconditions =
    "Put a condition before the node: in a Sequence, or, where it must hold all the time, in a "
    "ReactiveSequence";
constexpr std::string_view kNoPostconditions = "Put an action behind the node, or do it in on_halt()";
constexpr std::array<Unsupported, 8> kAttributes{{
    {"_failureIf", kNoPreconditions},
    {"_successIf", kNoPreconditions},
    {"_skipIf", kNoPreconditions},
    {"_while", kNoPreconditions},
    {"_onHalted", kNoPostconditions},
    {"_onFailure", kNoPostconditions},
    {"_onSuccess", kNoPostconditions},
    {"_post", kNoPostconditions},
}};

const Unsupported* find_in(std::span<const Unsupported> rows, std::string_view name) {
  const auto found = std::ranges::find(rows, name, &Unsupported::name);
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace

std::span<const Builtin> builtin_nodes() {
  static const std::vector<Builtin> kAll = make_builtins();
  return kAll;
}

const Builtin* find_builtin(std::string_view id) {
  const auto all = builtin_nodes();
  const auto found = std::ranges::find(all, id, &Builtin::id);
  return found == all.end() ? nullptr : &*found;
}

const Unsupported* find_unsupported_node(std::string_view id) {
  return find_in(kNodes, id);
}
const Unsupported* find_unsupported_attribute(std::string_view attribute) {
  return find_in(kAttributes, attribute);
}

bool is_editor_attribute(std::string_view attribute) {
  constexpr std::array<std::string_view, 6> kEditors{"_description", "_desc",     "_uid",
                                                     "_fullpath",    "_fullPath", "_collapsed"};
  return std::ranges::find(kEditors, attribute) != kEditors.end();
}

bool is_reserved_element(std::string_view name) {
  constexpr std::array<std::string_view, 11> kElements{
      "root",      "Root",    "BehaviorTree", "TreeNodesModel", "include", "Action",
      "Condition", "Control", "Decorator",    "SubTree",        "Metadata"};
  return std::ranges::find(kElements, name) != kElements.end();
}

}  // namespace gaitway::behaviour
