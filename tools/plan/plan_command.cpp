// `gaitway plan`: footsteps from here to there through a world.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/navigation/robot_limits.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/world/world_choice.hpp"
#include "tools/command_line.hpp"
#include "tools/plan/plan_report.hpp"

namespace gaitway::tools {
namespace {

struct PlanOptions {
  std::string world;
  std::optional<std::uint64_t> seed;
  std::filesystem::path robot = process::default_robot_directory();
  std::optional<std::vector<double>> from;  // x m, y m, yaw deg
  std::vector<double> to;
  std::filesystem::path picture;
  bool json = false;
};

planning::Pose pose_of(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], planning::wrapped(numbers[2] * facts::kRadPerDegree)};
}

int plan(const PlanOptions& options) {
  const world::World world = world::load_world(
      {.name = options.world, .random_seed = options.seed, .written_in = "--world", .line = 0});
  const planning::Limits limits = navigation::limits_of(urdf::load_robot(options.robot));
  const planning::Pose start = options.from ? pose_of(*options.from)
                                            : planning::Pose{world.start.position_m.x(),
                                                             world.start.position_m.y(), world.start.yaw_rad};
  const planning::Request request{.left = limits.foot_of(start, planning::Side::left),
                                  .right = limits.foot_of(start, planning::Side::right),
                                  .goal = pose_of(options.to)};
  const double cell_m = navigation::cell_for(limits);
  const planning::Planner planner(limits, cell_m);
  const planning::GroundMap map =
      planning::ground_map(world, planning::grid_over(world, start, request.goal, cell_m), limits.height_m);
  const planning::Plan planned = planner.plan(map, request);
  const PlannedWay way{world, limits, map, request, planned};
  if (!options.picture.empty()) draw_plan(options.picture, way);
  if (options.json) {
    fmt::print("{}\n", plan_json(way).dump(2));
  } else if (planned.found()) {
    fmt::print("{}", plan_text(way));
    if (!options.picture.empty()) fmt::print("  picture {}\n", options.picture.string());
  } else {
    fmt::print(stderr, "{}", plan_text(way));
  }
  return planned.found() ? kExitFine : kExitNotDone;
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "plan");
  PlanOptions& options = command.runs(plan);
  constexpr int kNumbers = 3;
  constexpr double kMost = 1000.0;
  command.option("--world", options.world, "A file, or the name of a shipped world").required();
  command.option("--world-seed", options.seed, "Seed of its random courses, in place of their own")
      .between(0.0, std::numeric_limits<int>::max());
  command.option("--robot", options.robot, "Folder with robot.urdf and robot.yaml");
  command
      .option("--from", options.from,
              "X,Y,YAW in m, m and degrees, of the middle between the feet; otherwise the world's start")
      .between(-kMost, kMost)
      .values(kNumbers);
  command.option("--to", options.to, "X,Y,YAW in m, m and degrees, of the same")
      .required()
      .between(-kMost, kMost)
      .values(kNumbers);
  command.option("--json", options.json, "The plan as JSON");
  command.option("--picture", options.picture,
                 "PNG file: map, obstacles, footsteps, swept body and goal from above");
  command.footer(
      "Examples:\n"
      "  gaitway plan --world boxes --to 2.3,2,90 --picture way.png\n"
      "  gaitway plan --world slalom --from 0,0.5,0 --to 5.5,0,0 --json\n"
      "  gaitway plan --world my_world.yaml --robot my_robot --to 1,0,0\n"
      "Exit code: 0 a plan, 3 there is no way, and the reason is told, 1 the input was bad.");
}

}  // namespace gaitway::tools
