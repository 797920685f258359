// `gaitway check-plugin`: options in, one line a check out.
#include "tools/check_plugin/check_plugin_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "gaitway/process/installation.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/program.hpp"

namespace gaitway::tools {

CLI::App* add_check_plugin_command(CLI::App& app, CheckPluginOptions& options) {
  CLI::App* const command = add_command(app, "check-plugin");
  plugin_check::CheckOptions& check = options.check;
  check.robot = process::default_robot_directory();
  check.walk_config = process::default_config_file();
  command->add_option("plugin", check.plugin, "The plug-in's library (FILE.so)")->required();
  command->add_flag("--full", check.full, "The long form: 100,000 steps, 1,000 loads, more parameters");
  command->add_option("--json", options.json, "Write everything that was found and measured to this file");
  command->add_option("--seed", check.seed, "Seed of the walk and of the parameters")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--config", check.config, "Configuration (YAML) with the plug-in's parameters");
  command->add_option("--robot", check.robot, "Folder with robot.urdf and robot.yaml")->capture_default_str();
  command
      ->add_option("--budget", check.budget_ms,
                   "Milliseconds that a step may take (default 2, of a batch plug-in 5)")
      ->check(CLI::PositiveNumber);
  command->footer(
      "Examples:\n"
      "  gaitway check-plugin libgaitway_plugin_ankle_trim.so\n"
      "  gaitway check-plugin libgaitway_plugin_ankle_trim.so --full --json check.json\n"
      "Exit code: 0 no finding, 2 findings, 1 the input was bad.");
  return command;
}

int check_plugin(const CheckPluginOptions& options) {
  const plugin_check::CheckOptions& check = options.check;
  const bool terminal = isatty(STDERR_FILENO) != 0;
  fmt::print("{}   seed {}{}\n", check.plugin.filename().string(), check.seed,
             check.full ? "   full form" : "   quick form; --full for the long one");
  std::fflush(stdout);
  if (terminal) {
    fmt::print(stderr, "  ...\r");
  }
  const plugin_check::Report report =
      plugin_check::check_plugin(check, [](const plugin_check::CheckResult& result) {
        fmt::print("{}", to_text(result));
        std::fflush(stdout);
      });
  if (options.json) {
    process::write_text_file(*options.json, to_json(report).dump(2) + "\n");
  }
  const std::size_t count = report.finding_count();
  const std::string verdict =
      count == 0 ? "no finding" : fmt::format("{} finding{}", count, count == 1 ? "" : "s");
  fmt::print("{} {}: {} in {:.1f} s\n", report.name.empty() ? check.plugin.filename().string() : report.name,
             report.version, verdict, report.seconds);
  return count == 0 ? kExitFine : kExitFindings;
}

}  // namespace gaitway::tools

int main(int argc, char** argv) {
  if (argc == 3 && argv[1] == std::string_view(gaitway::plugin_check::kWorkerCommand)) {
    return gaitway::plugin_check::run_worker(argv[2]);
  }
  gaitway::tools::CheckPluginOptions options;
  return gaitway::tools::run_program(argc, argv, [&options](CLI::App& app) -> std::function<int()> {
    gaitway::tools::add_check_plugin_command(app, options);
    return [&options] { return gaitway::tools::check_plugin(options); };
  });
}
