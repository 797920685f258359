// Parses a program's command line, runs its command and turns what goes wrong into one line.
#include "tools/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/input/nearest_name.hpp"

namespace gaitway::tools {
namespace {

// All commands below `app`, and their options.
void add_names(const CLI::App& app, std::vector<std::string>& known) {
  for (const CLI::App* const command : app.get_subcommands([](const CLI::App*) { return true; })) {
    known.push_back(command->get_name());
    for (const CLI::Option* const option : command->get_options()) {
      std::transform(option->get_lnames().begin(), option->get_lnames().end(), std::back_inserter(known),
                     [](const std::string& name) { return "--" + name; });
    }
    add_names(*command, known);
  }
}

// Names what was not understood and the nearest command or option; what CLI11 says alone leaves that open.
void explain_rest(const CLI::App& app) {
  const std::vector<std::string> rest = app.remaining(true);
  if (rest.empty()) {
    return;
  }
  std::vector<std::string> known;
  add_names(app, known);
  fmt::print(stderr, "gaitway: '{}': there is no such command or option. {}\n", rest.front(),
             input::suggest(rest.front(), known));
}

int parse_and_run(int argc, char** argv, const AddCommands& add_commands) {
  CLI::App app{
      "Gaitway: the main controller of a humanoid robot, and everything below it that makes it move."};
  app.require_subcommand(1);
  const std::function<int()> run = add_commands(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (app.exit(error) == 0) {
      return kExitFine;  // --help, --version
    }
    explain_rest(app);
    return kExitBadInput;
  }
  return run();
}

}  // namespace

CLI::App* add_command(CLI::App& app, std::string_view name) {
  const auto* const command = std::find_if(kCommands.begin(), kCommands.end(),
                                           [name](const Command& one) { return one.name == name; });
  if (command == kCommands.end()) {
    throw std::logic_error(fmt::format("'{}' is missing in the list of commands", name));
  }
  return app.add_subcommand(command->name, command->help);
}

int run_program(int argc, char** argv, const AddCommands& add_commands) {
  try {
    return parse_and_run(argc, argv, add_commands);
  } catch (const std::exception& error) {
    fmt::print(stderr, "gaitway: {}\n", error.what());
    return kExitBadInput;
  }
}

}  // namespace gaitway::tools
