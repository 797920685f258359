// Whether a simulation is the twin of a real robot: which one, where that is, and how a pre-flight for it is
// started.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/world/world.hpp"
#include "tools/ctl/api_client.hpp"
#include "tools/preflight/robot_now.hpp"
#include "tools/serve/module_options.hpp"

namespace gaitway::tools {

struct TwinChoice {
  std::filesystem::path folder;     // of the robot's description
  std::optional<ApiAddress> there;  // nothing: no real robot
};

// `robots`: what --robot was given: a folder, an address, or both. Throws std::invalid_argument for two of a
// kind, and for what belongs to a real robot where there is none.
[[nodiscard]] TwinChoice twin_choice(const std::vector<std::string>& robots,
                                     const std::filesystem::path& token_file,
                                     const std::filesystem::path& ca_file);

// Throws ApiError for another release or another robot, NoAnswer.
[[nodiscard]] RobotNow ask_real_robot(const ApiAddress& there, const urdf::RobotModel& robot);

// The simulated robot's own API. Throws std::invalid_argument for a port that nobody knows beforehand.
[[nodiscard]] ApiAddress own_api(const ModuleOptions& module);

// Of every `gaitway preflight` of this twin.
[[nodiscard]] std::vector<std::string> flight_arguments(const ApiAddress& there,
                                                        const std::filesystem::path& robot,
                                                        const std::filesystem::path& config,
                                                        const world::World& world, int robots);

}  // namespace gaitway::tools
