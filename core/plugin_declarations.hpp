// What a plug-in may declare, checked the same way in the process that asks and in the one that answers.
#pragma once

#include <cstddef>
#include <string_view>

#include "gaitway/plugin/abi.h"

namespace gaitway::core {

// Each throws PluginError for a declaration that cannot be used.
void check_topic(const gaitway_topic* topic, gaitway_access access);
void check_parameter(const gaitway_parameter* parameter);
void check_period(gaitway_period period);

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

inline constexpr const char* kConstructorOnly =
    "topics, parameters and period are declared in the constructor only";
inline constexpr std::size_t kLongestReport = 160;  // bytes of a plug-in's report

}  // namespace gaitway::core
