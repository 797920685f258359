// Where the robot is that `gaitway ctl` speaks to, for every order of it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "tools/command_line.hpp"
#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {

inline constexpr int kExitRefused = 2;
inline constexpr int kExitNoAnswer = 3;

struct CtlOptions {
  ApiAddress api;
  std::optional<std::string> url;
  std::optional<int> port;       // of the API on this computer
  std::filesystem::path socket;  // of the memory block: orders to plug-ins without the API
};
using SharedCtlOptions = std::shared_ptr<CtlOptions>;

void add_address(const CommandLine& command, CtlOptions& options);
// One order below `parent`, with its examples; the robot's address may stand behind it, too.
CommandLine add_order(const CommandLine& parent, const SharedCtlOptions& options, const char* name,
                      const char* help, const char* examples);

// Throws ApiError, or std::invalid_argument for options that contradict each other.
[[nodiscard]] ApiClient connect(const CtlOptions& options);
// Calls a service that answers `success` and `message`, prints the answer, and returns the exit code.
int call_and_print(ApiClient& client, const std::string& service, const nlohmann::json& arguments);

void add_robot_orders(const CommandLine& ctl, const SharedCtlOptions& options);
void add_plugin_orders(const CommandLine& ctl, const SharedCtlOptions& options);

}  // namespace gaitway::tools
