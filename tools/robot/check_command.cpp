// `gaitway robot check`: stands, takes steps, walks; a line for each seed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "gaitway/facts/facts.hpp"
#include "gaitway/manager/plugin_exchange.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "tools/robot/robot_check.hpp"
#include "tools/robot/robot_commands.hpp"

namespace gaitway::tools {
namespace {

struct CheckOptions {
  std::filesystem::path robot, config = process::default_config_file();
  int seeds = 1;
  std::optional<double> speed_m_per_s;
  double seconds = 20.0, mismatch = 1.0;
  bool quiet = false;
};

std::string described(const RobotCheckOutcome& outcome, double speed_m_per_s) {
  using Reached = RobotCheckOutcome::Reached;
  const auto stage = [&](Reached reached, double until_s) {
    if (outcome.reached >= reached) return std::string("ok");
    if (outcome.fell) return fmt::format("fell at {:.2f} s", outcome.fell_at_s);
    return fmt::format("did not until {:.0f} s", until_s);
  };
  std::string text =
      fmt::format("  seed {:<4} stands: {}", outcome.seed, stage(Reached::stand, kStandUntil_s));
  if (outcome.trembles)
    text += fmt::format(", trembles with {:.2f} rad/s", outcome.stand_turn_rate_rad_per_s);
  if (outcome.reached >= Reached::stand) {
    text += fmt::format(", steps: {}", stage(Reached::steps, kStepsUntil_s));
  }
  if (outcome.reached >= Reached::steps) {
    text += fmt::format(", walks: {}", outcome.walks() ? "ok"
                                       : outcome.fell  ? stage(Reached::walk, 0.0)
                                                       : "no");
    text += fmt::format(", {:.3f} of {:.3f} m/s, {:+.2f} m aside", outcome.speed_m_per_s, speed_m_per_s,
                        outcome.drift_m);
  }
  text += fmt::format(", {} of {} batches refused", outcome.refused, outcome.batches + outcome.refused);
  if (!outcome.walks() && !outcome.first_refusal.empty())
    text += fmt::format("\n            {}", outcome.first_refusal);
  return text + "\n";
}

int check(const CheckOptions& options) {
  const urdf::RobotModel robot = urdf::load_robot(options.robot);
  msgcontroller::require_proven_network(robot, false);
  const double usual = kFroudeSpeed * std::sqrt(facts::kGravity_m_per_s2 * robot.hip_height_m);
  const RobotCheckOptions how{.configuration = options.config,
                              .plugin_path = core::plugin_search_path({}),
                              .speed_m_per_s = options.speed_m_per_s.value_or(usual),
                              .walk_s = options.seconds,
                              .mismatch = options.mismatch};
  if (!options.quiet) {
    fmt::print("{}: {:.2f} kg, hips {:.3f} m above the soles; walks at {:.3f} m/s for {:g} s\n", robot.name,
               robot.total_mass_kg(), robot.hip_height_m, how.speed_m_per_s, how.walk_s);
  }
  bool all_walk = true, any_fell = false;
  const ProgressLine progress(!options.quiet);
  for (int seed = 1; seed <= options.seeds; ++seed) {
    const RobotCheckOutcome outcome =
        check_robot(robot, static_cast<std::uint64_t>(seed), how, [&](double time_s) {
          progress.show(fmt::format("  seed {} of {}: {:5.1f} / {:.1f} s ", seed, options.seeds, time_s,
                                    kStepsUntil_s + how.walk_s));
        });
    progress.show("");
    if (!options.quiet) fmt::print("{}", described(outcome, how.speed_m_per_s));
    all_walk = all_walk && outcome.walks();
    any_fell = any_fell || outcome.fell;
  }
  if (!options.quiet && !all_walk) {
    fmt::print("  what limits it: gaitway robot describe {}\n", options.robot.string());
  }
  return any_fell ? kExitFell : all_walk ? kExitFine : kExitNotDone;
}

}  // namespace

void add_robot_check(const CommandLine& robot) {
  const CommandLine command =
      robot.subcommand("check", "Does it stand, take steps and walk? In the simulator, with deviations");
  CheckOptions& options = command.runs(check);
  command.option("robot", options.robot, "Folder with robot.urdf and robot.yaml").required();
  command.option("--seeds", options.seeds, "Robots to try, each with its own deviations").between(1, 1000);
  command
      .option("--speed", options.speed_m_per_s,
              "Walking speed, negative: backward [m/s] (default: 0.14 sqrt(g h) of its hip height)")
      .between(-10.0, 10.0);
  command.option("--seconds", options.seconds, "How long it walks [s]; its speed counts from the third on")
      .between(4.0, 3600.0);
  command.option("--mismatch", options.mismatch, "Scale of what the planner does not know of the robot")
      .between(0.0, 10.0);
  command.option("--config", options.config, "Plug-ins of the main controller (YAML)");
  command.option("--quiet", options.quiet, "Print nothing: the exit code tells");
  command.footer(
      "Examples:\n"
      "  gaitway robot check robots/g1\n"
      "  gaitway robot check robots/g1 --seeds 5 --seconds 60 --speed 0.5\n"
      "Exit code: 0 it walks with each seed, 2 it fell with one, 3 it stayed up, but held less than 80 % of "
      "the speed or\n"
      "more than a tenth of its batches were refused or lacking, 1 the folder was bad and nothing moved.");
}

}  // namespace gaitway::tools
