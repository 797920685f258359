// The nodes that every tree has at hand, and the names of BehaviorTree.CPP's format that are not taken.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/behaviour/node_type.hpp"
#include "gaitway/behaviour/registry.hpp"

namespace gaitway::behaviour {

struct Builtin {
  std::string id;
  NodeType type = NodeType::always_success;
  NodeKind kind = NodeKind::action;
  std::size_t least_children = 0;
  std::size_t most_children = 0;
  std::vector<PortSpec> ports{};
};

[[nodiscard]] std::span<const Builtin> builtin_nodes();
[[nodiscard]] const Builtin* find_builtin(std::string_view id);

// The places of ports, in the order of Builtin::ports.
namespace port {
inline constexpr std::size_t kTime = 0;   // of Timeout, Delay, Cooldown and Sleep
inline constexpr std::size_t kCount = 0;  // of Repeat and RetryUntilSuccessful
inline constexpr std::size_t kSuccessCount = 0, kFailureCount = 1, kMaxFailures = 0, kThenSkip = 0;
inline constexpr std::size_t kVariable = 0, kFirstCase = 1;
inline constexpr std::size_t kWritten = 0, kOutputKey = 1;
}  // namespace port

// A node, element or attribute of the format that is refused, and what to write in its place.
struct Unsupported {
  std::string_view name;
  std::string_view remedy;
};
[[nodiscard]] const Unsupported* find_unsupported_node(std::string_view id);
[[nodiscard]] const Unsupported* find_unsupported_attribute(std::string_view attribute);

// Attributes that editors write and nobody reads here.
[[nodiscard]] bool is_editor_attribute(std::string_view attribute);
// "Action", "BehaviorTree"…: no leaf may have this name.
[[nodiscard]] bool is_reserved_element(std::string_view name);

}  // namespace gaitway::behaviour
