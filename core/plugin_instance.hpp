// A plug-in behind its C ABI: what is called in it, and the functions of gaitway_host that it is offered. The
// same in the manager's process and in a child; who stands behind the functions differs.
#pragma once

#include "gaitway/plugin/abi.h"
#include "plugin_declarations.hpp"

namespace gaitway::core {

// Where the plug-in finds itself. For the values' contracts see gaitway_host.
class PluginSurroundings {
 public:
  [[nodiscard]] virtual const char* robot_directory() const noexcept = 0;
  [[nodiscard]] virtual const char* memory_socket() const noexcept = 0;
  [[nodiscard]] virtual const char* write_folder() const noexcept = 0;
  virtual gaitway_status read(gaitway_port& port, void* value, gaitway_sample& sample) noexcept = 0;
  // In a step only.
  virtual gaitway_status publish(gaitway_port& port, const void* value) noexcept = 0;

 protected:
  ~PluginSurroundings() = default;
};

// One instance. No exception leaves it; what fails answers a status and writes its reason into `error`.
class PluginInstance {
 public:
  PluginInstance(PluginDeclarations& declarations, PluginSurroundings& surroundings) noexcept;
  ~PluginInstance() { destroy(); }
  PluginInstance(const PluginInstance&) = delete;
  PluginInstance& operator=(const PluginInstance&) = delete;

  // Once, before all others; if it fails there is no instance, and none of the others may be called.
  gaitway_status create(const gaitway_plugin& entry, const gaitway_text& error) noexcept;
  void destroy() noexcept;
  gaitway_status activate(const gaitway_text& error) noexcept;
  gaitway_status deactivate(const gaitway_text& error) noexcept;
  // A failure always has a reason.
  gaitway_status step(const gaitway_tick& tick, const gaitway_text& error) noexcept;
  // Of a plug-in that hands nothing on: version 0.
  gaitway_status save_state(gaitway_state& state, const gaitway_text& error) noexcept;
  gaitway_status restore_state(const gaitway_state& state, const gaitway_text& error) noexcept;
  gaitway_status set_parameter(const char* name, const gaitway_value& value,
                               const gaitway_text& error) noexcept;

 private:
  struct Functions;  // of gaitway_host

  PluginDeclarations& declarations_;
  PluginSurroundings& surroundings_;
  const gaitway_host host_;
  gaitway_instance instance_{};
  bool creating_ = false, stepping_ = false;
};

}  // namespace gaitway::core
