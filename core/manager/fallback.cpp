// Which fallback for which topics.
#include "gaitway/manager/fallback.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "gaitway/manager/plugin_error.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::core {
namespace {

using Names = std::span<const std::string_view>;

constexpr std::array<std::string_view, 1> kEstimateWrites{"estimate"};
constexpr std::array<std::string_view, 4> kEstimateReads{"joint_states", "imu", "foot_forces", "motion_plan"};
constexpr std::array<std::string_view, 2> kTrimWrites{"trim", "correction"};
constexpr std::array<std::string_view, 1> kTrimReads{"estimate"};
constexpr std::array<std::string_view, 1> kStopWrites{"walk_command"};
constexpr std::array<std::string_view, 2> kTailWrites{"motion_plan", "joint_plan"};

constexpr std::array kKinds{FallbackKind::estimate, FallbackKind::trims_from_gains, FallbackKind::stop,
                            FallbackKind::safe_tail};

bool contains(Names names, std::string_view name) noexcept {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

Names topics_written_by(FallbackKind kind) noexcept {
  switch (kind) {
    case FallbackKind::estimate:
      return kEstimateWrites;
    case FallbackKind::trims_from_gains:
    case FallbackKind::trims_to_zero:
      return kTrimWrites;
    case FallbackKind::stop:
      return kStopWrites;
    case FallbackKind::safe_tail:
      return kTailWrites;
    default:
      return {};
  }
}

Names topics_read_by(FallbackKind kind) noexcept {
  return kind == FallbackKind::estimate           ? Names(kEstimateReads)
         : kind == FallbackKind::trims_from_gains ? Names(kTrimReads)
                                                  : Names();
}

FallbackKind fallback_of_topic(std::string_view topic, std::uint64_t type_hash) noexcept {
  const auto standard = std::find_if(kStandardTopics.begin(), kStandardTopics.end(),
                                     [topic](const StandardTopic& other) { return other.name == topic; });
  if (standard == kStandardTopics.end() || standard->type->hash != type_hash) {
    return FallbackKind::none;
  }
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(), [topic](FallbackKind candidate) {
    return contains(topics_written_by(candidate), topic);
  });
  return kind == kKinds.end() ? FallbackKind::none : *kind;
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
    if (used && std::find(kinds_.begin(), kinds_.end(), kind) == kinds_.end()) {
      kinds_.push_back(kind);
    }
  }
  if (wanted == FallbackKind::safe_tail) {
    kinds_ = {wanted};  // fits every plug-in: it only holds batches back
  } else if (wanted != FallbackKind::by_topics && wanted != FallbackKind::none && kinds_.empty()) {
    throw PluginError(fmt::format(
        "{}: fallback '{}' writes the topic '{}', which this plug-in does not. Choose another fallback, or "
        "leave it out",
        plugin.place(), fallback_kind_name(wanted), fmt::join(topics_written_by(wanted), "' and '")));
  }
  for (const FallbackKind kind : kinds_) {
    if (std::unique_ptr<Fallback> fallback = make_fallback(kind, source)) {
      fallbacks_.push_back(std::move(fallback));
    }
  }
  if (!kinds_.empty()) {
    std::vector<std::string_view> names;
    std::transform(kinds_.begin(), kinds_.end(), std::back_inserter(names), &fallback_kind_name);
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

}  // namespace gaitway::core
