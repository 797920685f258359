// `gaitway api`: what concerns the robot API without a robot.
#pragma once

#include <filesystem>

namespace CLI {
class App;
}

namespace gaitway::tools {

struct ApiOptions {
  std::filesystem::path out = "docs";
};

// `options` outlives the application.
CLI::App* add_api_command(CLI::App& app, ApiOptions& options);

// Writes reference, examples and schemas; the exit code. Throws when a file cannot be written.
int document_api(const ApiOptions& options);

}  // namespace gaitway::tools
