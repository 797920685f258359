// From the leaves, which may answer anything, up to the root.
#include "gaitway/behaviour/outcomes.hpp"

#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

namespace gaitway::behaviour {
namespace {

struct Answers {
  bool success = true, failure = true;
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
    return std::ranges::count_if(children, &Answers::success) >= (*given < 0 ? all + *given + 1 : *given);
  }

  [[nodiscard]] Answers of(NodeIndex node) {
    const std::vector<Answers> below = children(node);
    const bool is_endless = constant(node).value_or(0) < 0;
    const auto any = [&below](bool Answers::*what) { return std::ranges::any_of(below, what); };
    const auto all = [&below](bool Answers::*what) { return std::ranges::all_of(below, what); };
    switch (tree_.nodes[static_cast<std::size_t>(node)].type) {
      case NodeType::sequence:
      case NodeType::sequence_with_memory:
      case NodeType::reactive_sequence:
        return {all(&Answers::success), any(&Answers::failure)};
      case NodeType::fallback:
      case NodeType::reactive_fallback:
        return {any(&Answers::success), all(&Answers::failure)};
      case NodeType::parallel:
        return {enough_may_succeed(node, below), true};
      case NodeType::inverter:
        return {below[0].failure, below[0].success};
      case NodeType::force_success:
        return {below[0].success || below[0].failure, false};
      case NodeType::force_failure:
        return {false, below[0].success || below[0].failure};
      case NodeType::repeat:
        return {below[0].success && !is_endless, below[0].failure};
      case NodeType::retry_until_successful:
        return {below[0].success, below[0].failure && !is_endless};
      case NodeType::keep_running_until_failure:
        return {false, below[0].failure};
      case NodeType::delay:
      case NodeType::cooldown:
      case NodeType::run_once:
      case NodeType::sub_tree:
        return below[0];
      case NodeType::timeout:
        return {below[0].success, true};
      case NodeType::always_failure:
        return {false, true};
      case NodeType::always_success:
      case NodeType::sleep:
      case NodeType::set_blackboard:
        return {true, false};
      case NodeType::parallel_all:
      case NodeType::if_then_else:
      case NodeType::while_do_else:
      case NodeType::switch_cases:
        return {any(&Answers::success), true};
      case NodeType::condition:
      case NodeType::action:
        return {};
    }
    return {};
  }

  const Description& tree_;
  std::vector<Answers> answers_;
};

}  // namespace

bool may_succeed(const Description& tree) {
  return tree.nodes.empty() || Structure(tree).root_may_succeed();
}

}  // namespace gaitway::behaviour
