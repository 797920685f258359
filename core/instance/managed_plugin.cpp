// Topics, the check of outputs, and publication.
#include "gaitway/instance/managed_plugin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gaitway/msgclient/memory_block.hpp"

namespace gaitway::core {

ManagedPlugin::ManagedPlugin(const PluginEntry& entry, const std::filesystem::path& configuration_file,
                             EventLog& events, const std::filesystem::path& robot_directory)
    : name_(entry.name),
      place_(entry.line > 0
                 ? fmt::format("plug-in '{}' ({}:{})", entry.name, configuration_file.string(), entry.line)
                 : fmt::format("plug-in '{}' (added to {})", entry.name, configuration_file.string())),
      parameters_(configuration_file, entry.name, entry.parameters, robot_directory),
      events_(events),
      schedule_(entry.schedule) {}

void ManagedPlugin::check_schedule() const {
  if (period_ == Period::batch && schedule_.every_ticks != 1) {
    throw PluginError(fmt::format(
        "{}: is stepped once a batch, which no period can change. Leave period and phase out", place_));
  }
}

gaitway_text ManagedPlugin::error_text() noexcept {
  error_text_[0] = '\0';
  return {error_text_.data(), static_cast<std::uint32_t>(error_text_.size()), 0};
}

void ManagedPlugin::set_fault(std::string_view text) noexcept {
  copy_text(text, error_text_);
}

void ManagedPlugin::fail(std::string_view what) {
  throw PluginError(
      fmt::format("{}: {}: {}", place_, what, fault().empty() ? "it did not say why" : fault()));
}

void ManagedPlugin::fail_construction(std::string_view text) const {
  if (parameter_error_ && text == parameter_error_->what()) {
    throw ConfigurationError(*parameter_error_);
  }
  throw PluginError(fmt::format("its constructor failed: {}", text.empty() ? "it did not say why" : text));
}

gaitway_value ManagedPlugin::declare_parameter(const gaitway_parameter& parameter) {
  try {
    return parameters_.declare(parameter);
  } catch (const ConfigurationError& error) {
    parameter_error_ = std::make_unique<ConfigurationError>(error);
    throw;
  }
}

void ManagedPlugin::report(gaitway_severity severity, std::string_view text) noexcept {
  const EventKind kind = severity == GAITWAY_INFO      ? EventKind::info
                         : severity == GAITWAY_WARNING ? EventKind::warning
                                                       : EventKind::error;
  events_.post(kind, name_, text);
}

gaitway_port* ManagedPlugin::open_topic(const gaitway_topic& topic, gaitway_access access) {
  const auto kind = static_cast<Access>(access);
  if (kind == Access::write && uses(topic.name, kind)) {
    throw PluginError(fmt::format("opens topic '{}' twice for writing. Keep the one Output", topic.name));
  }
  const std::size_t bytes =
      std::accumulate(ports_.begin(), ports_.end(), std::size_t{topic.size},
                      [](std::size_t sum, const TopicPort& port) { return sum + port.use().size; });
  if (bytes > msgclient::kMaxBlockBytes) {
    throw PluginError(
        fmt::format("opens topic '{}', and its values have {} bytes together; those of a plug-in have at "
                    "most {}. Open fewer, or correct their types",
                    topic.name, bytes, msgclient::kMaxBlockBytes));
  }
  return reinterpret_cast<gaitway_port*>(&ports_.emplace_back(topic, kind));
}

template <class Wanted>
void ManagedPlugin::bind_ports(msgclient::Client& client, const Wanted& wanted) {
  try {
    for (TopicPort& port : ports_) {
      if (wanted(port.use())) {
        port.bind(client);
      }
    }
  } catch (const msgclient::TopicError& error) {
    throw PluginError(fmt::format("{}: {}", place_, error.what()));
  }
}

void ManagedPlugin::bind(msgclient::Client& client, const ManagedPlugin* predecessor) {
  bind_ports(client, [predecessor](const TopicUse& use) {
    return predecessor == nullptr || use.access != Access::write || !predecessor->uses(use.topic, use.access);
  });
}

void ManagedPlugin::bind_inputs(msgclient::Client& client) {
  bind_ports(client, [](const TopicUse& use) { return use.access != Access::write; });
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

bool ManagedPlugin::prepare(const Tick& tick, double offset) noexcept {
  tick_ = tick;
  const bool ran = run(tick);
  for (TopicPort& port : ports_) {
    if (ran && offset != 0.0) {
      port.spoil_staged(offset);
    }
  }
  return ran && check_outputs();
}

void ManagedPlugin::commit() noexcept {
  for (TopicPort& port : ports_) {
    port.commit(tick_.now_ns);
  }
}

void ManagedPlugin::discard() noexcept {
  for (TopicPort& port : ports_) {
    port.discard();
  }
}

bool ManagedPlugin::hand_in(const Tick& tick) noexcept {
  tick_ = tick;
  const bool fine = take_settled() && check_outputs();
  fine ? commit() : discard();
  return fine;
}

bool ManagedPlugin::publish_in_place(std::string_view topic, std::uint64_t type_hash, const void* value,
                                     std::int64_t stamp_ns) noexcept {
  const auto port = std::ranges::find_if(ports_, [&](const TopicPort& candidate) {
    const TopicUse& use = candidate.use();
    return use.access == Access::write && use.type_hash == type_hash && use.topic == topic;
  });
  return port != ports_.end() && port->publish_now(value, stamp_ns);
}

std::int64_t ManagedPlugin::take_input_age_ns() noexcept {
  std::int64_t oldest_ns = 0;
  for (TopicPort& port : ports_) {
    oldest_ns = std::max(oldest_ns, port.take_read_age_ns(tick_.now_ns));
  }
  return oldest_ns;
}

bool ManagedPlugin::check_outputs() noexcept {
  for (const TopicPort& port : ports_) {
    const auto problem = port.find_bad_number();
    if (!problem) {
      continue;
    }
    const FloatField& field = *problem->field;
    const std::uint32_t columns = field.count / field.rows;
    const std::uint32_t row = problem->element / columns, column = problem->element % columns;
    const std::string_view topic = port.use().topic;
    if (std::isfinite(problem->value)) {
      format_into(error_text_, "topic '{}': field '{}'[{}][{}] is {:g}; it must lie between {:g} and {:g}",
                  topic, field.name, row, column, problem->value, field.lowest, field.highest);
    } else {
      format_into(error_text_,
                  "topic '{}': field '{}'[{}][{}] is not finite; all numbers of an output must be", topic,
                  field.name, row, column);
    }
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
  return std::ranges::any_of(ports_, [&](const TopicPort& port) {
    return port.use().access == access && port.use().topic == topic;
  });
}

}  // namespace gaitway::core
