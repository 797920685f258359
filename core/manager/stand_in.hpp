// In the place of a plug-in that is stopped, since the start or later: nothing is loaded; built-in
// fallbacks write the topics that the others miss.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gaitway/manager/fallback.hpp"
#include "gaitway/manager/managed_plugin.hpp"

namespace gaitway::core {

class StandIn final : public ManagedPlugin {
 public:
  // Writes these topics, all of them standard ones with a fallback.
  StandIn(const PluginEntry& entry, const std::vector<std::string>& topics,
          const std::filesystem::path& configuration_file, EventLog& events);

  void activate() override {}
  void deactivate() noexcept override {}
  bool save_state(PluginState& state) noexcept override;
  bool restore_state(const PluginState&) noexcept override { return true; }
  bool set_parameter(const char*, const gaitway_value&) noexcept override;
  [[nodiscard]] std::string_view version() const noexcept override { return "nothing"; }

  // What it is to write: standard topics that nobody else does and that a fallback can write. Of the kind
  // that `entry` names; else those whose standard writer has its name; else those that a loaded plug-in
  // needs.
  [[nodiscard]] static std::vector<std::string> topics_for(const PluginEntry& entry,
                                                           const std::vector<DataFlowNode>& loaded,
                                                           const std::vector<ExternalTopic>& external);
  // Of a running plug-in's own topics those that a fallback can write.
  [[nodiscard]] static std::vector<std::string> topics_for(const DataFlowNode& running);

 private:
  bool run(const Tick&) noexcept override { return true; }
};

}  // namespace gaitway::core
