// Topics, the check of outputs, and publication.
#include "gaitway/core/managed_plugin.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plugin_declarations.hpp"

namespace gaitway::core {

ManagedPlugin::ManagedPlugin(const PluginEntry& entry, const std::filesystem::path& configuration_file,
                             EventLog& events)
    : name_(entry.name),
      place_(fmt::format("plug-in '{}' ({}:{})", entry.name, configuration_file.string(), entry.line)),
      parameters_(configuration_file, entry.name, entry.parameters),
      events_(&events) {}

gaitway_text ManagedPlugin::error_text() noexcept {
  error_text_[0] = '\0';
  return {error_text_.data(), static_cast<std::uint32_t>(error_text_.size()), 0};
}

void ManagedPlugin::set_fault(std::string_view text) noexcept {
  const std::size_t length = std::min(text.size(), error_text_.size() - 1);
  std::copy_n(text.begin(), length, error_text_.begin());
  error_text_[length] = '\0';
}

void ManagedPlugin::fail(std::string_view what) {
  throw PluginError(
      fmt::format("{}: {}: {}", place_, what, fault().empty() ? "it did not say why" : fault()));
}

void ManagedPlugin::declare_topic(const gaitway_topic* topic, gaitway_access access) {
  check_topic(topic, access);
  const auto kind = static_cast<Access>(access);
  if (kind == Access::write && uses(topic->name, kind)) {
    throw PluginError(fmt::format("opens topic '{}' twice for writing. Keep the one Output", topic->name));
  }
  ports_.emplace_back(*topic, kind);
}

void ManagedPlugin::bind(msgclient::Client& client, const ManagedPlugin* predecessor) {
  try {
    for (TopicPort& port : ports_) {
      const bool inherited = predecessor != nullptr && port.use().access == Access::write &&
                             predecessor->uses(port.use().topic, Access::write);
      if (!inherited) {
        port.bind(client);
      }
    }
  } catch (const msgclient::TopicError& error) {
    throw PluginError(fmt::format("{}: {}", place_, error.what()));
  }
}

void ManagedPlugin::take_outputs(ManagedPlugin& predecessor) noexcept {
  for (TopicPort& port : ports_) {
    for (TopicPort& other : predecessor.ports_) {
      port.take_output(other);
    }
  }
}

void ManagedPlugin::take_snapshots() noexcept {
  for (TopicPort& port : ports_) {
    port.take_snapshot();
  }
}

bool ManagedPlugin::step(const Tick& tick) noexcept {
  tick_ = tick;
  if (run(tick) && check_outputs()) {
    for (TopicPort& port : ports_) {
      port.commit(tick.now_ns);
    }
    return true;
  }
  for (TopicPort& port : ports_) {
    port.discard();
  }
  return false;
}

bool ManagedPlugin::check_outputs() noexcept {
  for (const TopicPort& port : ports_) {
    const auto problem = port.find_non_finite();
    if (!problem) {
      continue;
    }
    const FloatField& field = *problem->field;
    const std::uint32_t columns = field.count / field.rows;
    fmt::format_to_n(error_text_.data(), error_text_.size() - 1,
                     "topic '{}': field '{}'[{}][{}] is not finite; all numbers of an output must be",
                     port.use().topic, field.name, problem->element / columns, problem->element % columns)
        .out[0] = '\0';
    return false;
  }
  return true;
}

DataFlowNode ManagedPlugin::node() const {
  DataFlowNode node{name_, {}};
  for (const TopicPort& port : ports_) {
    node.uses.push_back(port.use());
  }
  return node;
}

bool ManagedPlugin::uses(std::string_view topic, Access access) const noexcept {
  return std::any_of(ports_.begin(), ports_.end(), [&](const TopicPort& port) {
    return port.use().access == access && port.use().topic == topic;
  });
}

}  // namespace gaitway::core
