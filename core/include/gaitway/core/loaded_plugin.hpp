// One plug-in of the configuration in its life: loaded, constructed, bound, activated, stepped, and back
// again.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/core/configuration.hpp"
#include "gaitway/core/data_flow.hpp"
#include "gaitway/core/event_log.hpp"
#include "gaitway/core/parameter_set.hpp"
#include "gaitway/core/plugin_library.hpp"
#include "gaitway/core/tick.hpp"
#include "gaitway/core/topic_port.hpp"
#include "gaitway/msgclient/client.hpp"

namespace gaitway::core {

struct PluginSource {  // what is needed to load plug-ins
  const std::filesystem::path& configuration_file;
  const std::filesystem::path& robot_directory;
  const SearchPath& search_path;
};

// Stays where it is: the plug-in holds pointers to it. Its members before step() throw PluginError
// (ConfigurationError for a parameter), with the plug-in's name and place.
class LoadedPlugin {
 public:
  // Loads the library and constructs the plug-in. `events` outlives it.
  LoadedPlugin(const PluginEntry& entry, const PluginSource& source, EventLog& events);
  ~LoadedPlugin();
  LoadedPlugin(const LoadedPlugin&) = delete;
  LoadedPlugin& operator=(const LoadedPlugin&) = delete;

  void bind(msgclient::Client& client);
  void activate();
  void deactivate() noexcept;

  // For the cycle.
  [[nodiscard]] bool is_due(const Tick& tick) const noexcept { return tick.batch || period_ == Period::tick; }
  void take_snapshots() noexcept;
  // Publishes the outputs if all went well. False: a fault; nothing was published and fault() says why.
  bool step(const Tick& tick) noexcept;
  [[nodiscard]] std::string_view fault() const noexcept { return error_text_.data(); }

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const std::string& place() const noexcept { return place_; }
  [[nodiscard]] const PluginLibrary& library() const noexcept { return library_; }
  [[nodiscard]] const ParameterSet& parameters() const noexcept { return parameters_; }
  [[nodiscard]] Period period() const noexcept { return period_; }
  [[nodiscard]] DataFlowNode node() const;
  [[nodiscard]] bool uses(std::string_view topic, Access access) const noexcept;

 private:
  friend struct HostFunctions;
  enum class Phase : std::uint8_t { creating, idle, active, stepping };

  [[nodiscard]] gaitway_text error_text() noexcept;
  [[noreturn]] void fail(std::string_view what);
  bool check_outputs() noexcept;

  std::string name_;
  std::string place_;  // "plug-in 'x' (walk.yaml:4)"
  std::string robot_directory_;
  PluginLibrary library_;
  ParameterSet parameters_;
  EventLog& events_;
  std::list<TopicPort> ports_;  // stable addresses: the plug-in holds them
  Period period_ = Period::tick;
  Phase phase_ = Phase::creating;
  Tick tick_;
  std::array<char, 1024> error_text_{};
  std::unique_ptr<ConfigurationError> parameter_error_;  // says more than what came back through the plug-in
  gaitway_host host_{};
  gaitway_instance instance_{};
};

}  // namespace gaitway::core
