// What every program of the command line shares: the list of commands, how a command declares its options,
// and the main that parses them, runs it and turns what goes wrong into one line and an exit code. The header
// of the library that parses takes a compiler seconds in every file that sees it, so command_line.cpp alone
// does.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace gaitway::tools {

// Exit codes that all commands share; a command's --help names those of its own.
inline constexpr int kExitFine = 0;
inline constexpr int kExitBadInput = 1;  // nothing moved
inline constexpr int kExitFell = 2;      // the simulated robot fell
inline constexpr int kExitNotDone = 3;   // it stayed up, but did not do what it was asked

// Thrown by a command that ends with kExitNotDone; any other exception ends it with kExitBadInput.
class NotDone : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// One option; what is said about it holds before the command runs.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}
  Option required() const;
  Option excludes(const Option& other) const;
  Option between(double lowest, double highest) const;  // the limits included
  Option above(double limit) const;
  Option one_of(std::vector<std::string> words) const;
  Option values(int count) const;  // exactly so many, of a list
  Option existing_folder() const;
  Option hidden() const;  // not in --help

 private:
  CLI::Option* option_;
};

// A command, or a part of one: a handle, valid as long as the program parses.
class CommandLine {
 public:
  CommandLine(CLI::App& app, std::function<int()>& action) : app_(&app), action_(&action) {}

  [[nodiscard]] CommandLine subcommand(const std::string& name, const std::string& help) const;
  // Options under a title of their own; `one_of_them`: exactly one is given.
  [[nodiscard]] CommandLine group(const std::string& title, bool one_of_them = false) const;
  // `names`: "--speed", or "file" for a word in its place. Value: bool (a flag; "!--no-x" clears it), double,
  // int, std::uint64_t, std::string, std::filesystem::path, std::optional of these, std::vector (with commas
  // between them); what it holds now is shown as the default. Numbers are finite and in range, or refused.
  // `value` outlives the handle.
  template <class Value>
  Option option(const std::string& names, Value& value, const std::string& help) const;
  // Once for each value, or words in their places: commas belong to a value.
  template <class Value>
  Option repeated(const std::string& names, std::vector<Value>& values, const std::string& help) const;
  // An old name of a command: whoever uses it is told the new one.
  void renamed(const std::string& old_name, const std::string& new_name) const;
  // Examples and exit codes, below the options.
  void footer(const std::string& text) const;
  void needs_subcommand() const;
  // What is done once the whole line is understood; the result is the exit code.
  void runs(std::function<int()> action) const;
  // The same with options of its own, which live as long as the program parses and runs.
  template <class Options>
  [[nodiscard]] Options& runs(int (*run)(const Options&)) const {
    const auto options = std::make_shared<Options>();
    runs([options, run] { return run(*options); });
    return *options;
  }

 private:
  CLI::App* app_;
  std::function<int()>* action_;
};

struct Command {
  const char* name;
  const char* help;        // one line
  bool of_python = false;  // a program of the Python package, which may lie elsewhere in the path
};

inline constexpr std::array kCommands{
    Command{"run", "Run the simulated robot headless, faster than real time, and report"},
    Command{"api", "The robot API's reference"},
    Command{"serve", "Serve the simulated robot in paced real time, with the robot API"},
    Command{"simulator", "Try things in a simulated world: goals by click, pushes, faults, pause, rewind"},
    Command{"stop", "Stop a robot by datagram, beside whatever connections it has"},
    Command{"dev", "Watch a plug-in's sources; put each new build into the walking robot"},
    Command{"ctl", "Command a running robot, and change its plug-ins"},
    Command{"new-plugin", "Write the project of a plug-in of your own"},
    Command{"plugins", "List the plug-ins with their topics and parameters"},
    Command{"check-plugin", "Check that a plug-in keeps the rules; for its author and for CI"},
    Command{"bus", "Analyse and describe the robot's CAN bus"},
    Command{"measure", "Measure how well the simulated robot does"},
    Command{"campaign", "Let faults happen at random instants of a walk, and sum up what becomes of it"},
    Command{"motion", "Key-frame motions: list, show, plan, check, draw and prepare them"},
    Command{"behaviour", "Behaviour trees: check and draw them, list the leaves that they may have"},
    Command{"robot", "Bring, describe and check a robot of your own"},
    Command{"calibrate",
            "Find joint zeros, trunk and force cells from standing poses, and how sure they are"},
    Command{"world", "Worlds for the simulated robot: list, check and draw them"},
    Command{"plan", "Plan footsteps through a world, past its obstacles and within the gait's limits"},
    Command{"preflight", "Try something on many simulated robots before it is sent to a real one"},
    Command{"simulate", "Trajectories and ZMPs on the robot without dynamics: limits, collisions, margins"},
    Command{"wireless", "Run a robot and a client with a bad wireless link between them"},
    Command{"sweep", "Run trials over robots, configurations, parameters and seeds, here or on a cluster",
            true},
    Command{"tune", "Tune the gait's numbers of a robot by trials", true}};

// Declares the command of that name, with its line of help.
[[nodiscard]] CommandLine add_command(const CommandLine& program, std::string_view name);

// Parses the line by what `declare` adds to the program, and runs the command that was given. Returns the
// exit code.
int run_program(int argc, char** argv, void (*declare)(const CommandLine& program));

// What a program gaitway-NAME has: the commands of its own.
void declare_program(const CommandLine& program);

// A line that rewrites itself on a terminal, and nothing where output goes to a file or is not wanted.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  ~ProgressLine() { show(""); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const std::string& text) const;

 private:
  bool shown_;
};

// The folder is there and a file can be made in it. Throws std::invalid_argument, to be called before
// anything moves.
void prepare_output(const std::filesystem::path& folder);

// `gaitway run`: the one command that is part of `gaitway` itself.
void add_run(const CommandLine& program);

}  // namespace gaitway::tools
