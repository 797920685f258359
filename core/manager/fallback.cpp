// Which fallback for which topics, and in whose place.
#include "gaitway/manager/fallback.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::core {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 1> kEstimateWrites{"estimate"};
constexpr std::array<std::string_view, 4> kEstimateReads{"joint_states", "imu", "foot_forces", "motion_plan"};
constexpr std::array<std::string_view, 2> kTrimWrites{"trim", "correction"};
constexpr std::array<std::string_view, 1> kTrimReads{"estimate"};
constexpr std::array<std::string_view, 4> kStopWrites{"behaviour_walk", "behaviour_walk_to",
                                                      "behaviour_motion", "behaviour_head"};
constexpr std::array<std::string_view, 2> kTailWrites{"motion_plan", "joint_plan"};

struct KindTopics {
  FallbackKind kind;
  Names written, read;
};
constexpr std::array<KindTopics, 5> kKindTopics{{
    {FallbackKind::estimate, kEstimateWrites, kEstimateReads},
    {FallbackKind::trims_from_gains, kTrimWrites, kTrimReads},
    {FallbackKind::trims_to_zero, kTrimWrites, {}},
    {FallbackKind::stop, kStopWrites, {}},
    {FallbackKind::safe_tail, kTailWrites, {}},
}};

KindTopics topics_of(FallbackKind kind) noexcept {
  const auto found = std::ranges::find(kKindTopics, kind, &KindTopics::kind);
  return found == kKindTopics.end() ? KindTopics{kind, {}, {}} : *found;
}

bool contains(Names names, std::string_view name) noexcept {
  return std::ranges::find(names, name) != names.end();
}

// The kind that a standard topic asks for; none for all others.
FallbackKind fallback_of_topic(std::string_view topic, std::uint64_t type_hash) noexcept {
  const auto standard = std::ranges::find(kStandardTopics, topic, &StandardTopic::name);
  if (standard == kStandardTopics.end() || standard->type->hash != type_hash) {
    return FallbackKind::none;
  }
  const auto kind = std::ranges::find_if(
      kKindTopics, [topic](const KindTopics& topics) { return contains(topics.written, topic); });
  return kind == kKindTopics.end() ? FallbackKind::none : kind->kind;
}

using Nodes = std::vector<DataFlowNode>;

bool is_written(std::string_view topic, const Nodes& loaded, const std::vector<ExternalTopic>& external) {
  const auto writes = [topic](const TopicUse& use) {
    return use.access == Access::write && use.topic == topic;
  };
  return std::ranges::any_of(
             loaded, [&](const DataFlowNode& node) { return std::ranges::any_of(node.uses, writes); }) ||
         std::ranges::any_of(external, [topic](const ExternalTopic& other) {
           return other.topic == topic && !other.writer.empty();
         });
}

bool is_needed(std::string_view topic, const Nodes& loaded) {
  const auto needs = [topic](const TopicUse& use) { return use.topic == topic && needs_writer(use.access); };
  return std::ranges::any_of(loaded,
                             [&](const DataFlowNode& node) { return std::ranges::any_of(node.uses, needs); });
}

}  // namespace

Names topics_read_by(FallbackKind kind) noexcept {
  return topics_of(kind).read;
}

FallbackSet::FallbackSet(const ManagedPlugin& plugin, FallbackKind wanted, const FallbackSource& source) {
  complete_ = true;
  for (const TopicUse& use : plugin.node().uses) {
    if (use.access != Access::write) {
      continue;
    }
    const FallbackKind proper = fallback_of_topic(use.topic, use.type_hash);
    const bool other_trims =
        proper == FallbackKind::trims_from_gains && wanted == FallbackKind::trims_to_zero;
    const FallbackKind kind = other_trims ? wanted : proper;
    const bool used = kind != FallbackKind::none && (wanted == FallbackKind::by_topics || wanted == kind);
    complete_ = complete_ && used && kind != FallbackKind::safe_tail;
    if (used && std::ranges::find(kinds_, kind) == kinds_.end()) {
      kinds_.push_back(kind);
    }
  }
  if (wanted == FallbackKind::safe_tail) {
    kinds_ = {wanted};  // fits every plug-in: it only holds batches back
  } else if (wanted != FallbackKind::by_topics && wanted != FallbackKind::none && kinds_.empty()) {
    throw PluginError(fmt::format(
        "{}: fallback '{}' writes the topic '{}', which this plug-in does not. Choose another fallback, or "
        "leave it out",
        plugin.place(), fallback_kind_name(wanted), fmt::join(topics_of(wanted).written, "' and '")));
  }
  for (const FallbackKind kind : kinds_) {
    if (std::unique_ptr<Fallback> fallback = make_fallback(kind, source)) {
      fallbacks_.push_back(std::move(fallback));
    }
  }
  if (!kinds_.empty()) {
    std::vector<std::string_view> names;
    std::ranges::transform(kinds_, std::back_inserter(names), &fallback_kind_name);
    name_ = fmt::format("{}", fmt::join(names, ", "));
  }
}

void FallbackSet::follow(const Tick& tick) noexcept {
  for (const auto& fallback : fallbacks_) {
    fallback->follow(tick);
  }
}

bool FallbackSet::act(const Tick& tick, ManagedPlugin& through) noexcept {
  bool acted = complete_;
  for (const auto& fallback : fallbacks_) {
    acted = fallback->act(tick, through) && acted;
  }
  return acted;
}

StandIn::StandIn(const PluginEntry& entry, const std::vector<std::string>& topics,
                 const std::filesystem::path& configuration_file, EventLog& events)
    : ManagedPlugin(entry, configuration_file, events) {
  for (const StandardTopic& topic : kStandardTopics) {
    if (std::ranges::find(topics, topic.name) == topics.end()) {
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
  const bool has_standard_name = std::ranges::any_of(
      kStandardTopics, [&](const StandardTopic& topic) { return topic.writer == entry.name; });
  const auto is_its = [&](const StandardTopic& topic, FallbackKind kind) {
    // "none" and "safe_tail" fit every topic: nobody writes it.
    if (wanted != FallbackKind::by_topics && wanted != FallbackKind::none &&
        wanted != FallbackKind::safe_tail) {
      return kind == wanted;
    }
    if (has_standard_name) {
      return topic.writer == entry.name;
    }
    const Names written = topics_of(kind).written;
    return std::ranges::any_of(written, [&](std::string_view other) {
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
