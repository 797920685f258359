// Whole batches of a walk: accuracy at every point of batch and tail, corrections, failures by name, no
// allocation.
#include "gaitway/kinematics/batch_solver.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "test_robot.hpp"
#include "walking_plan.hpp"

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define GAITWAY_COUNT_ALLOCATIONS
extern "C" void* __libc_malloc(std::size_t size);
namespace {
std::atomic<long> allocations{0};
}
// Every allocation of this binary, also those inside third-party libraries.
extern "C" void* malloc(std::size_t size) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
#endif

namespace gaitway::kinematics {
namespace {

using test::link_poses;
using test::sole_pose;

using test::make_robot;
using test::walking_hip_height_m;
using test::WalkingPlan;

constexpr int kTail = 140;

struct Achieved {  // by the joint positions of one point, with the left sole where it is planned
  Eigen::Vector2d com_m;
  Eigen::Isometry3d right_sole;
  Eigen::Isometry3d base;
};

Achieved achieved(const urdf::RobotModel& model, const MotionPlan& plan, const JointPlan& joint_plan,
                  int point) {
  std::vector<double> angle_rad;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    angle_rad.push_back(static_cast<double>(joint_plan.position[point][i]));
  }
  Eigen::Isometry3d left = Eigen::Isometry3d::Identity();
  left.translate(Eigen::Map<const Eigen::Vector3d>(plan.foot_position[point][0]))
      .rotate(Eigen::AngleAxisd(plan.foot_yaw[point][0], Eigen::Vector3d::UnitZ()));
  Achieved result;
  result.base = left * sole_pose(model, urdf::Side::left, angle_rad).inverse();
  result.right_sole = result.base * sole_pose(model, urdf::Side::right, angle_rad);
  const auto poses = link_poses(model, angle_rad);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double mass_kg = 0.0;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    moment += model.links[i].mass_kg * (result.base * poses[i] * model.links[i].com_m);
    mass_kg += model.links[i].mass_kg;
  }
  result.com_m = (moment / mass_kg).head<2>();
  return result;
}

struct Errors {
  double batch_com_m = 0.0, tail_com_m = 0.0, foot_m = 0.0;
};

// Walks for 40 batches and returns the largest errors against the plan.
Errors walk_errors(const urdf::RobotModel& model, const WalkingPlan& walk, SolverChoice choice) {
  BatchSolver solver(model, choice);
  const auto joint_plan = std::make_unique<JointPlan>();
  Errors errors;
  for (std::uint32_t sequence = 1; sequence <= 40; ++sequence) {
    const MotionPlan plan = walk.batch(sequence, kTail);
    const BatchOutcome outcome = solver.solve(plan, {}, *joint_plan);
    EXPECT_TRUE(outcome.solved()) << "batch " << sequence << ": " << solver.describe(outcome);
    if (!outcome.solved()) return errors;
    for (int point = 0; point < kBatchPoints + kTail; ++point) {
      const Achieved is = achieved(model, plan, *joint_plan, point);
      const double com_error = (is.com_m - Eigen::Map<const Eigen::Vector2d>(plan.com[point])).norm();
      double& worst = point < kBatchPoints ? errors.batch_com_m : errors.tail_com_m;
      worst = std::max(worst, com_error);
      const Eigen::Map<const Eigen::Vector3d> right(plan.foot_position[point][1]);
      errors.foot_m = std::max(errors.foot_m, (is.right_sole.translation() - right).norm());
    }
  }
  return errors;
}

TEST(BatchSolver, KeepsTheComOnThePlanInBatchAndTail) {
  for (const auto& [speed, turn_rate] : {std::pair{0.25, 0.0}, std::pair{0.3, 0.0}, std::pair{0.2, 0.5},
                                         std::pair{-0.15, -0.3}, std::pair{0.0, 0.0}}) {
    const Errors errors = walk_errors(make_robot(), WalkingPlan(speed, turn_rate), SolverChoice::closed_form);
    EXPECT_LT(errors.batch_com_m, 0.1e-3) << speed << " m/s, " << turn_rate << " rad/s";
    EXPECT_LT(errors.tail_com_m, 0.3e-3) << speed << " m/s, " << turn_rate << " rad/s";
    EXPECT_LT(errors.foot_m, 1e-6) << "single precision of the joint plan";
    std::printf("%5.2f m/s %5.2f rad/s: batch %5.1f um, tail %5.1f um\n", speed, turn_rate,
                errors.batch_com_m * 1e6, errors.tail_com_m * 1e6);
  }
}

TEST(BatchSolver, GivesTheSamePlanWithTheGeneralSolver) {
  const urdf::RobotModel model = make_robot();
  BatchSolver closed_form(model, SolverChoice::closed_form);
  BatchSolver general(model, SolverChoice::kdl);
  const WalkingPlan walk(0.25, 0.2);
  const auto expected = std::make_unique<JointPlan>();
  const auto joint_plan = std::make_unique<JointPlan>();
  for (std::uint32_t sequence = 1; sequence <= 10; ++sequence) {
    ASSERT_TRUE(closed_form.solve(walk.batch(sequence), {}, *expected).solved());
    ASSERT_TRUE(general.solve(walk.batch(sequence), {}, *joint_plan).solved());
    for (int point = 0; point < kBatchPoints + kTail; ++point) {
      for (std::size_t i = 0; i < model.joints.size(); ++i) {
        ASSERT_NEAR(joint_plan->position[point][i], expected->position[point][i], 1e-5F);
      }
    }
  }
}

TEST(BatchSolver, KeepsTheComOnThePlanWithLegsWithoutAClosedForm) {
  for (const test::LegVariant& variant : test::general_variants()) {
    const urdf::RobotModel model = make_robot(variant);
    const WalkingPlan walk(0.2, 0.2, walking_hip_height_m(model));
    const Errors errors = walk_errors(model, walk, SolverChoice::automatic);
    EXPECT_LT(errors.batch_com_m, 0.1e-3);
    EXPECT_LT(errors.tail_com_m, 0.3e-3);
    EXPECT_LT(errors.foot_m, 1e-6);
  }
}

TEST(BatchSolver, GivesThePlanOfKdlWithLegsWithoutAClosedForm) {
  for (const test::LegVariant& variant : test::general_variants()) {
    const urdf::RobotModel model = make_robot(variant);
    const WalkingPlan walk(0.25, 0.2, walking_hip_height_m(model));
    BatchSolver kdl(model, SolverChoice::kdl), general(model, SolverChoice::automatic);
    const auto expected = std::make_unique<JointPlan>(), joint_plan = std::make_unique<JointPlan>();
    for (std::uint32_t sequence = 1; sequence <= 10; ++sequence) {
      ASSERT_TRUE(kdl.solve(walk.batch(sequence), {}, *expected).solved());
      ASSERT_TRUE(general.solve(walk.batch(sequence), {}, *joint_plan).solved());
      for (int point = 0; point < kBatchPoints + kTail; ++point) {
        for (std::size_t i = 0; i < model.joints.size(); ++i) {
          ASSERT_NEAR(joint_plan->position[point][i], expected->position[point][i], 1e-6F);
        }
      }
    }
  }
}

// No leap from one branch to another: the joints go on as they went, over all batches and tails of a walk.
TEST(BatchSolver, IsSmoothAlongAWalkWithLegsWithoutAClosedForm) {
  for (const test::LegVariant& variant : test::general_variants()) {
    const urdf::RobotModel model = make_robot(variant);
    const WalkingPlan walk(0.25, 0.2, walking_hip_height_m(model));
    BatchSolver solver(model, SolverChoice::automatic);
    auto joint_plan = std::make_unique<JointPlan>(), before = std::make_unique<JointPlan>();
    for (std::uint32_t sequence = 1; sequence <= 40; ++sequence) {
      ASSERT_TRUE(solver.solve(walk.batch(sequence), {}, *joint_plan).solved());
      for (int point = sequence == 1 ? 2 : 0; point < kBatchPoints + kTail; ++point) {
        const auto row = [&](int at) {
          return at < 0 ? before->position[kBatchPoints + at] : joint_plan->position[at];
        };
        for (std::size_t i = 0; i < 12; ++i) {
          ASSERT_NEAR(row(point)[i], 2.0F * row(point - 1)[i] - row(point - 2)[i], 0.03F)
              << "batch " << sequence << ", point " << point << ", joint " << i;
        }
      }
      std::swap(joint_plan, before);
    }
  }
}

TEST(BatchSolver, FillsThePlansHeadSupportAndTheJointsAtHome) {
  const urdf::RobotModel model = make_robot();
  BatchSolver solver(model, SolverChoice::automatic);
  const MotionPlan plan = WalkingPlan(0.2).batch(9, 123);
  const auto joint_plan = std::make_unique<JointPlan>();
  ASSERT_TRUE(solver.solve(plan, {}, *joint_plan).solved());
  EXPECT_EQ(joint_plan->sequence, 9u);
  EXPECT_EQ(joint_plan->joint_count, 22u);
  EXPECT_EQ(joint_plan->tail_count, 123u);
  for (int point = 0; point < kBatchPoints + 123; ++point) {
    EXPECT_EQ(joint_plan->support[point], plan.support[point]);
    for (std::size_t i = 12; i < 22; ++i) {
      EXPECT_EQ(joint_plan->position[point][i], static_cast<float>(model.joints[i].home_rad));
    }
  }
}

TEST(BatchSolver, ShiftsComAndTiltsBaseByTheCorrectionButEndsTheTailWithout) {
  const urdf::RobotModel model = make_robot();
  BatchSolver solver(model, SolverChoice::automatic);
  const double yaw = 0.4;
  MotionPlan plan = WalkingPlan(0.0).batch(1, kTail);
  for (int i = 0; i < kBatchPoints + kTail; ++i) {  // everything turned about the origin
    const Eigen::Rotation2Dd turn(yaw);
    Eigen::Map<Eigen::Vector2d>(plan.com[i]) = turn * Eigen::Map<Eigen::Vector2d>(plan.com[i]);
    plan.base_yaw[i] = yaw;
    for (int side = 0; side < 2; ++side) {
      Eigen::Map<Eigen::Vector2d> foot(plan.foot_position[i][side]);
      foot = turn * foot;
      plan.foot_yaw[i][side] = yaw;
    }
  }
  const BaseOffset correction{{0.010, -0.004}, {0.02, 0.04}};
  const auto joint_plan = std::make_unique<JointPlan>();
  const BatchOutcome outcome = solver.solve(plan, correction, *joint_plan);
  ASSERT_TRUE(outcome.solved()) << solver.describe(outcome);
  const auto offset_at = [&](int point) -> Eigen::Vector2d {
    return Eigen::Rotation2Dd(-yaw) * (achieved(model, plan, *joint_plan, point).com_m -
                                       Eigen::Map<const Eigen::Vector2d>(plan.com[point]));
  };
  EXPECT_LT((offset_at(3) - 0.5 * correction.com_m).norm(), 0.1e-3);
  EXPECT_LT((offset_at(7) - correction.com_m).norm(), 0.1e-3);
  EXPECT_LT((offset_at(60) - correction.com_m).norm(), 0.3e-3);
  EXPECT_LT(offset_at(kBatchPoints + kTail - 1).norm(), 0.1e-3);
  const auto up_at = [&](int point) -> Eigen::Vector3d {
    return Eigen::AngleAxisd(-yaw, Eigen::Vector3d::UnitZ()) *
           achieved(model, plan, *joint_plan, point).base.linear().col(2);
  };
  EXPECT_NEAR(up_at(7).x(), std::sin(0.04) * std::cos(0.02), 1e-6) << "positive pitch leans forward";
  EXPECT_NEAR(up_at(7).y(), -std::sin(0.02), 1e-6) << "positive roll leans to the right";
  EXPECT_NEAR(up_at(kBatchPoints + kTail - 1).z(), 1.0, 1e-12);
}

TEST(BatchSolver, NamesSidePointAndExcessOfAFootThatIsOutOfReach) {
  BatchSolver solver(make_robot(), SolverChoice::automatic);
  const auto joint_plan = std::make_unique<JointPlan>();
  MotionPlan plan = WalkingPlan(0.0).batch(1, kTail);
  plan.foot_position[5][1][2] = -0.20;
  BatchOutcome outcome = solver.solve(plan, {}, *joint_plan);
  ASSERT_FALSE(outcome.solved());
  EXPECT_EQ(outcome.point, 5);
  EXPECT_EQ(outcome.side, urdf::Side::right);
  EXPECT_EQ(outcome.leg.status, LegStatus::over_stretched);
  EXPECT_NEAR(outcome.leg.excess, 0.35 + 0.20 - 0.04 - 0.34, 0.01);
  EXPECT_EQ(
      solver.describe(outcome).find("point 6 of the batch, right foot: the leg is over-stretched by 17"), 0u)
      << solver.describe(outcome);

  plan = WalkingPlan(0.0).batch(1, kTail);
  plan.foot_yaw[50][0] = 1.2;  // between two placements of the base
  outcome = solver.solve(plan, {}, *joint_plan);
  ASSERT_FALSE(outcome.solved());
  EXPECT_EQ(outcome.point, 50);
  EXPECT_EQ(
      solver.describe(outcome).find("point 43 of the tail, left foot: joint 'left_hip_yaw' would be at 1.2"),
      0u)
      << solver.describe(outcome);
  EXPECT_TRUE(solver.solve(WalkingPlan(0.0).batch(1, kTail), {}, *joint_plan).solved())
      << "and goes on afterwards";
}

TEST(BatchSolver, RefusesNumbersThatAreNone) {
  BatchSolver solver(make_robot(), SolverChoice::automatic);
  const auto joint_plan = std::make_unique<JointPlan>();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const int point : {0, 7, 8, 50, kBatchPoints + kTail - 1}) {
    MotionPlan plan = WalkingPlan(0.1).batch(1, kTail);
    plan.com[point][1] = nan;
    EXPECT_FALSE(solver.solve(plan, {}, *joint_plan).solved()) << point;
    plan = WalkingPlan(0.1).batch(1, kTail);
    plan.hip_height[point] = nan;
    EXPECT_FALSE(solver.solve(plan, {}, *joint_plan).solved()) << point;
  }
  EXPECT_FALSE(solver.solve(WalkingPlan(0.1).batch(1), {{nan, 0.0}, {0.0, 0.0}}, *joint_plan).solved());
  EXPECT_FALSE(solver.solve(WalkingPlan(0.1).batch(1), {{0.0, 0.0}, {0.0, nan}}, *joint_plan).solved());
}

TEST(BatchSolver, RefusesATailLongerThanTheTopic) {
  BatchSolver solver(make_robot(), SolverChoice::automatic);
  const auto joint_plan = std::make_unique<JointPlan>();
  MotionPlan plan = WalkingPlan(0.1).batch(1, kTail);
  plan.tail_count = kMaxTailPoints + 1;
  const BatchOutcome outcome = solver.solve(plan, {}, *joint_plan);
  EXPECT_EQ(solver.describe(outcome), "motion_plan: tail_count is 201; at most 200 points are allowed");
}

TEST(BatchSolver, PlansTheBatchOfTheTickAndNoOther) {
  BatchSolver solver(make_robot(), SolverChoice::automatic), same(make_robot(), SolverChoice::automatic);
  const auto joint_plan = std::make_unique<JointPlan>(), expected = std::make_unique<JointPlan>();
  MotionPlan plan = WalkingPlan(0.1).batch(1, kTail);
  Correction correction{};
  correction.com_offset[0] = 0.01;
  correction.base_attitude_offset[1] = 0.02;
  ASSERT_TRUE(solver.plan_batch(plan.sequence, plan, correction, *joint_plan));
  ASSERT_TRUE(same.solve(plan, {{0.01, 0.0}, {0.0, 0.02}}, *expected).solved());
  EXPECT_EQ(joint_plan->sequence, plan.sequence);
  EXPECT_EQ(std::memcmp(joint_plan->position, expected->position, sizeof expected->position), 0);
  EXPECT_FALSE(solver.plan_batch(plan.sequence + 1, plan, correction, *joint_plan));
  EXPECT_EQ(joint_plan->sequence, 0U);
  plan.hip_height[3] = 2.0;
  EXPECT_THROW(solver.plan_batch(plan.sequence, plan, correction, *joint_plan), std::runtime_error);
}

TEST(BatchSolver, SolvesEveryLengthOfTail) {
  const urdf::RobotModel model = make_robot();
  const auto joint_plan = std::make_unique<JointPlan>();
  for (int tail = 0; tail <= kMaxTailPoints; ++tail) {
    BatchSolver solver(model, SolverChoice::automatic);
    const MotionPlan plan = WalkingPlan(0.25).batch(7, tail);
    const BatchOutcome outcome = solver.solve(plan, {}, *joint_plan);
    ASSERT_TRUE(outcome.solved()) << tail << ": " << solver.describe(outcome);
    for (int point = 0; point < kBatchPoints + tail; ++point) {
      const Achieved is = achieved(model, plan, *joint_plan, point);
      ASSERT_LT((is.com_m - Eigen::Map<const Eigen::Vector2d>(plan.com[point])).norm(), 0.3e-3)
          << tail << point;
    }
  }
}

TEST(BatchSolver, BatchesJoinSmoothly) {
  const urdf::RobotModel model = make_robot();
  BatchSolver solver(model, SolverChoice::automatic);
  const WalkingPlan walk(0.25, 0.3);
  auto joint_plan = std::make_unique<JointPlan>();
  ASSERT_TRUE(solver.solve(walk.batch(10), {}, *joint_plan).solved());
  for (std::uint32_t sequence = 11; sequence <= 50; ++sequence) {
    const auto next = std::make_unique<JointPlan>();
    ASSERT_TRUE(solver.solve(walk.batch(sequence), {}, *next).solved());
    // The tail's first point and the next batch's first point describe the same moment of the walk.
    for (std::size_t i = 0; i < model.joints.size(); ++i) {
      ASSERT_NEAR(joint_plan->position[kBatchPoints][i], next->position[0][i], 1e-3F) << sequence;
    }
    *joint_plan = *next;
  }
}

#ifdef GAITWAY_COUNT_ALLOCATIONS
TEST(BatchSolver, AllocatesNothing) {
  const urdf::RobotModel usual = make_robot(), general = make_robot(test::offset_hip());
  for (const auto& [model, choice] :
       {std::pair{&usual, SolverChoice::closed_form}, std::pair{&usual, SolverChoice::kdl},
        std::pair{&general, SolverChoice::automatic}}) {
    BatchSolver solver(*model, choice);
    const auto joint_plan = std::make_unique<JointPlan>();
    const auto plan =
        std::make_unique<MotionPlan>(WalkingPlan(0.2, 0.0, walking_hip_height_m(*model)).batch(3));
    plan->foot_position[100][0][2] = -0.3;  // and a failure
    const long before = allocations.load();
    const bool solved = solver.solve(*plan, {{0.003, 0.002}, {0.01, 0.01}}, *joint_plan).solved();
    const long after = allocations.load();
    EXPECT_FALSE(solved);
    EXPECT_EQ(after, before);
  }
}
#endif

// Nothing is left of a batch that was refused.
void expect_the_same_after_a_refusal(const urdf::RobotModel& model, const WalkingPlan& walk) {
  BatchSolver plain(model, SolverChoice::automatic), refused(model, SolverChoice::automatic);
  const auto expected = std::make_unique<JointPlan>(), solved = std::make_unique<JointPlan>();
  for (std::uint32_t sequence = 1; sequence < 30; ++sequence) {
    const auto plan = std::make_unique<MotionPlan>(walk.batch(sequence, kTail));
    Correction correction{};
    correction.com_offset[0] = 0.001 * (sequence % 7);
    ASSERT_TRUE(plain.plan_batch(sequence, *plan, correction, *expected, {}, nullptr));
    Correction another = correction;
    another.com_offset[0] += 0.01;
    auto other = std::make_unique<MotionPlan>(*plan);
    for (int i = 4; i < kBatchPoints + kTail; ++i) other->com[i][1] += 0.002 * std::min(1.0, (i - 3) / 10.0);
    ASSERT_TRUE(refused.plan_batch(sequence, *other, another, *solved, {}, nullptr));
    refused.go_on_from(sequence - 1);
    ASSERT_TRUE(refused.plan_batch(sequence, *plan, correction, *solved, {}, nullptr));
    for (int point = 0; point < kBatchPoints + kTail; ++point) {
      for (std::size_t joint = 0; joint < model.joints.size(); ++joint) {
        ASSERT_EQ(solved->position[point][joint], expected->position[point][joint])
            << "batch " << sequence << ", point " << point << ", joint " << joint;
      }
    }
  }
}

TEST(BatchSolver, GoesOnFromTheBatchBeforeOneThatWasRefused) {
  expect_the_same_after_a_refusal(make_robot(), WalkingPlan());
}

TEST(BatchSolver, GoesOnFromTheBatchBeforeOneThatWasRefusedWithLegsWithoutAClosedForm) {
  const urdf::RobotModel model = make_robot(test::offset_hip());
  expect_the_same_after_a_refusal(model, WalkingPlan(0.25, 0.0, walking_hip_height_m(model)));
}

}  // namespace
}  // namespace gaitway::kinematics
