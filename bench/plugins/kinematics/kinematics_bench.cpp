// Cost of one leg by both solvers, of the whole-body CoM, and of a whole batch with its tail.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "gaitway/kinematics/batch_solver.hpp"
#include "leg_sampler.hpp"
#include "test_robot.hpp"
#include "walking_plan.hpp"

namespace gaitway::kinematics {
namespace {

// Sole poses of a walk in the base frame, one every 10 ms.
std::vector<Eigen::Isometry3d> walking_soles(const urdf::RobotModel& model) {
  BatchSolver solver(model, SolverChoice::closed_form);
  const test::WalkingPlan walk(0.25);
  test::LegSampler sampler(model, urdf::Side::left, 0.0, 1);
  JointPlan joint_plan{};
  std::vector<Eigen::Isometry3d> soles;
  for (std::uint32_t sequence = 1; sequence <= 30; ++sequence) {
    if (!solver.solve(walk.batch(sequence), {}, joint_plan).solved()) return {};
    for (const auto& row : joint_plan.position) {
      if (&row == joint_plan.position + kBatchPoints) break;
      std::array<double, 6> angle_rad{};
      for (std::size_t i = 0; i < 6; ++i) angle_rad[i] = static_cast<double>(row[model.legs[0].joints[i]]);
      soles.push_back(sampler.sole(angle_rad));
    }
  }
  return soles;
}

template <typename Leg>
void solve_walk(benchmark::State& state, Leg& leg, const std::vector<Eigen::Isometry3d>& soles) {
  std::size_t i = 0;
  for (auto _ : state) {
    LegSolution solution = leg.solve(soles[i]);
    if (!solution.reached()) return state.SkipWithError("a pose of the walk is not reached");
    benchmark::DoNotOptimize(solution);
    i = i + 1 == soles.size() ? 0 : i + 1;
  }
}

void BM_ClosedFormLeg(benchmark::State& state) {
  const urdf::RobotModel model = test::make_robot();
  const ClosedFormLeg leg(recognise_leg(model, urdf::Side::left).geometry.value());
  solve_walk(state, leg, walking_soles(model));
}
BENCHMARK(BM_ClosedFormLeg);

void BM_KdlLegWarm(benchmark::State& state) {
  const urdf::RobotModel model = test::make_robot();
  KdlLeg leg(model, urdf::Side::left);
  solve_walk(state, leg, walking_soles(model));
}
BENCHMARK(BM_KdlLegWarm);

void BM_WholeBodyCom(benchmark::State& state) {
  const urdf::RobotModel model = test::make_robot();
  const BodyMass mass(model);
  test::LegSampler left(model, urdf::Side::left, 0.3, 1);
  const auto left_rad = left.angles();
  const auto right_rad = left.angles();
  for (auto _ : state) {
    benchmark::DoNotOptimize(left_rad);
    benchmark::DoNotOptimize(mass.com_m(left_rad, right_rad));
  }
}
BENCHMARK(BM_WholeBodyCom);

// Batches of a walk, 8 points and 140 of the tail; arguments: index of the solver's choice, whether the
// references lead by what the servos give way.
void BM_Batch(benchmark::State& state) {
  const auto choice = state.range(0) == 0 ? SolverChoice::closed_form : SolverChoice::kdl;
  urdf::RobotModel robot = test::make_robot();
  for (urdf::Joint& joint : robot.joints) joint.servo.stiffness_Nm_per_rad = 300.0;
  BatchSolver solver(robot, choice, state.range(1) != 0);
  const test::WalkingPlan walk(0.25, 0.3);
  std::vector<MotionPlan> plans;
  for (std::uint32_t sequence = 1; sequence <= 30; ++sequence) plans.push_back(walk.batch(sequence));
  JointPlan joint_plan{};
  const BaseOffset correction{{0.004, -0.003}, {0.01, 0.02}};
  std::size_t i = 0;
  for (auto _ : state) {
    if (!solver.solve(plans[i], correction, joint_plan).solved()) {
      return state.SkipWithError("a batch of the walk is not solved");
    }
    benchmark::DoNotOptimize(joint_plan);
    i = i + 1 == plans.size() ? 0 : i + 1;
  }
  state.SetLabel(std::string(state.range(0) == 0 ? "closed form" : "KDL") +
                 (state.range(1) == 0 ? "" : ", load compensated"));
}
BENCHMARK(BM_Batch)->Args({0, 0})->Args({0, 1})->Args({1, 0})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gaitway::kinematics
