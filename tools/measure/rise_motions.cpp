// Looks for them where the planner does.
#include "tools/measure/rise_motions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

#include "gaitway/process/installation.hpp"
#include "gaitway/trajectory/motion_table.hpp"

namespace gaitway::tools {
namespace {

std::vector<std::filesystem::path> folders_of(const TrialRobot& robot) {
  std::vector<std::filesystem::path> folders = process::prepared_motion_directories(robot.model.directory);
  for (const core::PluginEntry& plugin : robot.plugins.plugins) {
    for (const core::ParameterEntry& parameter : plugin.parameters) {
      if (parameter.name == "motions") folders.emplace_back(parameter.text);
    }
  }
  return folders;
}

std::set<std::string> motions_of(const TrialRobot& robot) {
  const std::uint64_t digest = trajectory::robot_digest(robot.model.directory);
  std::set<std::string> names;
  for (const std::filesystem::path& folder : folders_of(robot)) {
    for (const std::filesystem::path& file : trajectory::motion_table_files(folder)) {
      const trajectory::MotionTable table = trajectory::read_motion_table(file);
      if (table.robot_digest == digest) names.insert(table.name);
    }
  }
  return names;
}

}  // namespace

std::string without_rise_motions(std::vector<GaitRow>& rows, const TrialRobot& robot) {
  const std::set<std::string> known = motions_of(robot);
  std::string names, example;
  std::erase_if(rows, [&](const GaitRow& row) {
    if (!row.trials) return false;
    const std::vector<Trial> trials = row.trials(1, row.floor);
    const auto unknown = std::ranges::find_if(
        trials, [&](const Trial& trial) { return trial.rise && !known.contains(trial.rise->motion); });
    if (unknown == trials.end()) return false;
    names += (names.empty() ? "" : ", ") + row.name;
    example = unknown->rise->motion;
    return true;
  });
  if (names.empty()) return {};
  const std::string directory = robot.model.directory.string();
  return fmt::format(
      "{}: what the robot would get up by is not prepared for {} as it is described now. Prepare it: gaitway "
      "motion prepare {} --robot {} --out {}; or take it over from another robot: gaitway motion adapt",
      names, directory, example, directory, process::motion_directory(robot.model.directory).string());
}

}  // namespace gaitway::tools
