// `gaitway check-plugin`: a plug-in against every rule of the plug-in interface.

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string_view>

#include "gaitway/input/text.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/check_plugin/plugin_check.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {
namespace {

// Exit codes of `gaitway check-plugin`; bad input is 1.
constexpr int kExitFindings = 2;

struct CheckPluginOptions {
  plugin_check::CheckOptions check;
  std::optional<std::filesystem::path> json;  // everything that was found and measured goes here
};

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
        fmt::print("{}", input::terminal_text(to_text(result)));
        std::fflush(stdout);
      });
  if (options.json) {
    process::write_text_file(*options.json, to_json(report).dump(2) + "\n");
  }
  const std::size_t count = report.finding_count();
  const std::string verdict =
      count == 0 ? "no finding" : fmt::format("{} finding{}", count, count == 1 ? "" : "s");
  const std::string name = report.name.empty() ? check.plugin.filename().string() : report.name;
  fmt::print("{} in {:.1f} s\n",
             input::terminal_text(fmt::format("{} {}: {}", name, report.version, verdict)), report.seconds);
  return count == 0 ? kExitFine : kExitFindings;
}

void declare(const CommandLine& app) {
  const CommandLine command = add_command(app, "check-plugin");
  CheckPluginOptions& options = command.runs(check_plugin);
  plugin_check::CheckOptions& check = options.check;
  check.robot = process::default_robot_directory();
  check.walk_config = process::default_config_file();
  command.option("plugin", check.plugin, "The plug-in's library (FILE.so)").required();
  command.option("--full", check.full, "The long form: 100,000 steps, 1,000 loads, more parameters");
  command.option("--json", options.json, "Write everything that was found and measured to this file");
  command.option("--seed", check.seed, "Seed of the walk and of the parameters");
  command.option("--config", check.config, "Configuration (YAML) with the plug-in's parameters");
  command.option("--robot", check.robot, "Folder with robot.urdf and robot.yaml");
  command
      .option("--budget", check.budget_ms,
              "Milliseconds that a step may take (default 2, of a batch plug-in 5)")
      .above(0.0);
  command.footer(
      "Examples:\n"
      "  gaitway check-plugin libgaitway_plugin_ankle_trim.so\n"
      "  gaitway check-plugin libgaitway_plugin_ankle_trim.so --full --json check.json\n"
      "Exit code: 0 no finding, 2 findings, 1 the input was bad.");
}

}  // namespace
}  // namespace gaitway::tools

int main(int argc, char** argv) {
  if (argc == 3 && argv[1] == std::string_view(gaitway::plugin_check::kWorkerCommand)) {
    return gaitway::plugin_check::run_worker(argv[2]);
  }
  return gaitway::tools::run_program(argc, argv, gaitway::tools::declare);
}
