// Cost of one leg by each solver, of the whole-body CoM, and of a whole batch with its tail.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
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

// From the posture of the sample before.
void BM_GeneralLegWarm(benchmark::State& state) {
  const urdf::RobotModel model = test::make_robot();
  const GeneralLeg leg(model, urdf::Side::left);
  struct Warm {
    LegSolution solve(const Eigen::Isometry3d& sole) {
      const LegSolution solution = leg.solve(sole, last_rad);
      last_rad = solution.angle_rad;
      return solution;
    }
    const GeneralLeg& leg;
    std::array<double, 6> last_rad;
  } warm{leg, test::LegSampler(model, urdf::Side::left, 0.0, 1).home()};
  solve_walk(state, warm, walking_soles(model));
}
BENCHMARK(BM_GeneralLegWarm);

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

urdf::RobotModel robot_with(const test::LegVariant& legs) {
  urdf::RobotModel robot = test::make_robot(legs);
  for (urdf::Joint& joint : robot.joints) joint.servo.stiffness_Nm_per_rad = 300.0;
  return robot;
}

// Of the processor, for this thread: what others take from it meanwhile does not count.
double processor_time_us() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

// Batches of a walk, 8 points and 140 of the tail, by the solver of that choice. Counts how long each takes.
void solve_batches(benchmark::State& state, const test::LegVariant& legs, SolverChoice choice,
                   bool compensate_load) {
  const urdf::RobotModel robot = robot_with(legs);
  BatchSolver solver(robot, choice, compensate_load);
  const test::WalkingPlan walk(0.25, 0.3, test::walking_hip_height_m(robot));
  std::vector<MotionPlan> plans;
  for (std::uint32_t sequence = 1; sequence <= 30; ++sequence) plans.push_back(walk.batch(sequence));
  JointPlan joint_plan{};
  const BaseOffset correction{{0.004, -0.003}, {0.01, 0.02}};
  std::vector<double> batch_us;
  batch_us.reserve(1U << 20U);
  std::size_t i = 0;
  for (auto _ : state) {
    const double begin_us = processor_time_us();
    if (!solver.solve(plans[i], correction, joint_plan).solved()) {
      return state.SkipWithError("a batch of the walk is not solved");
    }
    benchmark::DoNotOptimize(joint_plan);
    batch_us.push_back(processor_time_us() - begin_us);
    i = i + 1 == plans.size() ? 0 : i + 1;
  }
  std::ranges::sort(batch_us);
  const auto quantile = [&](double share) {
    return batch_us[static_cast<std::size_t>(share * static_cast<double>(batch_us.size() - 1))];
  };
  state.counters["p50_us"] = quantile(0.5);
  state.counters["p99_us"] = quantile(0.99);
}

test::LegVariant ordered(test::LegVariant legs, const std::array<std::size_t, 6>& order) {
  legs.order = order;
  return legs;
}

void batch_benchmark(const char* name, const test::LegVariant& legs, SolverChoice choice,
                     bool compensate_load) {
  benchmark::RegisterBenchmark(name, [=](benchmark::State& state) {
    solve_batches(state, legs, choice, compensate_load);
  })->Unit(benchmark::kMicrosecond);
}

const bool kBatchBenchmarks = [] {
  const test::LegVariant usual, offset_hip = test::offset_hip();
  const test::LegVariant roll_first = ordered(usual, test::kAnkleRollFirst);
  const test::LegVariant both = ordered(offset_hip, test::kAnkleRollFirst);
  constexpr auto kAuto = SolverChoice::automatic;
  batch_benchmark("Batch/usual_leg", usual, kAuto, false);
  batch_benchmark("Batch/usual_leg/load_compensated", usual, kAuto, true);
  batch_benchmark("Batch/offset_hip", offset_hip, kAuto, false);
  batch_benchmark("Batch/offset_hip/load_compensated", offset_hip, kAuto, true);
  batch_benchmark("Batch/ankle_roll_first/load_compensated", roll_first, kAuto, true);
  batch_benchmark("Batch/offset_hip_ankle_roll_first/load_compensated", both, kAuto, true);
  batch_benchmark("Batch/as_g1/load_compensated", test::general_variants()[2], kAuto, true);
  batch_benchmark("Batch/offset_hip/kdl/load_compensated", offset_hip, SolverChoice::kdl, true);
  return true;
}();

}  // namespace
}  // namespace gaitway::kinematics
