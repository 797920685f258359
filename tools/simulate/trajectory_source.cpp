// Tells sources apart, and reads key-frame motions.
#include "tools/simulate/trajectory_source.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "gaitway/input/complaint.hpp"
#include "gaitway/motion/motion_planner.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/trajectory/motion_table.hpp"

namespace gaitway::tools {
namespace {

namespace fs = std::filesystem;
using kinematic::Trajectory;
using kinematic::ZmpSource;

// Where nothing stands a plan does not say where the robot lies: the base stays where it stood last, or will
// stand next.
std::vector<Eigen::Isometry3d> bases_of(const motion::MotionPlan& plan) {
  std::vector<Eigen::Isometry3d> bases = plan.pelvis;
  const auto stands = [&plan](std::size_t point) { return plan.contact[point] != motion::Contact::none; };
  for (std::size_t i = 1; i < bases.size(); ++i) {
    if (!stands(i) && (stands(i - 1) || bases[i - 1].matrix() != plan.pelvis[i - 1].matrix()))
      bases[i] = bases[i - 1];
  }
  for (std::size_t i = bases.size() - 1; i-- > 0 && !stands(0);) {
    if (!stands(i)) bases[i] = bases[i + 1];
  }
  return bases;
}

constexpr const char* kLies =
    "where nothing stands the motion does not say where the robot lies: no torque and no ZMP there";

Trajectory planned_motion(const urdf::RobotModel& robot, const fs::path& file) {
  const motion::PlannedMotion planned = motion::plan_motion(robot, motion::read_motion(file, robot), {});
  const motion::MotionPlan& plan = planned.plan;
  Trajectory trajectory{
      .name = file.filename().string(), .kind = "motion file", .joint_count = plan.joint_count};
  trajectory.joint_rad = plan.joint_rad;
  trajectory.reference_rad = plan.reference_rad;
  trajectory.contact = plan.contact;
  trajectory.base = bases_of(plan);
  trajectory.points_of_wire = true;
  for (const motion::Contact contact : plan.contact) {
    if (contact != motion::Contact::none) continue;
    trajectory.notes.emplace_back(kLies);
    break;
  }
  return trajectory;
}

motion::Contact contact_of(std::uint64_t support) {
  constexpr std::array kContacts{motion::Contact::left, motion::Contact::right, motion::Contact::both,
                                 motion::Contact::none};
  return kContacts.at(support);
}

// Its rows are references, which lead the joints by what the load takes.
Trajectory prepared_motion(const urdf::RobotModel& robot, const fs::path& file) {
  const trajectory::MotionTable table = trajectory::read_motion_table(file);
  if (table.robot_digest != trajectory::robot_digest(robot.directory) ||
      table.joint_count != robot.joints.size()) {
    throw std::invalid_argument(fmt::format("{}: was prepared for another robot than {}. Give its --robot",
                                            file.string(), robot.directory.string()));
  }
  Trajectory result{
      .name = file.filename().string(), .kind = "prepared motion", .joint_count = table.joint_count};
  auto& planned = result.zmp[kinematic::index_of(ZmpSource::planned)];
  bool lies = false;
  for (std::size_t i = 0; i < table.path.size(); ++i) {
    const std::span<const float> offsets = table.path.row(i);
    for (std::size_t j = 0; j < offsets.size(); ++j)
      result.joint_rad.push_back(robot.joints[j].home_rad + static_cast<double>(offsets[j]));
    const trajectory::MotionPoint& point = table.path.points[i];
    result.contact.push_back(contact_of(point.support));
    planned.emplace_back(point.zmp_m[0], point.zmp_m[1]);
    lies = lies || point.support == trajectory::kNothingStands;
  }
  result.points_of_wire = result.leads_joints = true;
  result.notes.emplace_back(
      "what is played are references, which lead the joints by what the load takes: soles and ZMPs that are "
      "made of "
      "them are told, not judged");
  if (lies) result.notes.emplace_back(kLies);
  return result;
}

fs::path motion_of_name(const urdf::RobotModel& robot, const std::string& name) {
  std::vector<std::string> known;
  const fs::path folder = process::motion_directory(robot.directory);
  if (fs::is_directory(folder)) {
    for (const fs::path& file : motion::motion_files(folder)) {
      if (file.stem() == name) return file;
      known.push_back(file.stem().string());
    }
  }
  throw std::invalid_argument(fmt::format("'{}': there is no such file, and no such motion in {}. {}", name,
                                          folder.string(), input::suggest(name, known)));
}

}  // namespace

Trajectory read_trajectory(const urdf::RobotModel& robot, const std::string& given) {
  fs::path file = given;
  if (fs::is_directory(file)) file /= "states.csv";
  if (!fs::exists(file) && !file.has_parent_path() && !file.has_extension())
    return planned_motion(robot, motion_of_name(robot, given));
  const std::string ending = file.extension().string();
  if (fs::is_directory(file) || !fs::exists(file))
    throw std::invalid_argument(fmt::format("{}: there is no such file", file.string()));
  if (ending == ".yaml") return planned_motion(robot, file);
  if (ending == trajectory::kMotionTableEnding) return prepared_motion(robot, file);
  if (ending == ".csv") return read_csv_trajectory(robot, file);
  if (ending == ".log") return read_bus_log_trajectory(robot, file);
  if (ending == ".mcap") return read_recording(robot, file);
  throw std::invalid_argument(fmt::format(
      "{}: its ending '{}' is not known: must be .yaml, .motion, .csv, .log or .mcap, or the folder of a run",
      file.string(), ending));
}

}  // namespace gaitway::tools
