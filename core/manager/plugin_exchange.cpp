// A library that comes takes the place of the plug-ins that write one of its topics.
#include "gaitway/manager/plugin_exchange.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace gaitway::core {
namespace {

struct Member {  // of the configuration
  PluginEntry entry;
  std::optional<PluginDescription> description;
};

bool shares_an_output(const PluginDescription& one, const PluginDescription& other) {
  return std::ranges::any_of(one.topics, [&other](const TopicUse& topic) {
    return topic.access == Access::write && other.writes(topic.topic);
  });
}

// The plug-ins of the configuration, each asked what it writes.
std::vector<Member> members_of(const Configuration& configuration, const ProbeOptions& options) {
  std::vector<Member> members;
  for (const PluginEntry& entry : configuration.plugins) {
    Member member{entry, std::nullopt};
    try {
      member.description = probe_plugin(entry, configuration.file, options);
    } catch (const PluginError&) {
      // Loading the configuration says it again, with its place.
    }
    members.push_back(std::move(member));
  }
  return members;
}

AddedPlugin put_in(std::vector<Member>& members, const PluginDescription& newcomer) {
  AddedPlugin added{newcomer.name, newcomer.file, {}, {}};
  const auto leaves = [&newcomer](const Member& member) {
    return member.description && shares_an_output(*member.description, newcomer);
  };
  for (const Member& member : members) {
    if (!leaves(member)) {
      continue;
    }
    added.replaced.push_back(member.entry.name);
    for (const TopicUse& topic : member.description->topics) {
      if (topic.access == Access::write && !newcomer.writes(topic.topic)) {
        added.lost_outputs.push_back(topic.topic);
      }
    }
  }
  const auto place = std::ranges::find_if(members, leaves) - members.begin();
  members.erase(std::remove_if(members.begin(), members.end(), leaves), members.end());
  members.insert(members.begin() + place,
                 {{.name = newcomer.name, .library = newcomer.file.string()}, newcomer});
  return added;
}

}  // namespace

PluginExchange put_in(const Configuration& configuration, std::span<const std::filesystem::path> libraries,
                      const ProbeOptions& options) {
  std::vector<Member> members = members_of(configuration, options);
  PluginExchange result;
  for (const std::filesystem::path& library : libraries) {
    result.added.push_back(put_in(members, probe_plugin(library, options)));
  }
  result.configuration.file = configuration.file;
  for (Member& member : members) {
    result.configuration.plugins.push_back(std::move(member.entry));
    if (member.description) {
      result.descriptions.push_back(std::move(*member.description));
    }
  }
  return result;
}

std::string PluginExchange::writer_of(std::string_view topic) const {
  const auto writer = std::ranges::find_if(
      descriptions, [topic](const PluginDescription& description) { return description.writes(topic); });
  return writer == descriptions.end() ? std::string() : writer->name;
}

std::string PluginExchange::behaviour() const {
  for (const std::string_view topic :
       {"behaviour_walk", "behaviour_walk_to", "behaviour_motion", "behaviour_head"}) {
    if (std::string writer = writer_of(topic); !writer.empty()) return writer;
  }
  return {};
}

std::string describe(const AddedPlugin& added) {
  std::string line = fmt::format("{} ({})", added.name, added.library.string());
  line += added.replaced.empty() ? " is added" : fmt::format(" replaces {}", fmt::join(added.replaced, ", "));
  if (!added.lost_outputs.empty()) {
    line += fmt::format("; nobody writes {} any more", fmt::join(added.lost_outputs, ", "));
  }
  return line;
}

}  // namespace gaitway::core
