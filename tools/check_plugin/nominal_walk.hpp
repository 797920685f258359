// Lets the simulated robot walk for some seconds and records what the plug-ins see.
#pragma once

#include "tools/check_plugin/job.hpp"
#include "tools/check_plugin/nominal_record.hpp"

namespace gaitway::plugin_check {

// Throws what the robot, the configuration or a plug-in of it is refused with, and std::runtime_error when
// the robot falls.
NominalRecord record_nominal_walk(const std::filesystem::path& robot, const std::filesystem::path& config,
                                  const std::vector<std::filesystem::path>& plugin_path, std::uint64_t seed);

}  // namespace gaitway::plugin_check
