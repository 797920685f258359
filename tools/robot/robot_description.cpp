// Asks who decides: the gait's choice, the footstep limits, the torques, the proof of the bus.
#include "tools/robot/robot_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <stdexcept>

#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/trajectory/footstep_planner.hpp"
#include "gaitway/trajectory/joint_pace.hpp"
#include "gaitway/trajectory/robot_gait.hpp"

namespace gaitway::tools {
namespace {

using trajectory::ChosenGait;
using trajectory::GaitParameters;

std::string gait_complaint(const GaitParameters& parameters, const urdf::RobotModel& robot) {
  try {
    parameters.validate();
    trajectory::require_walkable(parameters, robot);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

// What changed the numbers that make the limit; what nothing changed is the default of any body.
std::string cause_of(const ChosenGait& gait, std::initializer_list<const char*> numbers) {
  std::string text;
  std::vector<std::string> told;
  for (const char* const number : numbers) {
    const trajectory::GaitChoice* const choice = gait.choice(number);
    if (choice == nullptr) continue;
    for (const std::string& reason : choice->reasons) {
      if (std::ranges::find(told, reason) != told.end()) continue;
      told.push_back(reason);
      text += fmt::format("{}{}", text.empty() ? "" : "; ", reason);
    }
  }
  return text.empty() ? "the default gait, scaled to this body" : text;
}

std::vector<SpeedLimit> speed_limits(const ChosenGait& gait, const urdf::RobotModel& robot) {
  const trajectory::FootstepPlanner planner(gait.parameters);
  std::vector<SpeedLimit> limits{
      {"forward", "m/s", planner.max_forward_m_per_s(false),
       cause_of(gait, {"max_step_forward", "step_time"})},
      {"backward", "m/s", planner.max_forward_m_per_s(true),
       cause_of(gait, {"max_step_backward", "step_time"})},
      {"sideways", "m/s", planner.max_left_m_per_s(), cause_of(gait, {"max_foot_spacing", "step_time"})},
      {"turn", "rad/s", planner.max_turn_rad_per_s(), cause_of(gait, {"max_step_turn", "step_time"})}};
  const trajectory::JointPace pace =
      trajectory::fastest_joint(gait.parameters, robot, planner.max_forward_m_per_s(false));
  limits[0].cause += fmt::format("; the {} then turns at {:.0f} % of its limit",
                                 urdf::leg_joint_name(pace.joint), 100.0 * pace.share);
  return limits;
}

}  // namespace

RobotDescription describe_robot(const urdf::RobotModel& robot) {
  RobotDescription result{.robot = robot,
                          .gait = trajectory::choose_gait(robot),
                          .speeds = {},
                          .torques = {},
                          .gait_complaint = {},
                          .torque_complaint = {},
                          .bus_profile = std::string(msgcontroller::network_profile(robot).name),
                          .bus_complaint = msgcontroller::complaint_about_network(robot)};
  result.torques = trajectory::leg_torques(result.gait.parameters, robot);
  result.torque_complaint = trajectory::weakest_joint(result.torques, robot);
  result.gait_complaint = gait_complaint(result.gait.parameters, robot);
  if (result.gait_complaint.empty()) result.speeds = speed_limits(result.gait, robot);
  return result;
}

}  // namespace gaitway::tools
