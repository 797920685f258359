// `gaitway new-plugin`: writes a plug-in's project, made from the templates, that builds, passes its test and
// moves the robot as it is.
#pragma once

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace gaitway::tools {

struct NewPluginOptions {
  std::string name;
  std::string kind = "blank";
  std::filesystem::path folder;  // empty: ./NAME
};

// Adds the subcommand; `options` is filled when it is parsed.
CLI::App* add_new_plugin_command(CLI::App& app, NewPluginOptions& options);

// Writes the files and prints the next commands. Throws std::exception and leaves nothing behind when the
// name is none, a file is there already, or the folder cannot be written.
void write_new_plugin(const NewPluginOptions& options);

}  // namespace gaitway::tools
