// `gaitway world`: the worlds there are, whether one can be used, and how it looks.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/simulator/camera.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/world/world_choice.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {
namespace {

struct CommandOptions {
  std::string world;
  std::optional<std::uint64_t> seed;
  std::filesystem::path robot = process::default_robot_directory();
  std::filesystem::path out;
};

constexpr int kWidth_px = 1200, kHeight_px = 900;
constexpr double kMargin_m = 0.3;

world::World read(const CommandOptions& options) {
  return world::load_world(
      {.name = options.world, .random_seed = options.seed, .written_in = "world", .line = 0});
}

// "45 boxes, 4 walls, 1 thing".
std::string contents(const world::World& world) {
  std::vector<std::pair<std::size_t, std::string>> parts;
  for (const world::Kind kind :
       {world::Kind::box, world::Kind::step, world::Kind::slope, world::Kind::tile, world::Kind::wall}) {
    parts.emplace_back(std::ranges::count(world.solids, kind, &world::Solid::kind), world::name(kind));
  }
  parts.emplace_back(world.things.size(), "thing");
  parts.emplace_back(world.tags.size(), "tag");
  std::string text;
  for (const auto& [count, what] : parts) {
    if (count == 0) continue;
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, what,
                        count == 1      ? ""
                        : what == "box" ? "es"
                                        : "s");
  }
  return text.empty() ? "nothing but the floor" : text;
}

// What stands in the comment at the top of its file.
std::string description(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line.starts_with("# ") ? line.substr(2) : "";
}

int list(const CommandOptions&) {
  for (const std::string& name : world::shipped_worlds()) {
    fmt::print("{:<10} {}\n", name, description(process::world_directory() / (name + ".yaml")));
  }
  return kExitFine;
}

simulator::Plant plant_in(const world::World& world, const urdf::RobotModel& robot) {
  simulator::PlantOptions plant{.mismatch = 0.0, .sensor_noise = false};
  plant.world = world;
  return {robot, plant};
}

int check(const CommandOptions& options) {
  const world::World world = read(options);
  const urdf::RobotModel robot = urdf::load_robot(options.robot);
  (void)plant_in(world, robot);  // it has room at the start
  fmt::print("{}: {}\n{} has room at its start ({:g}, {:g} m, {:g} deg)\n", world.file.string(),
             contents(world), robot.name, world.start.position_m.x(), world.start.position_m.y(),
             world.start.yaw_rad * facts::kDegreePerRad);
  return kExitFine;
}

// From above, so that all of it is seen, and the robot at its start.
simulator::View from_above(const world::World& world) {
  Eigen::Vector2d least = world.start.position_m.array() - 0.5,
                  greatest = world.start.position_m.array() + 0.5;
  double top_m = 0.0;
  for (const world::Solid& solid : world.all_solids(true)) {
    const auto [low, high] = solid.bounds_m();
    least = least.cwiseMin(low.head<2>());
    greatest = greatest.cwiseMax(high.head<2>());
    top_m = std::max(top_m, high.z());
  }
  const Eigen::Vector2d size = (greatest - least).array() + 2.0 * kMargin_m;
  const double height_m = std::max(size.y(), size.x() * kHeight_px / kWidth_px);
  const double half_view = std::tan(simulator::kFieldOfView_deg / 2.0 * facts::kRadPerDegree);
  const Eigen::Vector2d middle = (least + greatest) / 2.0;
  return {.look_at_m = {middle.x(), middle.y(), 0.0},
          .distance_m = height_m / 2.0 / half_view + top_m,
          .azimuth_deg = 90.0,
          .elevation_deg = -90.0};
}

int draw(const CommandOptions& options) {
  const world::World world = read(options);
  const urdf::RobotModel robot = urdf::load_robot(options.robot);
  const simulator::Plant plant = plant_in(world, robot);
  simulator::Camera camera(plant, kWidth_px, kHeight_px);
  const std::array picture{camera.render(plant.positions(), from_above(world))};
  const std::filesystem::path out =
      options.out.empty() ? std::filesystem::path(world.name + ".png") : options.out;
  simulator::write_film_strip(out.string(), picture, 1);
  fmt::print("{}\n", out.string());
  return kExitFine;
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "world");
  command.needs_subcommand();
  const auto given = std::make_shared<CommandOptions>();
  CommandOptions& options = *given;
  command.subcommand("list", "The worlds that are shipped").runs([given] { return list(*given); });
  const auto add = [&](const char* name, const char* help, int (*run)(const CommandOptions&)) {
    const CommandLine one = command.subcommand(name, help);
    one.option("world", options.world, "A file, or the name of a shipped world").required();
    one.option("--world-seed", options.seed, "Seed of its random courses, in place of their own")
        .between(0.0, std::numeric_limits<int>::max());
    one.option("--robot", options.robot, "Folder of the robot that shall have room at its start");
    one.runs([given, run] { return run(*given); });
    return one;
  };
  add("check", "Read it, and see whether the robot has room at its start", check);
  add("draw", "A picture from above, x to the right", draw)
      .option("--out", options.out, "PNG file; otherwise NAME.png");
  command.footer(
      "Examples:\n"
      "  gaitway world list\n"
      "  gaitway world check my_world.yaml\n"
      "  gaitway world draw boxes --world-seed 3 --out boxes.png\n"
      "Exit code: 0 fine, 1 it cannot be used, or the input was bad.");
}

}  // namespace gaitway::tools
