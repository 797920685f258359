// What a mission tells: its tree and their transitions, lines for people, answers.
#include <algorithm>
#include <utility>

#include "fixed_text.hpp"
#include "gaitway/behaviour_leaves/mission_runner.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::NodeStatus;

constexpr std::uint32_t kNodeOfNoTree = 0xFFFF'FFFF;
constexpr std::int64_t kSaysTheSameAgain_ns = 5'000'000'000;
// Who asks reads the answer's text by then.
constexpr std::int64_t kAnswerStays_ns = 1'000'000'000;

// One that comes to its end still runs, for who looks on.
std::uint8_t told(NodeStatus status) noexcept {
  return static_cast<std::uint8_t>(status == NodeStatus::halting ? NodeStatus::running : status);
}

// As the file has it. Without one the segment is the id, made unique by "#2".
std::string_view name_of(const behaviour::DescribedNode& node) noexcept {
  const std::string_view segment = node.segment;
  const bool is_id =
      segment.starts_with(node.id) && (segment.size() == node.id.size() || segment[node.id.size()] == '#');
  return is_id ? std::string_view() : segment;
}

}  // namespace

void MissionRunner::show(bool stand_up) noexcept {
  if (shows_stand_up_ == stand_up) return;
  shows_stand_up_ = stand_up;
  begin_revision();
}

// Transitions of the tree before keep their times, but name no node of this one.
void MissionRunner::begin_revision() noexcept {
  ++revision_;
  told_node_ = 0;
  transition_node_.fill(kNodeOfNoTree);
}

void MissionRunner::after_tree(const behaviour::Tree& tree) noexcept {
  ++ticks_;
  if (&tree != shown()) return;
  for (const behaviour::Transition& change : tree.transitions()) {
    const std::size_t at = transitions_ % kTreeTransitions;
    transition_ns_[at] = change.time_ns;
    transition_node_[at] = static_cast<std::uint32_t>(change.node);
    transition_to_[at] = told(change.to);
    ++transitions_;
  }
}

void MissionRunner::line(bool is_trouble, const char* text) noexcept {
  listener_.on_line(is_trouble, text);
  copy_text(waiting_text_, text);
  has_waiting_text_ = true;
  tell_what_waited();
}

void MissionRunner::tell_what_waited() noexcept {
  const bool is_answer_read = answered_ns_ < 0 || robot_.situation.now_ns - answered_ns_ >= kAnswerStays_ns;
  if (is_answer_read && std::exchange(has_waiting_text_, false)) text_ = waiting_text_;
}

// A tree that tries again and again says the same in each tick.
void MissionRunner::pass_sayings() noexcept {
  const auto sayings = robot_.orders.sayings();
  for (; told_sayings_ < sayings.size(); ++told_sayings_) {
    const Orders::Saying& saying = sayings[told_sayings_];
    if (!is_repeated(saying)) line(saying.is_trouble, saying.text.data());
  }
}

bool MissionRunner::is_repeated(const Orders::Saying& saying) noexcept {
  const std::int64_t now_ns = robot_.situation.now_ns;
  const auto last = std::ranges::find_if(last_said_, [&](const Said& said) {
    return said.saying.text == saying.text && said.saying.is_trouble == saying.is_trouble;
  });
  if (last == last_said_.end()) {
    last_said_[said_++ % last_said_.size()] = {saying, now_ns};
    return false;
  }
  if (now_ns - last->at_ns < kSaysTheSameAgain_ns) return true;
  last->at_ns = now_ns;
  return false;
}

void MissionRunner::tell(BehaviourState& state) const noexcept {
  const behaviour::Tree* const tree = shown();
  state.stamp_ns = robot_.situation.now_ns;
  state.answered = answered_;
  state.refused = refused_ ? 1 : 0;
  state.state = state_;
  state.revision = revision_;
  state.ticks = ticks_;
  state.transitions = transitions_;
  std::ranges::copy(transition_ns_, state.transition_ns);
  std::ranges::copy(transition_node_, state.transition_node);
  std::ranges::copy(transition_to_, state.transition_to);
  copy_text(state.text, text_.data());
  std::ranges::fill(state.status, std::uint8_t{0});
  state.node_count = state.endless = 0;
  copy_text(state.mission, tree != nullptr ? tree->description().main_tree : "");
  if (tree == nullptr) return;
  const auto statuses = tree->statuses();
  state.node_count = static_cast<std::uint32_t>(statuses.size());
  state.endless = tree->description().may_succeed ? 0 : 1;
  for (std::size_t i = 0; i < std::min<std::size_t>(statuses.size(), kMaxTreeNodes); ++i) {
    state.status[i] = told(statuses[i]);
  }
}

void MissionRunner::tell(BehaviourNodes& nodes) noexcept {
  nodes = BehaviourNodes{};
  nodes.stamp_ns = robot_.situation.now_ns;
  nodes.revision = revision_;
  const behaviour::Tree* const tree = shown();
  if (tree == nullptr) return;
  const auto& described = tree->description().nodes;
  nodes.node_count = static_cast<std::uint32_t>(described.size());
  if (told_node_ >= described.size()) told_node_ = 0;
  nodes.first = told_node_;
  for (; nodes.count < kToldNodes && told_node_ < described.size(); ++nodes.count, ++told_node_) {
    const behaviour::DescribedNode& node = described[told_node_];
    nodes.parent[nodes.count] = static_cast<std::uint32_t>(std::max(node.parent, 0));
    copy_text(nodes.type[nodes.count], node.id);
    copy_text(nodes.name[nodes.count], name_of(node));
  }
}

}  // namespace gaitway::behaviour_leaves
