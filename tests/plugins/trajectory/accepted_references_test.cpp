// Where the references are when a batch begins: in the batch before it, in a safe tail, after its end.
#include "gaitway/trajectory/fall_posture.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace gaitway::trajectory {
namespace {

// Point i of joint j is at i + 0.1 j.
std::unique_ptr<JointPlan> plan_of(std::uint32_t sequence, std::uint32_t tail_count) {
  auto plan = std::make_unique<JointPlan>();
  plan->sequence = sequence;
  plan->tail_count = tail_count;
  plan->joint_count = 2;
  for (int i = 0; i < kMaxPoints; ++i) {
    for (int j = 0; j < 2; ++j) plan->position[i][j] = static_cast<float>(i) + 0.1F * static_cast<float>(j);
  }
  return plan;
}

TEST(AcceptedReferences, AreTheLastTwoPointsThatHaveBeenPlayed) {
  AcceptedReferences references;
  EXPECT_FALSE(references.before(5)) << "nothing was accepted";
  references.take(*plan_of(4, 20), 4);
  const auto before = [&](std::uint32_t sequence) {
    const auto found = references.before(sequence);
    return found ? std::pair(found->before_rad[0], found->at_rad[0]) : std::pair(-1.0, -1.0);
  };
  EXPECT_EQ(before(4), std::pair(-1.0, -1.0)) << "it has not begun";
  EXPECT_EQ(before(5), std::pair(6.0, 7.0)) << "the batch";
  EXPECT_EQ(before(6), std::pair(14.0, 15.0)) << "its tail";
  EXPECT_EQ(before(7), std::pair(22.0, 23.0));
  EXPECT_EQ(before(8), std::pair(27.0, 27.0)) << "the tail's end, at rest";
  EXPECT_FLOAT_EQ(static_cast<float>(references.before(5)->at_rad[1]), 7.1F);
}

TEST(AcceptedReferences, APlanThatWasRefusedChangesNothing) {
  AcceptedReferences references;
  references.take(*plan_of(4, 20), 4);
  references.take(*plan_of(5, 20), 4);
  references.take(*plan_of(0, 0), 4);
  EXPECT_EQ(references.before(6)->at_rad[0], 15.0);
}

}  // namespace
}  // namespace gaitway::trajectory
