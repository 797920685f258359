// A plug-in behind its C ABI: what is called in it, and the functions of gaitway_host that it is offered. The
// same in the manager's process and in a child; who stands behind the functions differs.
#pragma once

#include <cstddef>
#include <string_view>

#include "gaitway/plugin/abi.h"
#include "gaitway/plugin/cycle.hpp"

namespace gaitway::core {

// What a plug-in may declare, checked the same way in the process that asks and in the one that answers: each
// throws PluginError for a declaration that cannot be used.
void check_topic(const gaitway_topic* topic, gaitway_access access);
void check_parameter(const gaitway_parameter* parameter);
void check_period(gaitway_period period);

inline constexpr std::size_t kLongestReport = 160;  // bytes of a plug-in's report

// Where the declarations of a plug-in go once they are checked, and what it reports at any time. All but
// report() throw PluginError or ConfigurationError with the refusal.
class PluginDeclarations {
 public:
  virtual gaitway_port* open_topic(const gaitway_topic& topic, gaitway_access access) = 0;
  // The value lives as long as the plug-in.
  virtual gaitway_value declare_parameter(const gaitway_parameter& parameter) = 0;
  virtual void set_period(gaitway_period period) = 0;
  virtual void report(gaitway_severity severity,
                      std::string_view text) noexcept = 0;  // at most kLongestReport

 protected:
  ~PluginDeclarations() = default;
};

// As the ABI has it.
[[nodiscard]] constexpr gaitway_tick abi_tick(const Tick& tick) noexcept {
  return {.now_ns = tick.now_ns,
          .batch_start_ns = tick.batch_start_ns,
          .batch_sequence = tick.batch_sequence,
          .tick = tick.tick,
          .batch = tick.batch ? 1U : 0U,
          .reserved = 0};
}

// Where the plug-in finds itself. For the values' contracts see gaitway_host.
class PluginSurroundings {
 public:
  [[nodiscard]] virtual const char* robot_directory() const noexcept = 0;
  [[nodiscard]] virtual const char* memory_socket() const noexcept = 0;
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
