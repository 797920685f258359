// What a plug-in may declare, checked the same way in the process that asks and in the one that answers.
#pragma once

#include <cstddef>

#include "gaitway/plugin/abi.h"

namespace gaitway::core {

// Each throws PluginError for a declaration that cannot be used.
void check_topic(const gaitway_topic* topic, gaitway_access access);
void check_parameter(const gaitway_parameter* parameter);
void check_period(gaitway_period period);

inline constexpr const char* kConstructorOnly =
    "topics, parameters and period are declared in the constructor only";
inline constexpr std::size_t kLongestReport = 160;  // bytes of a plug-in's report

}  // namespace gaitway::core
