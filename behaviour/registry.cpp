// Registered leaves, checked when they are added.
#include "gaitway/behaviour/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "builtin_nodes.hpp"
#include "gaitway/input/number.hpp"
#include "xml_characters.hpp"

namespace gaitway::behaviour {
namespace {

[[noreturn]] void refuse(const LeafSpec& leaf, const std::string& what) {
  throw std::invalid_argument(fmt::format("behaviour leaf '{}': {}", leaf.id, what));
}

bool is_name(std::string_view name) {
  return !name.empty() && name_length(name) == name.size() &&
         name.find_first_of(":.") == std::string_view::npos && !first_forbidden(name);
}

void check_port(const LeafSpec& leaf, const PortSpec& port) {
  const auto wrong = [&](const std::string& what) {
    refuse(leaf, fmt::format("port '{}' {}", port.name, what));
  };
  if (!is_name(port.name) || port.name.starts_with('_') || port.name == "name" || port.name == "ID") {
    wrong("has no name that an attribute may have");
  }
  if (port.type.kind == ValueKind::choice && port.type.choices.empty()) wrong("has no choices");
  if (!port.type.unit.empty() && (port.type.kind != ValueKind::number || !is_known_unit(port.type.unit))) {
    wrong(fmt::format("has the unit '{}', which is not known for its type", port.type.unit));
  }
  if (!port.standard) return;
  if (port.direction != PortDirection::input) wrong("is an output with a standard value");
  try {
    (void)parse_value(*port.standard, port.type);
  } catch (const input::ValueError& error) {
    wrong(fmt::format("has the standard value '{}': {}", *port.standard, error.rule));
  }
}

}  // namespace

void Registry::add(Leaf leaf) {
  const LeafSpec& spec = leaf.spec;
  if (!is_name(spec.id)) refuse(spec, "is no name that an element may have");
  if (find_builtin(spec.id) != nullptr || find_unsupported_node(spec.id) != nullptr ||
      is_reserved_element(spec.id)) {
    refuse(spec, "the format has this name for something else");
  }
  if (leaves_.contains(spec.id)) refuse(spec, "is there already");
  if (std::visit([](const auto& maker) { return !maker; }, leaf.maker)) refuse(spec, "has no maker");
  std::set<std::string_view> names;
  for (const PortSpec& port : spec.ports) {
    check_port(spec, port);
    if (!names.insert(port.name).second) refuse(spec, fmt::format("has the port '{}' twice", port.name));
  }
  std::string id = spec.id;
  leaves_.emplace(std::move(id), std::move(leaf));
}

void Registry::add_condition(LeafSpec spec, ConditionMaker maker) {
  add({std::move(spec), std::move(maker)});
}
void Registry::add_action(LeafSpec spec, ActionMaker maker) {
  add({std::move(spec), std::move(maker)});
}

const Registry::Leaf* Registry::find(std::string_view id) const {
  const auto found = leaves_.find(id);
  return found == leaves_.end() ? nullptr : &found->second;
}

}  // namespace gaitway::behaviour
