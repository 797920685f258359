// A walk as it is planned: the pattern's batches, solved by the kinematics, without a body that answers.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "gaitway/facts/facts.hpp"
#include "gaitway/kinematics/batch_solver.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/robot_gait.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "tools/simulate/trajectory_source.hpp"

namespace gaitway::tools {
namespace {

constexpr std::uint32_t kStandingCycles = 6;

Eigen::Isometry3d planned_sole(const MotionPlan& plan, std::size_t point, std::size_t side) {
  Eigen::Isometry3d sole = Eigen::Isometry3d::Identity();
  sole.linear() = Eigen::AngleAxisd(plan.foot_yaw[point][side], Eigen::Vector3d::UnitZ()).toRotationMatrix();
  sole.translation() = Eigen::Vector3d(plan.foot_position[point][side]);
  return sole;
}

void append_point(const MotionPlan& plan, const JointPlan& joint_plan, std::size_t point,
                  urdf::ForwardKinematics& kinematics, kinematic::Trajectory& trajectory) {
  for (std::size_t j = 0; j < trajectory.joint_count; ++j)
    trajectory.joint_rad.push_back(static_cast<double>(joint_plan.position[point][j]));
  kinematics.compute(trajectory.row(trajectory.rows() - 1));
  const std::size_t side = plan.support[point] == 1 ? 1 : 0;
  trajectory.base.push_back(planned_sole(plan, point, side) *
                            kinematics.sole_pose(urdf::kSides[side]).inverse());
  constexpr std::array kContacts{motion::Contact::left, motion::Contact::right, motion::Contact::both};
  trajectory.contact.push_back(kContacts.at(plan.support[point]));
  trajectory.zmp[kinematic::index_of(kinematic::ZmpSource::planned)].emplace_back(plan.zmp[point][0],
                                                                                  plan.zmp[point][1]);
}

}  // namespace

kinematic::Trajectory plan_walk(const urdf::RobotModel& robot, const std::array<double, 3>& walk,
                                double seconds) {
  trajectory::WalkingPattern pattern(trajectory::gait_of(robot));
  kinematics::BatchSolver solver(robot, kinematics::SolverChoice::automatic);
  urdf::ForwardKinematics kinematics(robot);
  kinematic::Trajectory trajectory{.name = fmt::format("walk {:g},{:g},{:g}", walk[0], walk[1], walk[2]),
                                   .kind = "planned walk",
                                   .joint_count = robot.joints.size(),
                                   .start_s = facts::kSlot_s};
  trajectory.notes.emplace_back("as planned: no load compensation, no trims, no feedback");
  const auto plan = std::make_unique<MotionPlan>();
  const auto joint_plan = std::make_unique<JointPlan>();
  WalkCommand command{};
  command.velocity[0] = walk[0];
  command.velocity[1] = walk[1];
  command.turn_rate = walk[2];
  const auto cycles = static_cast<std::uint32_t>(std::ceil(seconds / facts::kCycle_s));
  for (std::uint32_t cycle = 1; cycle <= cycles; ++cycle) {
    command.walk = cycle > kStandingCycles ? 1 : 0;
    pattern.plan(cycle, (cycle - 1) * facts::kCycle_ns, command, Correction{}, *plan);
    solver.go_on_from(cycle - 1);
    solver.plan_batch(cycle, *plan, Correction{}, *joint_plan);
    for (std::size_t point = 0; point < static_cast<std::size_t>(kBatchPoints); ++point)
      append_point(*plan, *joint_plan, point, kinematics, trajectory);
  }
  return trajectory;
}

}  // namespace gaitway::tools
