// The main of every program of the command line: options are parsed, the command is run, errors become one
// line and an exit code. And the list of all commands, each of which but `run` is a program of its own.
#pragma once

#include <array>
#include <functional>
#include <string_view>

namespace CLI {
class App;
}

namespace gaitway::tools {

// Exit codes that all commands share; a command's --help names those of its own.
inline constexpr int kExitFine = 0;
inline constexpr int kExitBadInput = 1;  // nothing moved
inline constexpr int kExitFell = 2;      // the simulated robot fell

struct Command {
  const char* name;
  const char* help;  // one line
};

inline constexpr std::array kCommands{
    Command{"run", "Run the simulated robot headless, faster than real time, and report"},
    Command{"api", "The robot API's reference"},
    Command{"serve", "Serve the simulated robot in paced real time, with the robot API"},
    Command{"dev", "Watch a plug-in's sources; put each new build into the walking robot"},
    Command{"ctl", "Command a running robot, and change its plug-ins"},
    Command{"new-plugin", "Write the project of a plug-in of your own"},
    Command{"plugins", "List the plug-ins with their topics and parameters"},
    Command{"check-plugin", "Check that a plug-in keeps the rules; for its author and for CI"},
    Command{"bus", "Analyse and describe the robot's CAN bus"},
    Command{"measure", "Measure how well the simulated robot does"},
    Command{"motion", "Key-frame motions: list, show, plan, check, draw and prepare them"},
    Command{"calibrate", "Find the errors of joints and force cells from standing poses"}};

// Adds the command `name`, with its line of help.
CLI::App* add_command(CLI::App& app, std::string_view name);

// Adds the program's commands to the application, and returns what is run when the line has been parsed.
using AddCommands = std::function<std::function<int()>(CLI::App&)>;

// Returns the program's exit code.
int run_program(int argc, char** argv, const AddCommands& add_commands);

}  // namespace gaitway::tools
