// Ways out of motions: from every batch, within every limit, and home.
#include "gaitway/motion/motion_planner.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "motion_fixture.hpp"

namespace gaitway::motion {
namespace {

using trajectory::MotionExit;
using trajectory::MotionTable;
using trajectory::MotionWay;

// The rows that are played when the motion is left after `batches`.
std::vector<std::span<const float>> rows_out(const MotionTable& table, std::size_t batches) {
  constexpr std::size_t kBatch = kBatchPoints;
  const MotionExit& exit = table.exits[batches];
  std::vector<std::span<const float>> rows;
  for (std::size_t i = 0; i <= exit.go_on_batches * kBatch; ++i)
    rows.push_back(table.path.row(batches * kBatch + i));
  if (exit.way < 0) return rows;
  const MotionWay& way = table.ways[static_cast<std::size_t>(exit.way)];
  for (std::size_t i = 0; i < way.size(); ++i) rows.push_back(way.row(i));
  return rows;
}

class WayOut : public ::testing::TestWithParam<std::string> {};

TEST_P(WayOut, LeadsHomeFromEveryBatchWithoutAJump) {
  const urdf::RobotModel& robot = humanoid22();
  const MotionTable table = prepare_motion(robot, shipped(GetParam()), {}).table;
  const JointLimits limits(robot, {});
  ASSERT_GT(table.ways.size(), 0U);
  for (std::size_t b = 1; b <= table.batch_count(); ++b) {
    const auto rows = rows_out(table, b);
    EXPECT_LE(rows.size() - 1, static_cast<std::size_t>(kMaxTailPoints));
    for (std::size_t i = 1; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < table.joint_count; ++j) {
        const double speed = static_cast<double>(std::abs(rows[i][j] - rows[i - 1][j])) / facts::kSlot_s;
        EXPECT_LE(speed, 1.001 * limits.speed_rad_per_s[static_cast<Eigen::Index>(j)])
            << robot.joints[j].name << ", left after " << b << " batches, point " << i;
      }
    }
    for (const float offset : rows.back())
      EXPECT_NEAR(offset, 0.0F, 2e-3F) << "left after " << b << " batches";
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, WayOut, ::testing::Values("bow", "squat", "kick"),
                         [](const auto& chosen) { return chosen.param; });

// On the ground the joints stop within a third of a second, on the feet the robot stands.
TEST(WayOutOfTheGround, StaysThereUntilBothFeetStand) {
  const MotionTable table = prepare_motion(humanoid22(), shipped("get_up_front"), {}).table;
  EXPECT_TRUE(table.on_ground);
  EXPECT_EQ(table.lies_on, trajectory::LyingSide::front);
  EXPECT_EQ(table.ways[static_cast<std::size_t>(table.exits[5].way)].points.back().support,
            trajectory::kNothingStands);
  EXPECT_LE(table.exit_points(5), 32U);
  const std::size_t last = table.batch_count() - 3;
  const MotionExit& exit = table.exits[last];
  EXPECT_TRUE(exit.way < 0 || table.ways[static_cast<std::size_t>(exit.way)].points.back().support == 2U);
  EXPECT_EQ(table.path.points.back().support, 2U);
}

TEST(WayOut, IsMissingWhereARobotStaysOnOneFootForTooLong) {
  const Motion motion = of_keys(
      "  - {name: shift, hold_s: 0.2, pelvis: {hip_height_m: 0.345, over: left}}\n"
      "  - {name: lift, contact: left, hold_s: 2.5, right_foot: {up_m: 0.03}}\n"
      "  - {name: put down, contact: left, hold_s: 0.1, right_foot: {}}\n"
      "  - {name: home, from: home}\n");
  try {
    static_cast<void>(prepare_motion(humanoid22(), motion, {}));
    FAIL() << "prepared";
  } catch (const MotionError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("a safe tail lasts 2.00 s at most"));
  }
}

}  // namespace
}  // namespace gaitway::motion
