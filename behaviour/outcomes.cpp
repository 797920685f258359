// From the leaves, which may answer anything, up to the root.
#include "gaitway/behaviour/outcomes.hpp"

#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

namespace gaitway::behaviour {
namespace {

// Of results, those that may come: more than that does no harm, less does.
struct Answers {
  bool success = false, failure = false, skipped = false;
};

class Structure {
 public:
  explicit Structure(const Description& tree) : tree_(tree), answers_(tree.nodes.size()) {
    // Children lie behind their parents.
    for (auto node = static_cast<NodeIndex>(tree.nodes.size()); node-- > 0;) at(node) = of(node);
  }
  [[nodiscard]] bool root_may_succeed() const { return answers_.front().success; }

 private:
  Answers& at(NodeIndex node) { return answers_[static_cast<std::size_t>(node)]; }

  [[nodiscard]] std::vector<Answers> children(NodeIndex node) {
    std::vector<Answers> found;
    const DescribedNode& described = tree_.nodes[static_cast<std::size_t>(node)];
    for (NodeIndex child = described.children > 0 ? node + 1 : kNoNode; child != kNoNode;
         child = tree_.nodes[static_cast<std::size_t>(child)].next_sibling) {
      found.push_back(at(child));
    }
    return found;
  }

  // The node's first port; nothing: it is set while the tree runs.
  [[nodiscard]] std::optional<std::int64_t> constant(NodeIndex node) const {
    const auto ports = tree_.ports(node);
    if (ports.empty() || ports[0].source != PortBinding::Source::constant) return std::nullopt;
    const auto* const value = std::get_if<std::int64_t>(&tree_.constants[ports[0].index]);
    return value != nullptr ? std::optional(*value) : std::nullopt;
  }

  // As many children as the first port says; negative numbers count from their number.
  [[nodiscard]] bool enough_may_succeed(NodeIndex node, const std::vector<Answers>& children) const {
    const std::optional<std::int64_t> given = constant(node);
    if (!given) return true;
    const auto all = static_cast<std::int64_t>(children.size());
    const std::int64_t wanted = *given < 0 ? all + *given + 1 : std::min(*given, all);
    return std::ranges::count_if(
               children, [](const Answers& child) { return child.success || child.skipped; }) >= wanted;
  }

  [[nodiscard]] Answers of(NodeIndex node) {
    const std::vector<Answers> below = children(node);
    const auto any = [&below](bool Answers::*what) { return std::ranges::any_of(below, what); };
    const auto all = [&below](bool Answers::*what) {
      return std::ranges::all_of(below,
                                 [what](const Answers& child) { return child.*what || child.skipped; });
    };
    const bool all_skipped = !below.empty() && std::ranges::all_of(below, &Answers::skipped);
    switch (tree_.nodes[static_cast<std::size_t>(node)].type) {
      case NodeType::sequence:
      case NodeType::sequence_with_memory:
      case NodeType::reactive_sequence:
        return {all(&Answers::success), any(&Answers::failure), all_skipped};
      case NodeType::fallback:
      case NodeType::reactive_fallback:
        return {any(&Answers::success), all(&Answers::failure), all_skipped};
      case NodeType::parallel:
        return {enough_may_succeed(node, below), true, all_skipped};
      case NodeType::parallel_all:
        return {true, true, all_skipped};
      case NodeType::if_then_else:
      case NodeType::while_do_else:
      case NodeType::switch_cases:
        return {any(&Answers::success), true, any(&Answers::skipped)};
      case NodeType::always_failure:
        return {.failure = true};
      case NodeType::always_success:
        return {.success = true};
      case NodeType::sleep:
      case NodeType::set_blackboard:
      case NodeType::condition:
        return {.success = true, .failure = true};
      case NodeType::action:
        return {true, true, true};
      default:
        return of_decorator(node, below[0]);
    }
  }

  // Numbers of rounds below 0 are without end; one that is set while the tree runs may be any.
  [[nodiscard]] Answers of_decorator(NodeIndex node, const Answers& below) const {
    const std::optional<std::int64_t> rounds = constant(node);
    const bool may_be_none = rounds.value_or(0) == 0, may_end = rounds.value_or(0) >= 0;
    switch (tree_.nodes[static_cast<std::size_t>(node)].type) {
      case NodeType::inverter:
        return {below.failure, below.success, below.skipped};
      case NodeType::force_success:
        return {below.success || below.failure, false, below.skipped};
      case NodeType::force_failure:
        return {false, below.success || below.failure, below.skipped};
      case NodeType::repeat:
        return {(below.success && may_end) || may_be_none, true, below.skipped};
      case NodeType::retry_until_successful:
        return {below.success, (below.failure && may_end) || may_be_none, below.skipped};
      case NodeType::keep_running_until_failure:
        return {false, below.failure, false};
      case NodeType::run_once:
        return {below.success, below.failure, true};
      case NodeType::delay:
      case NodeType::cooldown:
      case NodeType::timeout:
        return {below.success, true, below.skipped};
      default:
        return below;  // a sub-tree
    }
  }

  const Description& tree_;
  std::vector<Answers> answers_;
};

}  // namespace

bool may_succeed(const Description& tree) {
  return tree.nodes.empty() || Structure(tree).root_may_succeed();
}

}  // namespace gaitway::behaviour
