// `gaitway serve`: the simulated robot at the pace of real time, with the robot API on a WebSocket.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gaitway::tools {

struct ServeOptions {
  std::filesystem::path robot;   // folder with robot.urdf and robot.yaml
  std::filesystem::path config;  // plug-ins of the main controller, the api among them
  std::string profile;           // of the bus; empty: what the robot's network file says
  bool accept_unproven = false;
  std::string address = "127.0.0.1";
  int port = 9090;
  std::string origins;  // further web origins that may connect, with commas between them
  std::filesystem::path token_file, certificate_file, key_file;
  std::optional<double> seconds;
  double speed = 1.0;  // times real time
  std::uint64_t seed = 1;
  double mismatch = 1.0;
  std::filesystem::path out = "out/serve";
  bool bus_log = false;
  bool quiet = false;
};

CLI::App* add_serve_command(CLI::App& app, ServeOptions& options);

// Runs until it is told to stop, or `seconds` of the robot's time are over; returns the exit code, as of
// `gaitway run`. Throws on bad input, before anything moves.
int serve(const ServeOptions& options);

}  // namespace gaitway::tools
