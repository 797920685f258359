// The `gaitway` command line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/calibration/calibrate_command.hpp"
#include "gaitway/input/nearest_name.hpp"
#include "gaitway/tools/api_command.hpp"
#include "gaitway/tools/bus_command.hpp"
#include "gaitway/tools/ctl_command.hpp"
#include "gaitway/tools/dev_command.hpp"
#include "gaitway/tools/measure_command.hpp"
#include "gaitway/tools/motion_command.hpp"
#include "gaitway/tools/new_plugin_command.hpp"
#include "gaitway/tools/plugin_check_command.hpp"
#include "gaitway/tools/plugins_command.hpp"
#include "gaitway/tools/run_command.hpp"
#include "gaitway/tools/serve_command.hpp"

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
             gaitway::input::suggest(rest.front(), known));
}

int run_gaitway(int argc, char** argv) {
  CLI::App app{
      "Gaitway: the main controller of a humanoid robot, and everything below it that makes it move."};
  app.require_subcommand(1);
  app.set_version_flag("--version", GAITWAY_VERSION);
  app.footer(
      "Examples:\n"
      "  gaitway run --walk 0.15 --seconds 20\n"
      "  gaitway new-plugin my_gait --kind trajectory\n"
      "  gaitway run --help");
  gaitway::tools::RunOptions run_options;
  gaitway::tools::NewPluginOptions new_plugin_options;
  gaitway::tools::PluginsOptions plugins_options;
  const CLI::App* const run = gaitway::tools::add_run_command(app, run_options);
  gaitway::tools::ApiOptions api_options;
  const CLI::App* const api = gaitway::tools::add_api_command(app, api_options);
  gaitway::tools::ServeOptions serve_options;
  const CLI::App* const serve = gaitway::tools::add_serve_command(app, serve_options);
  gaitway::tools::CtlOptions ctl_options;
  gaitway::tools::DevOptions dev_options;
  const CLI::App* const dev = gaitway::tools::add_dev_command(app, dev_options);
  const CLI::App* const ctl = gaitway::tools::add_ctl_command(app, ctl_options);
  const CLI::App* const new_plugin = gaitway::tools::add_new_plugin_command(app, new_plugin_options);
  const CLI::App* const plugins = gaitway::tools::add_plugins_command(app, plugins_options);
  gaitway::tools::CheckPluginOptions check_options;
  const CLI::App* const check = gaitway::tools::add_check_plugin_command(app, check_options);
  gaitway::tools::BusOptions bus_options;
  const CLI::App* const bus = gaitway::tools::add_bus_command(app, bus_options);
  gaitway::tools::MeasureOptions measure_options;
  const CLI::App* const measure = gaitway::tools::add_measure_command(app, measure_options);
  gaitway::tools::MotionOptions motion_options;
  const CLI::App* const motion = gaitway::tools::add_motion_command(app, motion_options);
  gaitway::calibration::CalibrateOptions calibrate_options;
  const CLI::App* const calibrate = gaitway::calibration::add_calibrate_command(app, calibrate_options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (app.exit(error) == 0) {
      return gaitway::tools::kExitFine;  // --help, --version
    }
    explain_rest(app);
    return gaitway::tools::kExitBadInput;
  }
  if (run->parsed()) {
    return gaitway::tools::run(run_options);
  }
  if (api->parsed()) {
    return gaitway::tools::document_api(api_options);
  }
  if (serve->parsed()) {
    return gaitway::tools::serve(serve_options);
  }
  if (bus->parsed()) {
    return gaitway::tools::bus(*bus, bus_options);
  }
  if (measure->parsed()) {
    return gaitway::tools::measure(*measure, measure_options);
  }
  if (motion->parsed()) {
    return gaitway::tools::motion_command(*motion, motion_options);
  }
  if (calibrate->parsed()) {
    return gaitway::calibration::calibrate_command(calibrate_options);
  }
  if (check->parsed()) {
    return gaitway::tools::check_plugin(check_options);
  }
  if (dev->parsed()) {
    return gaitway::tools::develop(dev_options);
  }
  if (ctl->parsed()) {
    return gaitway::tools::ctl(*ctl, ctl_options);
  }
  if (plugins->parsed()) {
    return gaitway::tools::list_plugins(plugins_options);
  }
  if (new_plugin->parsed()) {
    gaitway::tools::write_new_plugin(new_plugin_options);
  }
  return gaitway::tools::kExitFine;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 3 && argv[1] == std::string_view(gaitway::plugin_check::kWorkerCommand)) {
    return gaitway::plugin_check::run_worker(argv[2]);
  }
  try {
    return run_gaitway(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "gaitway: {}\n", error.what());
    return gaitway::tools::kExitBadInput;
  }
}
