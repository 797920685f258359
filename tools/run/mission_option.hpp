// The plug-in `behaviour` of a simulated robot, and the mission that it begins with.
#pragma once

#include <string>

#include "gaitway/instance/configuration.hpp"

namespace gaitway::tools {

inline constexpr const char* kBehaviourName = "behaviour";
inline constexpr const char* kNoMission = "none";

// Gives the configuration's plug-in of that name the mission; puts one in where there is none, which reads
// missions in its steps: the same in each run. kNoMission: none begins.
void set_mission(core::Configuration& configuration, const std::string& mission);

}  // namespace gaitway::tools
