// Follows keys through the ports of sub-trees, and finds one type for each entry.
#include "blackboard_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "gaitway/input/number.hpp"

namespace gaitway::behaviour {

BlackboardLayout::BlackboardLayout(Description& description, Complaints& complaints)
    : description_(description), complaints_(complaints), scopes_(1) {}

ScopeIndex BlackboardLayout::add_scope(ScopeIndex around, NodeIndex node, const Definition& tree,
                                       std::size_t defined) {
  const DefinedNode& sub_tree = tree.nodes[defined];
  Scope scope{
      .around = around, .node = node, .autoremap = sub_tree.autoremap, .tree = &tree, .defined = defined};
  for (const Remapping& remapping : sub_tree.remappings)
    scope.remaps.emplace(remapping.inner, Remap{&remapping});
  scopes_.push_back(std::move(scope));
  return scopes_.size() - 1;
}

std::uint32_t BlackboardLayout::make_entry(ScopeIndex scope, std::string_view key) {
  const auto index = static_cast<std::uint32_t>(description_.entries.size());
  description_.entries.push_back({.key = std::string(key), .scope = scopes_[scope].node});
  scopes_[scope].own.emplace(key, index);
  united_with_.push_back(index);
  return index;
}

std::uint32_t BlackboardLayout::entry(ScopeIndex scope, std::string_view key) {
  if (key.starts_with('@')) {
    scope = 0;
    key.remove_prefix(1);
  }
  for (;;) {
    Scope& here = scopes_[scope];
    if (const auto own = here.own.find(key); own != here.own.end()) return own->second;
    if (scope == 0) return make_entry(scope, key);
    const auto remap = here.remaps.find(key);
    if (remap != here.remaps.end()) {
      remap->second.used = true;
      const Remapping& remapping = *remap->second.remapping;
      if (remapping.constant) {
        const std::uint32_t made = make_entry(scope, key);
        initials_.push_back({made, &remapping, scope});
        return made;
      }
      key = remapping.outer;
      const bool global = key.starts_with('@');
      scope = global ? 0 : here.around;
      key.remove_prefix(global ? 1 : 0);
    } else if (here.autoremap && !key.starts_with('_')) {
      scope = here.around;
    } else {
      return make_entry(scope, key);
    }
  }
}

void BlackboardLayout::use(std::uint32_t entry, const PortSpec& spec, int line, NodeIndex node) {
  uses_.push_back({entry, &spec, line, node});
}

std::uint32_t BlackboardLayout::united(std::uint32_t entry) {
  while (united_with_[entry] != entry) {
    united_with_[entry] = united_with_[united_with_[entry]];
    entry = united_with_[entry];
  }
  return entry;
}

void BlackboardLayout::unite(std::uint32_t a, std::uint32_t b) {
  united_with_[united(a)] = united(b);
}

void BlackboardLayout::write_later(std::size_t binding, std::int64_t typed_by, const PortText& text,
                                   std::string_view field, NodeIndex node) {
  waiting_.push_back({binding, typed_by, text.text, std::string(field), text.line, node});
}

// No value leaves the range that all ports take which are connected with an entry.
void BlackboardLayout::narrow(ValueType& type, const Use& use, int first_line) {
  const bool possible = type.lowest <= type.highest;
  type.lowest = std::max(type.lowest, use.spec->type.lowest);
  type.highest = std::min(type.highest, use.spec->type.highest);
  if (type.lowest <= type.highest || !possible || complaints_.full()) return;
  complaints_.add({use.line, description_.path(use.node)}, use.spec->name,
                  fmt::format("{{{}}}", description_.entries[use.entry].key),
                  fmt::format("takes no value that the other ports of this entry take (line {})", first_line),
                  "Use two entries");
}

void BlackboardLayout::type_entries() {
  std::vector<const Use*> first(description_.entries.size(), nullptr);
  std::set<std::pair<int, std::string_view>> told;  // a sub-tree used many times has its mistakes once
  for (const Use& use : uses_) {
    if (use.spec->type.kind == ValueKind::any) continue;
    const std::uint32_t root = united(use.entry);
    ValueType& type = description_.entries[root].type;
    if (first[root] == nullptr) {
      first[root] = &use;
      type = use.spec->type;
    } else if (!same_type(type, use.spec->type)) {
      if (complaints_.full() || !told.emplace(use.line, use.spec->name).second) continue;
      complaints_.add({use.line, description_.path(use.node)}, use.spec->name,
                      fmt::format("{{{}}}", description_.entries[use.entry].key),
                      fmt::format("takes {}, but line {} has this entry as {}", describe(use.spec->type),
                                  first[root]->line, describe(type)),
                      "Use two entries, or ports of one type");
    } else {
      narrow(type, use, first[root]->line);
    }
  }
  for (std::uint32_t i = 0; i < description_.entries.size(); ++i) {
    ValueType& type = description_.entries[united(i)].type;
    if (type.kind == ValueKind::any) type.kind = ValueKind::text;
    if (united(i) != i) description_.entries[i].type = type;
  }
}

template <class Path>
Value BlackboardLayout::read(const std::string& text, const ValueType& type, int line, const Path& path,
                             const std::string& field) {
  try {
    return parse_value(text, type);
  } catch (const input::ValueError& error) {
    if (complaints_.full()) return {};
    complaints_.add({line, path()}, field, text, explained(error.rule, type), error.remedy);
    return {};
  }
}

void BlackboardLayout::read_waiting() {
  const ValueType text{.kind = ValueKind::text};
  for (const Waiting& waiting : waiting_) {
    const ValueType& type =
        waiting.typed_by < 0 ? text : description_.entries[static_cast<std::size_t>(waiting.typed_by)].type;
    PortBinding& binding = description_.bindings[waiting.binding];
    binding = {.source = PortBinding::Source::constant,
               .index = static_cast<std::uint32_t>(description_.constants.size())};
    description_.constants.push_back(read(
        waiting.text, type, waiting.line, [&] { return description_.path(waiting.node); }, waiting.field));
  }
}

void BlackboardLayout::read_initials() {
  for (const Initial& initial : initials_) {
    Entry& entry = description_.entries[initial.entry];
    const Scope& scope = scopes_[initial.scope];
    entry.initial = read(
        initial.remapping->outer, entry.type, initial.remapping->line,
        [&] { return scope.tree->path(scope.defined); }, initial.remapping->inner);
  }
}

// A port that a sub-tree is given and none of its nodes looks at is misspelt.
void BlackboardLayout::check_remaps() {
  for (const Scope& scope : scopes_) {
    for (const auto& [inner, remap] : scope.remaps) {
      if (remap.used || remap.remapping->from_model) continue;
      std::vector<std::string> known;
      for (const auto& [key, entry] : scope.own) known.push_back(key);
      for (const auto& [other, row] : scope.remaps) {
        if (row.used) known.push_back(other);
      }
      complaints_.add({remap.remapping->line, scope.tree->path(scope.defined)}, inner, remap.remapping->outer,
                      "no node of the sub-tree uses this key", input::suggest(inner, known));
      if (complaints_.full()) return;
    }
  }
}

void BlackboardLayout::finish() {
  type_entries();
  read_waiting();
  read_initials();
  check_remaps();
}

}  // namespace gaitway::behaviour
