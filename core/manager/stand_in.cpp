// Takes the place of a plug-in that is stopped, with its topics and without its library.
#include "stand_in.hpp"

#include <algorithm>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::core {
namespace {

using Nodes = std::vector<DataFlowNode>;

bool is_written(std::string_view topic, const Nodes& loaded, const std::vector<ExternalTopic>& external) {
  const auto writes = [topic](const TopicUse& use) {
    return use.access == Access::write && use.topic == topic;
  };
  return std::any_of(loaded.begin(), loaded.end(),
                     [&](const DataFlowNode& node) {
                       return std::any_of(node.uses.begin(), node.uses.end(), writes);
                     }) ||
         std::any_of(external.begin(), external.end(), [topic](const ExternalTopic& other) {
           return other.topic == topic && !other.writer.empty();
         });
}

bool is_needed(std::string_view topic, const Nodes& loaded) {
  const auto needs = [topic](const TopicUse& use) { return use.topic == topic && needs_writer(use.access); };
  return std::any_of(loaded.begin(), loaded.end(), [&](const DataFlowNode& node) {
    return std::any_of(node.uses.begin(), node.uses.end(), needs);
  });
}

}  // namespace

StandIn::StandIn(const PluginEntry& entry, const std::vector<std::string>& topics,
                 const std::filesystem::path& configuration_file, EventLog& events)
    : ManagedPlugin(entry, configuration_file, events) {
  for (const StandardTopic& topic : kStandardTopics) {
    if (std::find(topics.begin(), topics.end(), topic.name) == topics.end()) {
      continue;
    }
    const std::string name(topic.name), type_name(topic.type->name);
    const gaitway_topic plain{name.c_str(), type_name.c_str(), topic.type->hash, topic.type->size, 0,
                              nullptr};
    ports_.emplace_back(plain, Access::write);
  }
}

bool StandIn::save_state(PluginState& state) noexcept {
  state.size = 0;
  state.version = 0;
  return true;
}

bool StandIn::set_parameter(const char*, const gaitway_value&) noexcept {
  set_fault("the plug-in is not loaded");
  return false;
}

std::vector<std::string> StandIn::topics_for(const PluginEntry& entry, const Nodes& loaded,
                                             const std::vector<ExternalTopic>& external) {
  const FallbackKind named = entry.containment.fallback;
  const FallbackKind wanted = named == FallbackKind::trims_to_zero ? FallbackKind::trims_from_gains : named;
  const bool has_standard_name =
      std::any_of(kStandardTopics.begin(), kStandardTopics.end(),
                  [&](const StandardTopic& topic) { return topic.writer == entry.name; });
  const auto is_its = [&](const StandardTopic& topic, FallbackKind kind) {
    // "none" and "safe_tail" fit every topic: nobody writes it.
    if (wanted != FallbackKind::by_topics && wanted != FallbackKind::none &&
        wanted != FallbackKind::safe_tail) {
      return kind == wanted;
    }
    if (has_standard_name) {
      return topic.writer == entry.name;
    }
    const auto written = topics_written_by(kind);
    return std::any_of(written.begin(), written.end(), [&](std::string_view other) {
      return !is_written(other, loaded, external) && is_needed(other, loaded);
    });
  };
  std::vector<std::string> topics;
  for (const StandardTopic& topic : kStandardTopics) {
    const FallbackKind kind = fallback_of_topic(topic.name, topic.type->hash);
    if (kind != FallbackKind::none && !is_written(topic.name, loaded, external) && is_its(topic, kind)) {
      topics.emplace_back(topic.name);
    }
  }
  return topics;
}

std::vector<std::string> StandIn::topics_for(const DataFlowNode& running) {
  std::vector<std::string> topics;
  for (const TopicUse& use : running.uses) {
    if (use.access == Access::write && fallback_of_topic(use.topic, use.type_hash) != FallbackKind::none) {
      topics.push_back(use.topic);
    }
  }
  return topics;
}

}  // namespace gaitway::core
