// A running behaviour tree: ticked once a cycle, told the time, changed while it runs.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/behaviour/description.hpp"
#include "gaitway/behaviour/node_type.hpp"
#include "gaitway/behaviour/registry.hpp"

namespace gaitway::behaviour {

// What a tick or a halt has made of a node.
struct Transition {
  NodeIndex node = kNoNode;
  NodeStatus from = NodeStatus::idle;
  NodeStatus to = NodeStatus::idle;
  std::int64_t time_ns = 0;
};

struct Change {
  std::vector<std::string> refused;  // why nothing was changed; empty: it is done
  std::size_t kept = 0;              // nodes that went over with their state
  std::size_t added = 0;
  std::size_t removed = 0;
  [[nodiscard]] bool done() const noexcept { return refused.empty(); }
};

class NodeArray;
struct Counterparts;

// Another description made ready to take a tree's place: everything that needs memory is done. Once it has
// been adopted, it holds what the tree was before, to be destroyed where that does no harm.
class PreparedChange {
 public:
  PreparedChange(std::unique_ptr<NodeArray> nodes, std::unique_ptr<Counterparts> counterparts) noexcept;
  ~PreparedChange();
  PreparedChange(PreparedChange&&) noexcept;
  PreparedChange& operator=(PreparedChange&&) noexcept;

 private:
  friend class Tree;
  std::unique_ptr<NodeArray> nodes_;
  std::unique_ptr<Counterparts> counterparts_;
};

// One thread's object. After the constructor nothing asks for memory but what says so.
class Tree {
 public:
  // Makes the leaves. `registry` must be the one that the description was checked against; otherwise throws
  // std::invalid_argument.
  Tree(Description description, const Registry& registry);
  ~Tree();  // leaves are destroyed without on_halt(): halt() first
  Tree(Tree&&) noexcept;
  Tree& operator=(Tree&&) noexcept;

  // One pass from the root; each leaf is called at most once, besides a halt. A tree that has ended begins
  // anew. `now_ns` may not be less than at the tick before: then it counts as the same.
  // Returns running, success, failure or skipped.
  NodeStatus tick(std::int64_t now_ns) noexcept;

  // Ends everything. True: every action has come to its end. Otherwise to be called again, once a cycle,
  // until it is true; a tick in between waits for that end, too, and then begins anew.
  bool halt(std::int64_t now_ns) noexcept;

  // After a halt that has ended everything: what nodes remember from one run to the next (SequenceWithMemory,
  // RunOnce, Cooldown) is forgotten, and the blackboard holds its first values. Leaves keep what is theirs.
  void reset() noexcept;

  [[nodiscard]] const Description& description() const noexcept;
  // One byte a node, in the description's order, as the last tick or halt has left them.
  [[nodiscard]] std::span<const NodeStatus> statuses() const noexcept;
  // The nodes whose status is another than before the last tick() or halt(), each once; none after change(),
  // which numbers nodes anew.
  [[nodiscard]] std::span<const Transition> transitions() const noexcept;

  // An entry of the main tree's blackboard; nothing: no port is connected with that key.
  [[nodiscard]] std::optional<std::size_t> entry(std::string_view key) const noexcept;
  // All values, in the order of Description::entries.
  [[nodiscard]] std::span<const Value> values() const noexcept;
  // False: there is no such entry, or the value is not of its type.
  bool set_value(std::size_t entry, const Value& value) noexcept;

  // Going over to another description between two ticks, in one step. Nodes with the same path and type keep
  // state and leaf, entries with the same place and type their value. Refused, with every reason and nothing
  // changed: an active action, or a node that goes on at a child, has no counterpart; an entry that is set
  // would hold what its type does not take. Asks for memory.
  Change change(Description next, const Registry& registry);

  // The same in two steps. The first asks for memory, makes the leaves that are new, and may be done by
  // another thread while this tree is ticked: it looks at the description alone. Throws std::invalid_argument
  // as the constructor.
  [[nodiscard]] PreparedChange prepare(Description next, const Registry& registry) const;
  // The second asks for no memory and goes between two ticks. False: refused, and nothing is changed; to be
  // tried again at a later tick, or explained. Also refused once the tree is no longer the one it was made
  // for.
  bool adopt(PreparedChange& change) noexcept;
  // Why it would be refused now; empty: it would not. Asks for memory.
  [[nodiscard]] std::vector<std::string> refusals(const PreparedChange& change) const;

 private:
  std::unique_ptr<NodeArray> nodes_;
};

}  // namespace gaitway::behaviour
