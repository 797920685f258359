// A leg's inverse kinematics, ours and the peers', on the same poses: one round, as JSON. With a file as
// its argument it writes the poses into it instead, for peers that are called from elsewhere.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gaitway/kinematics/batch_solver.hpp"
#include "leg_rival.hpp"
#include "leg_sampler.hpp"
#include "test_robot.hpp"
#include "turns.hpp"
#include "walking_plan.hpp"

namespace gaitway::peers {
namespace {

using kinematics::test::LegSampler;
using Json = nlohmann::ordered_json;

constexpr urdf::Side kSide = urdf::Side::left;
constexpr std::uint32_t kBatches = 60;
constexpr std::size_t kRandomPoses = 200, kTurnsOfWalk = 9, kTurnsOfRandom = 3;
constexpr double kProven =
    10.0 * kTolerance;  // m and rad: a solution that is told is one when it is so close

// Poses of one kind for one robot.
struct Task {
  std::string name;
  const urdf::RobotModel& robot;
  std::vector<Eigen::Isometry3d> soles;
  bool from_last;  // each starts from the solution before; else each from home
};

Eigen::Isometry3d sole_of(const urdf::RobotModel& robot, const LegAngles& angle_rad) {
  std::vector<double> all = kinematics::test::home_posture(robot);
  for (std::size_t i = 0; i < 6; ++i) {
    all[static_cast<std::size_t>(robot.legs[static_cast<std::size_t>(kSide)].joints[i])] = angle_rad[i];
  }
  return kinematics::test::sole_pose(robot, kSide, all);
}

// Of a walk in a turn, one every 10 ms.
Task walk(const std::string& name, const urdf::RobotModel& robot) {
  kinematics::BatchSolver solver(robot, kinematics::SolverChoice::automatic);
  const kinematics::test::WalkingPlan plan(0.25, 0.3, kinematics::test::walking_hip_height_m(robot));
  Task task{"walk, " + name, robot, {}, true};
  JointPlan joints{};
  for (std::uint32_t sequence = 1; sequence <= kBatches; ++sequence) {
    if (!solver.solve(plan.batch(sequence), {}, joints).solved()) {
      throw std::runtime_error(fmt::format("{}: batch {} is not solved", name, sequence));
    }
    for (int point = 0; point < kBatchPoints; ++point) {
      LegAngles angle_rad{};
      for (std::size_t i = 0; i < 6; ++i) {
        angle_rad[i] = static_cast<double>(
            joints.position[point][robot.legs[static_cast<std::size_t>(kSide)].joints[i]]);
      }
      task.soles.push_back(sole_of(robot, angle_rad));
    }
  }
  return task;
}

// Anywhere within the limits of all joints.
Task random_poses(const std::string& name, const urdf::RobotModel& robot) {
  LegSampler sampler(robot, kSide, 10.0, 1);
  Task task{"random, " + name, robot, {}, false};
  for (std::size_t i = 0; i < kRandomPoses; ++i) task.soles.push_back(sampler.sole(sampler.any_angles()));
  return task;
}

bool is_solution(const Task& task, const Eigen::Isometry3d& goal, const LegAngles& angle_rad) {
  const kinematics::LegLimits limits = kinematics::leg_limits(task.robot, kSide);
  for (std::size_t i = 0; i < 6; ++i) {
    if (!(angle_rad[i] >= limits.lower_rad[i] - kinematics::kLimitTolerance_rad &&
          angle_rad[i] <= limits.upper_rad[i] + kinematics::kLimitTolerance_rad)) {
      return false;
    }
  }
  const Eigen::Isometry3d left = goal.inverse() * sole_of(task.robot, angle_rad);
  return left.translation().norm() < kProven && Eigen::AngleAxisd(left.linear()).angle() < kProven;
}

class Contestant {
 public:
  Contestant(const Task& task, std::unique_ptr<LegRival> rival)
      : task_(task), rival_(std::move(rival)), home_(LegSampler(task.robot, kSide, 0.0, 1).home()) {
    rival_->set_goals(task_.soles);
    answers_.resize(task_.soles.size());
  }
  void solve_all() {
    LegAngles start_rad = home_;
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      Answer& answer = answers_[i];
      answer.told = rival_->solve(i, start_rad, answer.angle_rad);
      if (task_.from_last && answer.told) start_rad = answer.angle_rad;
    }
  }
  [[nodiscard]] Json report(double taken_ns) const {
    std::size_t solved = 0;
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      if (answers_[i].told && is_solution(task_, task_.soles[i], answers_[i].angle_rad)) ++solved;
    }
    const auto count = static_cast<double>(answers_.size());
    return {{"ns", taken_ns / count}, {"solved", static_cast<double>(solved) / count}};
  }
  [[nodiscard]] const std::string& name() const noexcept { return rival_->name(); }

 private:
  struct Answer {
    bool told = false;
    LegAngles angle_rad{};
  };
  const Task& task_;
  std::unique_ptr<LegRival> rival_;
  LegAngles home_;
  std::vector<Answer> answers_;
};

std::vector<std::unique_ptr<LegRival>> rivals_for(const urdf::RobotModel& robot) {
  std::vector<std::unique_ptr<LegRival>> rivals;
  rivals.push_back(our_leg(robot, kSide));
  rivals.push_back(kdl_leg_lma(robot, kSide));
  rivals.push_back(kdl_leg_nr_jl(robot, kSide));
#ifdef GAITWAY_PINOCCHIO
  rivals.push_back(pinocchio_leg(robot, kSide, 1.0));
  rivals.push_back(pinocchio_leg(robot, kSide, 0.1));
#endif
  return rivals;
}

Json contest(const Task& task) {
  std::vector<std::unique_ptr<Contestant>> contestants;
  std::vector<std::function<void()>> turns;
  for (std::unique_ptr<LegRival>& rival : rivals_for(task.robot)) {
    contestants.push_back(std::make_unique<Contestant>(task, std::move(rival)));
    turns.emplace_back([contestant = contestants.back().get()] { contestant->solve_all(); });
  }
  const std::vector<double> taken_ns = median_turn_ns(task.from_last ? kTurnsOfWalk : kTurnsOfRandom, turns);
  Json result;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    result[contestants[i]->name()] = contestants[i]->report(taken_ns[i]);
  }
  return result;
}

// What a peer elsewhere needs of a task: the leg as joints in a row, where each begins, and the goals.
Json described(const Task& task) {
  const auto pose = [](const Eigen::Isometry3d& of) {
    const Eigen::Matrix4d m = of.matrix();
    return std::vector<double>(m.data(), m.data() + 16);  // column by column
  };
  Json joints = Json::array(), goals = Json::array();
  for (const int index : task.robot.legs[static_cast<std::size_t>(kSide)].joints) {
    const urdf::Joint& joint = task.robot.joints.at(static_cast<std::size_t>(index));
    joints.push_back({{"name", joint.name},
                      {"origin", pose(joint.origin)},
                      {"axis", std::vector<double>(joint.axis.data(), joint.axis.data() + 3)},
                      {"limits_rad", {joint.lower_rad, joint.upper_rad}},
                      {"home_rad", joint.home_rad}});
  }
  for (const Eigen::Isometry3d& sole : task.soles) goals.push_back(pose(sole));
  return {{"name", task.name},
          {"from_last", task.from_last},
          {"tolerance", kTolerance},
          {"proven", kProven},
          {"limit_tolerance_rad", kinematics::kLimitTolerance_rad},
          {"joints", joints},
          {"sole", pose(task.robot.feet[static_cast<std::size_t>(kSide)].sole)},
          {"goals", goals}};
}

int run(int argument_count, char** arguments) {
  const urdf::RobotModel shipped = urdf::load_robot(GAITWAY_HUMANOID22);
  const urdf::RobotModel offset = kinematics::test::make_robot(kinematics::test::offset_hip());
  const std::vector<Task> tasks{walk("humanoid22", shipped), walk("offset hips", offset),
                                random_poses("humanoid22", shipped), random_poses("offset hips", offset)};
  Json result;
  for (const Task& task : tasks) {
    if (argument_count > 1) {
      result.push_back(described(task));
    } else {
      result[task.name] = contest(task);
    }
  }
  if (argument_count > 1) {
    std::ofstream file(arguments[1]);
    file << result;
    return file.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  fmt::print("{}\n", result.dump(1));
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace gaitway::peers

int main(int argument_count, char** arguments) {
  try {
    return gaitway::peers::run(argument_count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "leg_ik_peers: {}\n", error.what());
    return EXIT_FAILURE;
  }
}
