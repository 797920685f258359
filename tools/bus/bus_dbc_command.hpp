// `gaitway bus dbc` and `gaitway bus document`: the network's description as files.
#pragma once

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace gaitway::tools {

struct BusDbcOptions {
  std::filesystem::path robot;
  std::string profile;        // empty: the one that the network file names
  std::filesystem::path out;  // empty: the terminal
};
// Adds the subcommand to `gaitway bus`; `options` is filled when it is parsed.
CLI::App* add_bus_dbc_command(CLI::App& bus, BusDbcOptions& options);
// Throws when the robot's description or the profile is bad, or the file cannot be written. Returns the exit
// code.
int write_dbc(const BusDbcOptions& options);

struct BusDocumentOptions {
  std::filesystem::path robot;
  std::filesystem::path out;  // empty: the terminal
};
CLI::App* add_bus_document_command(CLI::App& bus, BusDocumentOptions& options);
int write_network_document(const BusDocumentOptions& options);

}  // namespace gaitway::tools
