// Slots, their order, and questions to the data flow.
#include "gaitway/manager/plugin_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gaitway/input/complaint.hpp"

namespace gaitway::core {

PluginSet::~PluginSet() {
  for (auto slot = slots_.rbegin(); slot != slots_.rend(); ++slot) {
    if ((*slot)->plugin != nullptr) {
      (*slot)->plugin->deactivate();
    }
  }
  while (!slots_.empty()) {
    slots_.pop_back();
  }
}

PluginSlot& PluginSet::add(const PluginEntry& entry) {
  auto slot = std::make_unique<PluginSlot>();
  slot->entry = entry;
  slot->configured = slots_.size();
  return *slots_.emplace_back(std::move(slot));
}

std::vector<ExternalTopic> external_topics(const msgclient::Client& client) {
  std::vector<ExternalTopic> external;
  for (const msgclient::TopicInfo& topic : client.directory()) {
    external.push_back({topic.descriptor.name, topic.writer});
  }
  return external;
}

void PluginSet::put_in_order(const std::filesystem::path& configuration_file,
                             const msgclient::Client& client) {
  const DataFlow flow = [&] {
    try {
      return order_by_data_flow(nodes(), external_topics(client));
    } catch (const PluginError& error) {
      throw PluginError(fmt::format("{}: {}", configuration_file.string(), error.what()));
    }
  }();
  Slots ordered;
  for (std::size_t i = 0; i < flow.order.size(); ++i) {
    ordered.push_back(std::move(slots_[flow.order[i]]));
    ordered.back()->depends_on = flow.depends_on[i];
  }
  slots_ = std::move(ordered);
}

std::size_t PluginSet::index_of(std::string_view name) const noexcept {
  const auto same = [name](const auto& slot) { return slot->entry.name == name; };
  return static_cast<std::size_t>(std::ranges::find_if(slots_, same) - slots_.begin());
}

std::size_t PluginSet::require(std::string_view name) const {
  const std::size_t index = index_of(name);
  if (index == slots_.size()) {
    std::vector<std::string> names;
    for (const auto& slot : slots_) {
      names.push_back(slot->entry.name);
    }
    throw PluginError(
        fmt::format("there is no plug-in '{}'. {}", name, input::suggest(std::string(name), names)));
  }
  return index;
}

std::vector<DataFlowNode> PluginSet::nodes() const {
  std::vector<DataFlowNode> result;
  for (const auto& slot : slots_) {
    result.push_back(slot->plugin->node());
  }
  return result;
}

bool PluginSet::uses(std::string_view topic) const noexcept {
  const auto reads = [topic](FallbackKind kind) {
    const auto topics = topics_read_by(kind);
    return std::ranges::find(topics, topic) != topics.end();
  };
  return std::ranges::any_of(slots_, [&](const auto& slot) {
    const auto& fallbacks = slot->containment.fallbacks().kinds();
    return std::ranges::any_of(kAccesses, [&](Access access) { return slot->plugin->uses(topic, access); }) ||
           std::ranges::any_of(fallbacks, reads);
  });
}

namespace {

const PluginSlot* writer_of(const PluginSet& plugins, std::string_view topic) noexcept {
  const auto writes = [topic](const auto& slot) { return slot->plugin->uses(topic, Access::write); };
  const auto writer = std::ranges::find_if(plugins.slots(), writes);
  return writer == plugins.slots().end() ? nullptr : writer->get();
}

}  // namespace

const PluginSlot* PluginSet::fault_behind(std::string_view topic) const noexcept {
  const PluginSlot* const writer = writer_of(*this, topic);
  for (std::size_t i = 0; writer != nullptr && i < slots_.size(); ++i) {
    if (slots_[i]->failed && !slots_[i]->covered && writer->depends_on[i]) {
      return slots_[i].get();
    }
  }
  return nullptr;
}

bool PluginSet::is_behind(const PluginSlot& slot, std::string_view topic) const noexcept {
  const PluginSlot* const writer = writer_of(*this, topic);
  for (std::size_t i = 0; writer != nullptr && i < slots_.size(); ++i) {
    if (slots_[i].get() == &slot) {
      return writer->depends_on[i];
    }
  }
  return true;
}

void PluginSet::copy_value(std::string_view plugin, std::size_t parameter,
                           std::span<char> to) const noexcept {
  to[0] = '\0';
  const std::size_t index = index_of(plugin);
  if (index == slots_.size() || parameter >= slots_[index]->plugin->parameters().declared().size()) {
    return;
  }
  copy_text(slots_[index]->plugin->parameters().declared()[parameter].value, to);
}

bool PluginSet::local_sockets(std::string_view plugin) const noexcept {
  const std::size_t index = index_of(plugin);
  return index < slots_.size() && slots_[index]->entry.child.local_sockets;
}

std::vector<PluginTiming> PluginSet::timings() const {
  std::vector<PluginTiming> result;
  for (const auto& slot : slots_) {
    result.push_back({slot->entry.name, slot->steps, slot->faults, slot->step_wall.summary(),
                      slot->containment.overruns(), slot->containment.state()});
  }
  return result;
}

}  // namespace gaitway::core
