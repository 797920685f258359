// The `gaitway` command line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "gaitway/tools/run_command.hpp"

int main(int argc, char** argv) {
  CLI::App app{
      "Gaitway: the main controller of a humanoid robot, and everything below it that makes it move."};
  app.require_subcommand(1);
  app.set_version_flag("--version", GAITWAY_VERSION);
  app.footer("Examples:\n  gaitway run --walk 0.15 --seconds 20\n  gaitway run --help");
  gaitway::tools::RunOptions run_options;
  const CLI::App* const run = gaitway::tools::add_run_command(app, run_options);
  CLI11_PARSE(app, argc, argv);
  try {
    if (run->parsed()) {
      return gaitway::tools::run(run_options);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "gaitway: {}\n", error.what());
    return gaitway::tools::kExitBadInput;
  }
  return gaitway::tools::kExitFine;
}
