// What the host offers plug-ins: the C functions of gaitway_host on a LoadedPlugin. No exception leaves them.
#pragma once

#include "gaitway/manager/loaded_plugin.hpp"

namespace gaitway::core {

struct HostFunctions {
  [[nodiscard]] static gaitway_host table(LoadedPlugin& plugin) noexcept;

  static gaitway_status open_topic(void* context, const gaitway_topic* topic, gaitway_access access,
                                   gaitway_port** port, const gaitway_text* error) noexcept;
  static gaitway_status parameter(void* context, const gaitway_parameter* parameter, gaitway_value* value,
                                  const gaitway_text* error) noexcept;
  static gaitway_status set_period(void* context, gaitway_period period, const gaitway_text* error) noexcept;
  static const char* robot_directory(void* context) noexcept;
  static const char* memory_socket(void* context) noexcept;
  static const char* write_folder(void* context) noexcept;
  static gaitway_status read(void* context, gaitway_port* port, void* value, gaitway_sample* sample) noexcept;
  static gaitway_status publish(void* context, gaitway_port* port, const void* value) noexcept;
  static const void* get_extension(void* context, const char* name) noexcept;
  static void report(void* context, gaitway_severity severity, const char* text) noexcept;

 private:
  template <class Function>
  static gaitway_status in_create(void* context, const gaitway_text* error,
                                  const Function& function) noexcept;
};

}  // namespace gaitway::core
