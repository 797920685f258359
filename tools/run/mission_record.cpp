// From the newest transitions of a tree to spans of its leaves.
#include "tools/run/mission_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "tools/run/svg_plot.hpp"

namespace gaitway::tools {
namespace {

namespace results = behaviour_state::status;

struct Look {
  const char* colour;
  const char* word;
};
std::string text_of(std::span<const std::uint8_t> bytes) {
  return {bytes.begin(), std::ranges::find(bytes, std::uint8_t{0})};
}

Look look_of(std::uint8_t result, bool runs) {
  if (runs) return {"#2563eb", "runs"};
  if (result == results::success) return {"#15803d", "success"};
  if (result == results::failure) return {"#b91c1c", "failure"};
  return {"#6b7280", "halted"};
}

// "mission 'm' has failed: CAUSE"
std::string cause_of(const std::string& line) {
  constexpr std::string_view kBefore = "has failed: ";
  const std::size_t at = line.find(kBefore);
  return at == std::string::npos ? line : line.substr(at + kBefore.size());
}

}  // namespace

void MissionRecord::look(std::int64_t now_ns, bool has_fallen) {
  now_ns_ = now_ns;
  falls_ += has_fallen && !has_fallen_ ? 1 : 0;
  has_fallen_ = has_fallen;
  const bool was_ended = ended();
  if (states_.newest_sequence() != state_sequence_) {
    if (const auto read = states_.read(state_)) {
      state_sequence_ = read.sequence;
      take_transitions();
      if (ended() && !was_ended) ended_s_ = static_cast<double>(now_ns) * 1e-9;
    }
  }
  if (nodes_.newest_sequence() != nodes_sequence_) take_nodes();
}

void MissionRecord::take_transitions() {
  const std::uint64_t oldest =
      state_.transitions - std::min<std::uint64_t>(state_.transitions, kTreeTransitions);
  for (std::uint64_t n = std::max(taken_, oldest); n < state_.transitions; ++n) {
    const std::size_t at = n % kTreeTransitions;
    if (state_.transition_node[at] >= state_.node_count) continue;  // of the tree before
    const Node node{state_.revision, state_.transition_node[at]};
    const double time_s = static_cast<double>(state_.transition_ns[at]) * 1e-9;
    const std::uint8_t to = state_.transition_to[at];
    const auto running = running_.find(node);
    if (running != running_.end()) {
      if (to == results::running) continue;
      spans_[running->second].to_s = time_s;
      spans_[running->second].result = to;
      running_.erase(running);
    } else if (to == results::running) {
      running_[node] = spans_.size();
      spans_.push_back({node, time_s});
    } else if (to == results::success || to == results::failure) {
      spans_.push_back({node, time_s, time_s, to});  // it answered at once
    }
  }
  taken_ = state_.transitions;
}

void MissionRecord::take_nodes() {
  BehaviourNodes part{};
  const auto read = nodes_.read(part);
  if (!read) return;
  nodes_sequence_ = read.sequence;
  for (std::uint32_t i = 0; i < std::min<std::uint32_t>(part.count, kToldNodes); ++i) {
    const std::string type = text_of(part.type[i]), name = text_of(part.name[i]);
    Described& described = described_[{part.revision, part.first + i}];
    described.name = name.empty() ? type : fmt::format("{}: {}", type, name);
    if (part.first + i != 0) described_[{part.revision, part.parent[i]}].has_children = true;
  }
}

bool MissionRecord::ended() const noexcept {
  return state_.state == behaviour_state::state::succeeded || state_.state == behaviour_state::state::failed;
}

std::optional<MissionEnd> MissionRecord::end() const {
  namespace states = behaviour_state::state;
  if (state_.state == states::none) return std::nullopt;
  return MissionEnd{.name = text_of(state_.mission),
                    .state = state_.state == states::succeeded ? MissionEnd::State::succeeded
                             : state_.state == states::failed  ? MissionEnd::State::failed
                                                               : MissionEnd::State::runs,
                    .at_s = ended_s_,
                    .endless = state_.endless != 0,
                    .is_of_people = is_of_people_,
                    .falls = falls_,
                    .waits = state_.state == states::waits,
                    .on_feet = !has_fallen_,
                    .silent_since_s = silent_since_s(),
                    .reason = cause_of(text_of(state_.text))};
}

std::optional<double> MissionRecord::silent_since_s() const {
  constexpr std::int64_t kSilent_ns = 1'000'000'000;
  if (ended() || now_ns_ - state_.stamp_ns <= kSilent_ns) return std::nullopt;
  return static_cast<double>(state_.stamp_ns) * 1e-9;
}

nlohmann::ordered_json MissionRecord::json() const {
  const std::optional<MissionEnd> mission = end();
  if (!mission) return nullptr;
  using State = MissionEnd::State;
  return {{"name", mission->name},
          {"result", mission->state == State::succeeded ? "succeeded"
                     : mission->state == State::failed  ? "failed"
                     : mission->waits                   ? "waits"
                                                        : "runs"},
          {"ended_s", ended() ? nlohmann::ordered_json(mission->at_s) : nlohmann::ordered_json(nullptr)},
          {"endless", mission->endless},
          {"falls", mission->falls},
          {"on_feet", mission->on_feet}};
}

const MissionRecord::Described* MissionRecord::leaf(const Node& node) const {
  const auto found = described_.find(node);
  return found == described_.end() || found->second.has_children ? nullptr : &found->second;
}

std::string MissionRecord::timeline(double end_s) const {
  std::vector<Node> rows;
  for (const Span& span : spans_) {
    const bool is_condition = span.from_s == span.to_s;
    if (leaf(span.node) != nullptr && !is_condition && std::ranges::find(rows, span.node) == rows.end()) {
      rows.push_back(span.node);
    }
  }
  if (rows.empty()) return {};
  const auto count = static_cast<double>(rows.size());
  SvgPlot plot({.title = "Leaves of the behaviour tree",
                .x_label = "time [s]",
                .y_label = "",
                .x_min = 0.0,
                .x_max = end_s,
                .y_min = 0.0,
                .y_max = count,
                .height_px = 70.0 + 26.0 * count,
                .left_px = 200.0});
  for (std::size_t row = 0; row < rows.size(); ++row) {
    plot.y_tick(count - 0.5 - static_cast<double>(row), leaf(rows[row])->name);
  }
  for (const Span& span : spans_) {
    const auto found = std::ranges::find(rows, span.node);
    if (found == rows.end()) continue;
    const double top = count - static_cast<double>(found - rows.begin());
    const bool runs = span.to_s < 0.0;
    const double to_s = runs ? end_s : span.to_s;
    const Look look = look_of(span.result, runs);
    plot.box(
        span.from_s, std::max(to_s, span.from_s + 0.002 * end_s), top - 0.85, top - 0.15, look.colour,
        fmt::format("{}: {:.2f} s to {:.2f} s, {}", leaf(span.node)->name, span.from_s, to_s, look.word));
  }
  return plot.svg();
}

}  // namespace gaitway::tools
