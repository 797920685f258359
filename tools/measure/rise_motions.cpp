// Looks for them where the planner does.
#include "tools/measure/rise_motions.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <set>
#include <stdexcept>
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

void require_rise_motions(const std::vector<GaitRow>& rows, const TrialRobot& robot) {
  const std::set<std::string> known = motions_of(robot);
  const std::filesystem::path& directory = robot.model.directory;
  for (const GaitRow& row : rows) {
    if (!row.trials) continue;
    for (const Trial& trial : row.trials(1, row.floor)) {
      if (!trial.rise || known.contains(trial.rise->motion)) continue;
      const std::string& motion = trial.rise->motion;
      throw std::invalid_argument(
          fmt::format("row '{0}': its robots get up by the motion '{1}', which is not prepared for {2} as it "
                      "is described now. "
                      "Prepare it: gaitway motion prepare {1} --robot {2} --out {3} (or take it over from "
                      "another robot: gaitway "
                      "motion adapt {1} --robot {2}), or leave the row out: --except {0}",
                      row.name, motion, directory.string(), process::motion_directory(directory).string()));
    }
  }
}

}  // namespace gaitway::tools
