// The names of statuses and kinds of nodes.
#include "gaitway/behaviour/node_type.hpp"

#include <array>
#include <cstddef>

namespace gaitway::behaviour {

std::string_view name(NodeStatus status) noexcept {
  constexpr std::array<std::string_view, 6> kNames{"idle",    "running", "success",
                                                   "failure", "skipped", "halting"};
  return kNames[static_cast<std::size_t>(status)];
}

std::string_view name(NodeKind kind) noexcept {
  constexpr std::array<std::string_view, 5> kNames{"Control", "Decorator", "SubTree", "Condition", "Action"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace gaitway::behaviour
