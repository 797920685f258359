// Calls over the border, and what happens when they fail.
#include "gaitway/core/loaded_plugin.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host_functions.hpp"

namespace gaitway::core {
namespace {

// Errors of loading get the plug-in's name and place in front.
PluginLibrary load(const PluginEntry& entry, const PluginSource& source, const std::string& place) {
  try {
    return PluginLibrary(entry.library, source.configuration_file.parent_path(), source.search_path);
  } catch (const PluginError& error) {
    throw PluginError(fmt::format("{}: {}", place, error.what()));
  }
}

std::string place_of(const PluginEntry& entry, const std::filesystem::path& file) {
  return fmt::format("plug-in '{}' ({}:{})", entry.name, file.string(), entry.line);
}

}  // namespace

LoadedPlugin::LoadedPlugin(const PluginEntry& entry, const PluginSource& source, EventLog& events)
    : name_(entry.name),
      place_(place_of(entry, source.configuration_file)),
      robot_directory_(source.robot_directory.string()),
      library_(load(entry, source, place_)),
      parameters_(source.configuration_file, entry.name, entry.parameters),
      events_(events),
      host_(HostFunctions::table(*this)) {
  const gaitway_text text = error_text();
  const gaitway_status status = library_.entry().create(&host_, &instance_, &text);
  phase_ = Phase::idle;
  if (status != GAITWAY_OK) {
    instance_ = {};
    if (parameter_error_ && std::string_view(parameter_error_->what()) == fault()) {
      throw ConfigurationError(*parameter_error_);
    }
    fail("its constructor failed");
  }
  const bool complete = instance_.activate != nullptr && instance_.step != nullptr &&
                        instance_.deactivate != nullptr && instance_.destroy != nullptr;
  if (!complete) {
    if (instance_.destroy != nullptr) {
      instance_.destroy(instance_.context);
    }
    throw PluginError(
        fmt::format("{}: create left a function of its instance out. Fill in all four", place_));
  }
  try {
    parameters_.require_all_declared();
  } catch (...) {
    instance_.destroy(instance_.context);
    throw;
  }
}

LoadedPlugin::~LoadedPlugin() {
  deactivate();
  instance_.destroy(instance_.context);
}

gaitway_text LoadedPlugin::error_text() noexcept {
  error_text_[0] = '\0';
  return {error_text_.data(), static_cast<std::uint32_t>(error_text_.size()), 0};
}

void LoadedPlugin::fail(std::string_view what) {
  throw PluginError(
      fmt::format("{}: {}: {}", place_, what, fault().empty() ? "it did not say why" : fault()));
}

void LoadedPlugin::bind(msgclient::Client& client) {
  try {
    for (TopicPort& port : ports_) {
      port.bind(client);
    }
  } catch (const msgclient::TopicError& error) {
    throw PluginError(fmt::format("{}: {}", place_, error.what()));
  }
}

void LoadedPlugin::activate() {
  take_snapshots();
  const gaitway_text text = error_text();
  if (instance_.activate(instance_.context, &text) != GAITWAY_OK) {
    fail("activation failed");
  }
  phase_ = Phase::active;
}

void LoadedPlugin::deactivate() noexcept {
  if (phase_ != Phase::active) {
    return;
  }
  phase_ = Phase::idle;
  const gaitway_text text = error_text();
  if (instance_.deactivate(instance_.context, &text) != GAITWAY_OK) {
    events_.add(tick_.now_ns, tick_.tick, EventKind::error, name_, fault());
  }
}

void LoadedPlugin::take_snapshots() noexcept {
  for (TopicPort& port : ports_) {
    port.take_snapshot();
  }
}

bool LoadedPlugin::step(const Tick& tick) noexcept {
  tick_ = tick;
  const gaitway_tick plain{.now_ns = tick.now_ns,
                           .batch_start_ns = tick.batch_start_ns,
                           .batch_sequence = tick.batch_sequence,
                           .tick = tick.tick,
                           .batch = tick.batch ? 1U : 0U,
                           .reserved = 0};
  const gaitway_text text = error_text();
  phase_ = Phase::stepping;
  const gaitway_status status = instance_.step(instance_.context, &plain, &text);
  phase_ = Phase::active;
  if (status != GAITWAY_OK && fault().empty()) {
    fmt::format_to_n(error_text_.data(), error_text_.size() - 1, "step answered {} without a text", status)
        .out[0] = '\0';
  }
  if (status == GAITWAY_OK && check_outputs()) {
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

bool LoadedPlugin::check_outputs() noexcept {
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

DataFlowNode LoadedPlugin::node() const {
  DataFlowNode node{name_, {}};
  for (const TopicPort& port : ports_) {
    node.uses.push_back(port.use());
  }
  return node;
}

bool LoadedPlugin::uses(std::string_view topic, Access access) const noexcept {
  return std::any_of(ports_.begin(), ports_.end(), [&](const TopicPort& port) {
    return port.use().access == access && port.use().topic == topic;
  });
}

}  // namespace gaitway::core
