// Which stand a brought robot gets, and how many of its joints its bus carries: what only the finished folder
// tells.
#include "tools/robot/bring_robot.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "gaitway/input/complaint.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/trajectory/robot_gait.hpp"

namespace gaitway::tools {
namespace {

// How many of a robot's joints, from the first on, its bus is proven for.
std::size_t joints_on_bus(urdf::RobotModel robot) {
  while (!robot.joints.empty() && !msgcontroller::complaint_about_network(robot).empty())
    robot.joints.pop_back();
  return robot.joints.size();
}

// How fast the gait is that is chosen for a robot in this stand; zero for one that it cannot walk.
double fastest_m_per_s(urdf::RobotModel robot, const importer::HomePosture& home) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) robot.joints[i].home_rad = home.angle_rad[i];
  robot.hip_height_m = home.hip_height_m;
  try {
    const trajectory::GaitParameters gait = trajectory::gait_of(robot);
    gait.validate();
    trajectory::require_walkable(gait, robot);
    return gait.max_step_forward_m / gait.step_time_s;
  } catch (const std::invalid_argument&) {
    return 0.0;
  }
}

// None: its joints do not let it stand so.
std::optional<importer::ImportedRobot> stand_with_knees_bent(const importer::ImportedRobot& robot,
                                                             double bend_rad) {
  try {
    return importer::with_knees_bent(robot, bend_rad);
  } catch (const input::InputError&) {
    return std::nullopt;
  }
}

// Straighter knees leave ankles more room and legs less reach: the stand from which the robot walks fastest;
// the usual one, if it walks as fast as a robot needs.
importer::ImportedRobot with_best_stand(const importer::ImportedRobot& imported,
                                        const urdf::RobotModel& robot) {
  constexpr double kStraightest_rad = 0.35, kStep_rad = 0.08;
  constexpr double kFastEnough_m_per_s = 0.455;  // of a body as large as humanoid22: Froude's number 0.06
  constexpr double kWorthwhile = 1.03;
  importer::ImportedRobot best = imported;
  double fastest = fastest_m_per_s(robot, imported.home);
  const double enough = kFastEnough_m_per_s * robot.body_scale().factor("m/s");
  for (double bend = imported.home.knee_bend_rad - kStep_rad; bend > kStraightest_rad && fastest < enough;
       bend -= kStep_rad) {
    std::optional<importer::ImportedRobot> straighter = stand_with_knees_bent(imported, bend);
    if (!straighter) break;
    const double speed = fastest_m_per_s(robot, straighter->home);
    if (speed <= kWorthwhile * fastest) continue;
    fastest = speed;
    best = std::move(*straighter);
  }
  if (best.home.knee_bend_rad < imported.home.knee_bend_rad) {
    constexpr double kDegree = 180.0 / std::numbers::pi;
    best.notes.push_back(fmt::format(
        "the knees stand bent by {:.0f} deg instead of {:.0f}: so the robot walks fastest, up to {:.2f} m/s",
        best.home.knee_bend_rad * kDegree, imported.home.knee_bend_rad * kDegree, fastest));
  }
  return best;
}

// The folder that was written, as it is read again. What is wrong with it is told of the maker's file: the
// folder will be gone.
urdf::RobotModel load_brought(const importer::ImportedRobot& imported, const std::filesystem::path& folder) {
  try {
    return urdf::load_robot(folder);
  } catch (const input::InputError& error) {
    std::string why = error.what();
    const std::string place = folder.string() + "/";
    if (why.starts_with(place)) {
      const std::size_t file_end = why.find(": ");
      why.erase(0, file_end == why.npos ? place.size() : file_end + 2);
    }
    throw input::InputError(
        fmt::format("{}: what is made of it cannot be loaded: {}", imported.robot.file.string(), why));
  }
}

}  // namespace

BroughtRobot bring_robot(importer::ImportedRobot imported, const std::filesystem::path& folder) {
  constexpr std::size_t kMostNodes = 64;
  imported = importer::with_fewer_joints(imported, kMostNodes);
  importer::write_robot_folder(imported, folder);
  urdf::RobotModel robot = load_brought(imported, folder);
  const std::size_t most = joints_on_bus(robot);
  importer::ImportedRobot best = with_best_stand(imported, robot);
  if (most < robot.joints.size() || best.home.knee_bend_rad != imported.home.knee_bend_rad) {
    imported = importer::with_fewer_joints(best, most);
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      std::filesystem::remove_all(entry.path());
    importer::write_robot_folder(imported, folder);
    robot = load_brought(imported, folder);
  }
  std::string bus =
      fmt::format("{} joints on one bus, load {:.0f} % in the worst case, every deadline proven",
                  robot.joints.size(), 100.0 * msgcontroller::prove_network(robot).load);
  return {std::move(imported), std::move(robot), std::move(bus)};
}

}  // namespace gaitway::tools
