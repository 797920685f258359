// Who writes a plug-in's topics while it fails: in the same tick, before the plug-ins that depend on them.
// And while it is stopped.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/managed_plugin.hpp"
#include "gaitway/manager/data_flow.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/plugin/cycle.hpp"

namespace gaitway::core {

// Made at set-up, off the tick; its other calls are for the cycle.
class Fallback {
 public:
  Fallback() = default;
  Fallback(const Fallback&) = delete;
  Fallback& operator=(const Fallback&) = delete;
  virtual ~Fallback() = default;

  // The plug-in worked in this tick: should it fail in the next one, its last values are where to go on from.
  virtual void follow(const Tick& tick) noexcept = 0;
  // Writes the topics through the plug-in's own outputs. False: it cannot, for want of inputs.
  virtual bool act(const Tick& tick, ManagedPlugin& through) noexcept = 0;
};

struct FallbackSource {  // what fallbacks are made from
  msgclient::Client& client;
  const std::filesystem::path& robot_directory;
};

// The built-in one of a kind; nullptr where nothing is to be written. Defined above the manager, which knows
// none of them.
[[nodiscard]] std::unique_ptr<Fallback> make_fallback(FallbackKind kind, const FallbackSource& source);

// Standard topics that a kind reads for what it writes.
[[nodiscard]] std::span<const std::string_view> topics_read_by(FallbackKind kind) noexcept;

// All that stand in for one plug-in.
class FallbackSet {
 public:
  FallbackSet() = default;
  // As its topics ask for, or as is wanted. Throws PluginError if it writes none of the wanted kind's topics.
  FallbackSet(const ManagedPlugin& plugin, FallbackKind wanted, const FallbackSource& source);

  void follow(const Tick& tick) noexcept;
  // True: every topic of the plug-in was written.
  bool act(const Tick& tick, ManagedPlugin& through) noexcept;

  [[nodiscard]] const std::vector<FallbackKind>& kinds() const noexcept { return kinds_; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }  // of the kinds; for people
  [[nodiscard]] bool is_none() const noexcept { return kinds_.empty(); }

 private:
  std::vector<FallbackKind> kinds_;
  std::vector<std::unique_ptr<Fallback>> fallbacks_;
  std::string name_ = "none";
  bool complete_ = false;  // it has somebody for every topic
};

// In the place of a plug-in that is stopped, since the start or later: nothing is loaded; built-in fallbacks
// write the topics that the others miss.
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
