// Checks the graph of plug-ins and topics and sorts it.
#include "gaitway/manager/data_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

#include "gaitway/input/complaint.hpp"

namespace gaitway::core {
namespace {

struct Edge {
  std::size_t reader;
  std::string_view topic;
};

class Sorter {
 public:
  Sorter(std::span<const DataFlowNode> nodes, std::span<const ExternalTopic> external)
      : nodes_(nodes), external_(external), readers_(nodes.size()) {}

  DataFlow sort() {
    find_writers();
    check_types();
    check_inputs();
    connect();
    DataFlow flow;
    flow.order = order();
    flow.depends_on = dependencies(flow.order);
    return flow;
  }

 private:
  void find_writers() {
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      for (const TopicUse& use : nodes_[node].uses) {
        if (use.access != Access::write) {
          continue;
        }
        if (const ExternalTopic* const elsewhere = written_elsewhere(use.topic)) {
          throw PluginError(fmt::format(
              "topic '{}' has two writers: plug-in '{}', and '{}' in the memory block. A topic has "
              "one: remove the plug-in, or end '{}'",
              use.topic, nodes_[node].name, elsewhere->writer, elsewhere->writer));
        }
        const auto [other, is_first] = writer_.emplace(use.topic, node);
        if (!is_first) {
          throw PluginError(fmt::format(
              "topic '{}' has two writers: plug-ins '{}' and '{}'. A topic has one: remove one of "
              "them, or let one write another topic",
              use.topic, nodes_[other->second].name, nodes_[node].name));
        }
      }
    }
  }

  // Everybody who uses a topic means the same type.
  void check_types() const {
    std::map<std::string_view, std::pair<std::size_t, const TopicUse*>> first;
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      for (const TopicUse& use : nodes_[node].uses) {
        const auto [found, is_first] = first.try_emplace(use.topic, node, &use);
        const TopicUse& other = *found->second.second;
        if (use.type_name != other.type_name || use.type_hash != other.type_hash || use.size != other.size) {
          throw PluginError(fmt::format(
              "topic '{}': plug-in '{}' means a {} (type hash {:016x}, {} bytes), but '{}' a {} "
              "(type hash {:016x}, {} bytes). Build both from the same schema\n  '{}': {}\n  '{}': {}",
              use.topic, nodes_[found->second.first].name, other.type_name, other.type_hash, other.size,
              nodes_[node].name, use.type_name, use.type_hash, use.size, nodes_[found->second.first].name,
              other.number_fields, nodes_[node].name, use.number_fields));
        }
      }
    }
  }

  [[nodiscard]] const ExternalTopic* written_elsewhere(std::string_view topic) const {
    const auto found = std::ranges::find_if(external_, [topic](const ExternalTopic& other) {
      return other.topic == topic && !other.writer.empty();
    });
    return found == external_.end() ? nullptr : &*found;
  }

  void check_inputs() const {
    for (const DataFlowNode& node : nodes_) {
      for (const TopicUse& use : node.uses) {
        if (needs_writer(use.access) && !writer_.contains(use.topic) &&
            written_elsewhere(use.topic) == nullptr) {
          throw PluginError(
              fmt::format("plug-in '{}' reads topic '{}', but nobody writes it: no plug-in of this "
                          "configuration, and nobody in the memory block. {}",
                          node.name, use.topic, input::suggest(use.topic, written_topics())));
        }
      }
    }
  }

  [[nodiscard]] std::vector<std::string> written_topics() const {
    std::vector<std::string> topics;
    for (const auto& [topic, node] : writer_) {
      topics.emplace_back(topic);
    }
    for (const ExternalTopic& other : external_) {
      if (!other.writer.empty() && !writer_.contains(other.topic)) {
        topics.push_back(other.topic);
      }
    }
    return topics;
  }

  void connect() {
    for (std::size_t node = 0; node < nodes_.size(); ++node) {
      for (const TopicUse& use : nodes_[node].uses) {
        const auto writer = writer_.find(use.topic);
        const bool same_tick = use.access != Access::write && !is_of_tick_before(use.access);
        if (same_tick && writer != writer_.end()) {
          readers_[writer->second].push_back({node, use.topic});
        }
      }
    }
  }

  // Kahn's algorithm; of the plug-ins that are ready, the one that comes first in the configuration.
  [[nodiscard]] std::vector<std::size_t> order() const {
    std::vector<std::size_t> waits_for(nodes_.size(), 0);
    for (const auto& edges : readers_) {
      for (const Edge& edge : edges) {
        ++waits_for[edge.reader];
      }
    }
    std::vector<bool> placed(nodes_.size(), false);
    std::vector<std::size_t> result;
    while (result.size() < nodes_.size()) {
      std::size_t next = 0;
      while (next < nodes_.size() && (placed[next] || waits_for[next] > 0)) {
        ++next;
      }
      if (next == nodes_.size()) {
        refuse_cycle(placed);
      }
      placed[next] = true;
      result.push_back(next);
      for (const Edge& edge : readers_[next]) {
        --waits_for[edge.reader];
      }
    }
    return result;
  }

  // Every plug-in that could not be placed waits for another such one: going back from any of them runs into
  // a cycle.
  [[noreturn]] void refuse_cycle(const std::vector<bool>& placed) const {
    std::vector<std::size_t> back;
    std::size_t node = static_cast<std::size_t>(std::ranges::find(placed, false) - placed.begin());
    while (std::ranges::find(back, node) == back.end()) {
      back.push_back(node);
      node = waited_for(node, placed);
    }
    back.erase(back.begin(), std::ranges::find(back, node));
    std::ranges::reverse(back);
    std::rotate(back.begin(), std::ranges::min_element(back), back.end());
    std::string path = fmt::format("'{}'", nodes_[back.front()].name);
    for (std::size_t i = 0; i < back.size(); ++i) {
      const std::size_t reader = back[(i + 1) % back.size()];
      const auto edge = std::find_if(readers_[back[i]].begin(), readers_[back[i]].end(),
                                     [reader](const Edge& candidate) { return candidate.reader == reader; });
      path += fmt::format(" -> {} -> '{}'", edge->topic, nodes_[reader].name);
    }
    throw PluginError(
        fmt::format("plug-ins wait for each other: {}. Let one of them use reads_previous", path));
  }

  [[nodiscard]] std::size_t waited_for(std::size_t reader, const std::vector<bool>& placed) const {
    for (std::size_t writer = 0; writer < nodes_.size(); ++writer) {
      for (const Edge& edge : readers_[writer]) {
        if (!placed[writer] && edge.reader == reader) {
          return writer;
        }
      }
    }
    throw std::logic_error("a plug-in that waits for nobody was not placed");
  }

  [[nodiscard]] std::vector<std::vector<bool>> dependencies(const std::vector<std::size_t>& order) const {
    std::vector<std::vector<bool>> depends_on(nodes_.size(), std::vector<bool>(nodes_.size(), false));
    for (const std::size_t writer : order) {
      depends_on[writer][writer] = true;
      for (const Edge& edge : readers_[writer]) {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
          depends_on[edge.reader][i] = depends_on[edge.reader][i] || depends_on[writer][i];
        }
      }
    }
    std::vector<std::vector<bool>> ordered;
    for (const std::size_t node : order) {
      ordered.emplace_back();
      for (const std::size_t other : order) {
        ordered.back().push_back(depends_on[node][other]);
      }
    }
    return ordered;
  }

  std::span<const DataFlowNode> nodes_;
  std::span<const ExternalTopic> external_;
  std::map<std::string_view, std::size_t> writer_;
  std::vector<std::vector<Edge>> readers_;  // [writer]
};

}  // namespace

DataFlow order_by_data_flow(std::span<const DataFlowNode> nodes, std::span<const ExternalTopic> external) {
  return Sorter(nodes, external).sort();
}

}  // namespace gaitway::core
