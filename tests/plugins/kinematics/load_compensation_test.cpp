// References that lead by what the servos give way: how much, from where, and without a jump.
#include "gaitway/kinematics/load_compensation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "gaitway/kinematics/batch_solver.hpp"
#include "walking_plan.hpp"

namespace gaitway::kinematics {
namespace {

constexpr int kLoadTail = 60;

class Compensated : public ::testing::Test {
 protected:
  // The robot's stand; `sequence` counts on.
  MotionPlan stand(std::uint32_t sequence) const {
    MotionPlan plan = test::WalkingPlan(0.0, 0.0, robot_.hip_height_m).batch(sequence, kLoadTail);
    for (int i = 0; i < kBatchPoints + kLoadTail; ++i) {
      plan.com[i][0] = plan.zmp[i][0] = 0.01;
      plan.com[i][1] = plan.zmp[i][1] = 0.0;
      plan.support[i] = 2;
      for (std::size_t side = 0; side < 2; ++side) {
        plan.foot_position[i][side][0] = plan.foot_position[i][side][2] = 0.0;
        plan.foot_position[i][side][1] = side == 0 ? 0.05 : -0.05;
      }
    }
    return plan;
  }
  double lead_rad(int point, int joint) const {
    return static_cast<double>(with_->position[point][joint]) -
           static_cast<double>(without_->position[point][joint]);
  }
  void solve(const MotionPlan& plan, std::span<const double> reference_rad = {}) {
    ASSERT_TRUE(compensated_.solve(plan, {}, *with_, reference_rad).solved());
    ASSERT_TRUE(plain_.solve(plan, {}, *without_).solved());
  }

  // With joints that are quick enough for plans that are made for their load alone.
  static urdf::RobotModel quick_robot() {
    urdf::RobotModel robot = urdf::load_robot(GAITWAY_HUMANOID22_DIRECTORY);
    for (urdf::Joint& joint : robot.joints) {
      joint.velocity_limit_rad_per_s = 20.0;
      joint.count_rad = 0.002;
    }
    return robot;
  }

  const urdf::RobotModel robot_ = quick_robot();
  BatchSolver compensated_{robot_, SolverChoice::closed_form, true};
  BatchSolver plain_{robot_, SolverChoice::closed_form, false};
  std::unique_ptr<JointPlan> with_ = std::make_unique<JointPlan>(), without_ = std::make_unique<JointPlan>();
  const int knee_ = robot_.legs[0].joints[3];
};

// Half the weight less what lies below the knee, on a lever of the thigh's length times the sine of its tilt.
TEST_F(Compensated, StandingTheKneesLeadByHalfTheWeight) {
  for (std::uint32_t sequence = 1; sequence <= 20; ++sequence) solve(stand(sequence));
  const double tilt_rad = 0.5 * robot_.joints[static_cast<std::size_t>(knee_)].home_rad;
  const double torque_Nm = 9.81 * (0.5 * robot_.total_mass_kg() - 0.75) * 0.17 * std::sin(tilt_rad);
  EXPECT_NEAR(std::abs(lead_rad(7, knee_)),
              torque_Nm / robot_.joints[static_cast<std::size_t>(knee_)].servo.stiffness_Nm_per_rad, 0.0012);
  EXPECT_LT(lead_rad(7, knee_), 0.0) << "the reference is straighter than the knee is to be";
}

TEST_F(Compensated, LeadsAfterARefusedBatchAsIfItHadNotBeenSolved) {
  BatchSolver refused(robot_, SolverChoice::closed_form, true);
  const auto solved = std::make_unique<JointPlan>();
  for (std::uint32_t sequence = 1; sequence <= 20; ++sequence) {
    const MotionPlan plan = stand(sequence);
    solve(plan);
    MotionPlan other = plan;
    for (int i = 4; i < kBatchPoints + kLoadTail; ++i) other.zmp[i][1] += 0.02;
    ASSERT_TRUE(refused.solve(other, {}, *solved).solved());
    refused.go_on_from(sequence - 1);
    ASSERT_TRUE(refused.solve(plan, {}, *solved).solved());
    for (int point = 0; point < kBatchPoints + kLoadTail; ++point) {
      ASSERT_EQ(solved->position[point][knee_], with_->position[point][knee_])
          << "batch " << sequence << ", point " << point;
    }
  }
}

TEST_F(Compensated, TheLeadComesInWithoutAJumpAndStaysInTheTail) {
  double before = 0.0;
  for (std::uint32_t sequence = 1; sequence <= 10; ++sequence) {
    solve(stand(sequence));
    for (int point = 0; point < kBatchPoints; ++point) {
      EXPECT_LT(std::abs(lead_rad(point, knee_) - before), 3e-4)
          << "batch " << sequence << " point " << point;
      before = lead_rad(point, knee_);
    }
    EXPECT_NEAR(lead_rad(kBatchPoints + kLoadTail - 1, knee_), before, 1e-4);
  }
  EXPECT_GT(std::abs(before), 0.003);
}

TEST_F(Compensated, ASuccessorGoesOnFromWhereTheReferencesAre) {
  for (std::uint32_t sequence = 1; sequence <= 20; ++sequence) solve(stand(sequence));
  std::vector<double> reference;
  for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
    reference.push_back(static_cast<double>(with_->position[kBatchPoints - 1][j]));
  }
  BatchSolver successor(robot_, SolverChoice::closed_form, true);
  ASSERT_TRUE(successor.solve(stand(21), {}, *with_, reference).solved());
  EXPECT_NEAR(static_cast<double>(with_->position[0][knee_]), reference[static_cast<std::size_t>(knee_)],
              3e-4);
}

// The leg in the air hangs: its knee leads far less than the one that bears the robot.
TEST_F(Compensated, TheLegInTheAirIsNotLoaded) {
  MotionPlan plan = stand(1);
  for (std::uint32_t sequence = 1; sequence <= 20; ++sequence) {
    plan = stand(sequence);
    for (int i = 0; i < kBatchPoints + kLoadTail; ++i) {
      plan.com[i][1] = plan.zmp[i][1] = 0.045;
      plan.support[i] = 0;
      plan.foot_position[i][1][2] = 0.02;
    }
    solve(plan);
  }
  const double bearing = std::abs(lead_rad(7, knee_)),
               hanging = std::abs(lead_rad(7, robot_.legs[1].joints[3]));
  EXPECT_GT(bearing, 5.0 * hanging);
}

// Where the weight stays on its foot, leads change from batch to batch as smoothly as within one.
TEST_F(Compensated, AWalkHasNoJumpsAtTheBordersOfBatches) {
  const test::WalkingPlan walk(0.2);
  std::vector<double> before;
  double at_borders = 0.0, within = 0.0;
  int support_before = -1;
  for (std::uint32_t sequence = 1; sequence <= 40; ++sequence) {
    const MotionPlan plan = walk.batch(sequence, kLoadTail);
    solve(plan);
    for (int point = 0; point < kBatchPoints; ++point) {
      std::vector<double> lead;
      for (const int joint : robot_.legs[0].joints) lead.push_back(lead_rad(point, joint));
      if (plan.support[point] == support_before) {
        double& largest = point == 0 ? at_borders : within;
        for (std::size_t i = 0; i < lead.size(); ++i)
          largest = std::max(largest, std::abs(lead[i] - before[i]));
      }
      before = lead;
      support_before = plan.support[point];
    }
  }
  EXPECT_LT(at_borders, 1.5 * within);
  EXPECT_LT(within, 0.02);
}

// A motion's references lead by what it takes beyond the stand: they come on top of the stand's, once.
TEST_F(Compensated, AMotionsOffsetsComeOnTopOfTheStandsReferences) {
  const auto before = std::make_unique<JointPlan>(), during = std::make_unique<JointPlan>();
  MotionPlan plan = stand(1);
  for (std::uint32_t sequence = 1; sequence <= 10; ++sequence) {  // until the lead is in
    plan.sequence = sequence;
    ASSERT_TRUE(compensated_.solve(plan, {}, *before).solved());
  }
  plan.sequence = 11;
  plan.motion = 1;
  const auto posture = std::make_unique<PosturePlan>();
  *posture = PosturePlan{};
  posture->sequence = 11;
  posture->joint_count = static_cast<std::uint32_t>(robot_.joints.size());
  posture->tail_count = plan.tail_count;
  posture->stand_com[0] = 0.01;
  posture->stand_hip_height = robot_.hip_height_m;
  posture->stand_foot[0][1] = 0.05;
  posture->stand_foot[1][1] = -0.05;
  for (int i = 0; i < kBatchPoints + kLoadTail; ++i) {
    posture->offset[i][knee_] = 0.001F * static_cast<float>(i + 1);
    plan.support[i] =
        i < 4 ? 0 : 3;  // the stand's leads are those of both feet, whatever the motion stands on
    plan.zmp[i][1] = 0.05;
    plan.hip_height[i] = 0.2;
  }
  ASSERT_TRUE(compensated_.solve(plan, {}, *during, {}, posture.get()).solved());
  for (int i = 0; i < kBatchPoints + kLoadTail; ++i) {
    for (int j = 0; j < static_cast<int>(robot_.joints.size()); ++j) {
      const float offset = j == knee_ ? posture->offset[i][j] : 0.0F;
      ASSERT_NEAR(during->position[i][j], before->position[kBatchPoints - 1][j] + offset, 2e-5F)
          << i << ' ' << j;
    }
    EXPECT_EQ(during->support[i], i < 4 ? 0 : 2);
  }
  // And the stand goes on after it as if nothing had been.
  ASSERT_TRUE(compensated_.solve(stand(12), {}, *during).solved());
  for (int j = 0; j < static_cast<int>(robot_.joints.size()); ++j) {
    EXPECT_NEAR(during->position[0][j], before->position[kBatchPoints - 1][j], 2e-5F) << j;
  }
}

TEST_F(Compensated, AMotionFromTheGroundIsPlayedFromTheHomeAngles) {
  MotionPlan plan = stand(5);
  plan.motion = 1;
  const auto posture = std::make_unique<PosturePlan>();
  *posture = PosturePlan{};
  posture->sequence = 5;
  posture->joint_count = static_cast<std::uint32_t>(robot_.joints.size());
  posture->tail_count = plan.tail_count;
  posture->from_home = 1;
  posture->offset[3][knee_] = -0.2F;
  ASSERT_TRUE(compensated_.solve(plan, {}, *with_, {}, posture.get()).solved());
  EXPECT_NEAR(with_->position[3][knee_], robot_.joints[static_cast<std::size_t>(knee_)].home_rad - 0.2, 1e-6);
  EXPECT_NEAR(with_->position[4][knee_], robot_.joints[static_cast<std::size_t>(knee_)].home_rad, 1e-6);
  posture->sequence = 4;
  const BatchOutcome other = compensated_.solve(plan, {}, *with_, {}, posture.get());
  EXPECT_EQ(other.kind, BatchOutcome::Kind::no_posture);
}

}  // namespace
}  // namespace gaitway::kinematics
