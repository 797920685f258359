// What the behaviour tree did in a run: which leaf ran when, and what came of it.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "tools/run/run_metrics.hpp"

namespace gaitway::tools {

class MissionRecord {
 public:
  explicit MissionRecord(msgclient::Client& client)
      : states_(client.read<BehaviourState>("behaviour_state")),
        nodes_(client.read<BehaviourNodes>("behaviour_nodes")) {}

  // Missions begin, wait and end as people ask, so that none tells whether the run has done what it was to.
  void belongs_to_people() noexcept { is_of_people_ = true; }
  // Every 10 ms. has_fallen: now, in truth.
  void look(std::int64_t now_ns, bool has_fallen);

  // The mission has come to its own end.
  [[nodiscard]] bool ended() const noexcept;
  // Nothing has been heard of a mission that runs for a second.
  [[nodiscard]] std::optional<double> silent_since_s() const;
  // None: no mission has begun.
  [[nodiscard]] std::optional<MissionEnd> end() const;
  // For summary.json; null: no mission has begun.
  [[nodiscard]] nlohmann::ordered_json json() const;
  // A chart with a row for each leaf that ran, as inline SVG; empty: there was no behaviour.
  [[nodiscard]] std::string timeline(double end_s) const;

 private:
  using Node = std::pair<std::uint32_t, std::uint32_t>;  // revision of the tree, number in it
  struct Span {
    Node node;
    double from_s = 0.0, to_s = -1.0;  // -1: it still runs
    std::uint8_t result = 0;           // as in BehaviourState::status
  };
  struct Described {
    std::string name;
    bool has_children = false;
  };
  void take_transitions();
  void take_nodes();
  [[nodiscard]] const Described* leaf(const Node& node) const;

  msgclient::Reader<BehaviourState> states_;
  msgclient::Reader<BehaviourNodes> nodes_;
  std::uint64_t state_sequence_ = 0, nodes_sequence_ = 0;
  BehaviourState state_{};
  double ended_s_ = 0.0;
  bool is_of_people_ = false;
  int falls_ = 0;
  std::int64_t now_ns_ = 0;
  bool has_fallen_ = false;  // and lies
  std::uint64_t taken_ = 0;  // transitions
  std::vector<Span> spans_;
  std::map<Node, std::size_t> running_;  // their spans
  std::map<Node, Described> described_;
};

}  // namespace gaitway::tools
