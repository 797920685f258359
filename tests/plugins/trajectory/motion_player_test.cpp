// Playing a table: the path, the tail of every batch, ways out, and files of tables.
#include "gaitway/trajectory/motion_player.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>

#include "gaitway/trajectory/motion_table.hpp"

namespace gaitway::trajectory {
namespace {

using ::testing::HasSubstr;

// Two joints; the first one's offset counts the points, of the path from 0, of the way out from 100.
MotionWay counted(std::size_t points, float from, std::uint64_t support) {
  MotionWay way;
  for (std::size_t i = 0; i < points; ++i) {
    MotionPoint point;
    point.com_m = {0.01, 0.02};
    point.hip_height_m = 0.35;
    point.foot_m = {{{0.0, 0.05, 0.0}, {0.0, -0.05, 0.03}}};
    point.support = support;
    way.points.push_back(point);
    way.offset_rad.push_back(from + static_cast<float>(i));
    way.offset_rad.push_back(-1.0F);
  }
  return way;
}

// Three batches. After the first, a way out of one batch; after the second, on to the end.
MotionTable table(const std::string& name, bool on_ground = false) {
  MotionTable table;
  table.name = name;
  table.description = "counts";
  table.robot_digest = 7;
  table.joint_count = 2;
  table.on_ground = on_ground;
  table.path = counted(25, 0.0F, on_ground ? kNothingStands : 2);
  table.ways = {counted(8, 100.0F, on_ground ? kNothingStands : 2)};
  table.exits = {{0, -1}, {0, 0}, {1, -1}, {0, -1}};
  table.exits[0] = {1, 0};
  return table;
}

struct Stage {
  explicit Stage(const MotionTable& motion) : player({motion}) {}
  void batch() { player.plan(++sequence, 0, *plan, *posture); }
  [[nodiscard]] float first(std::size_t point) const { return posture->offset[point][0]; }
  [[nodiscard]] gaitway::MotionState state() const {
    gaitway::MotionState state{};
    player.tell(state);
    return state;
  }

  MotionPlayer player;
  std::uint32_t sequence = 0;
  std::unique_ptr<MotionPlan> plan = std::make_unique<MotionPlan>();
  std::unique_ptr<PosturePlan> posture = std::make_unique<PosturePlan>();
};

TEST(MotionPlayer, PlaysThePathWithTheWayOutOfEachBatchAsItsTail) {
  Stage stage(table("count"));
  EXPECT_FALSE(stage.player.find("other").has_value());
  stage.player.start(*stage.player.find("count"), {}, {});
  stage.batch();
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(stage.first(i), static_cast<float>(i + 1));
  ASSERT_EQ(stage.plan->tail_count, 8U);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(stage.first(8 + i), 100.0F + static_cast<float>(i));
  stage.batch();
  for (std::size_t i = 0; i < 16; ++i)
    EXPECT_EQ(stage.first(i), static_cast<float>(i + 9)) << "on to the end";
  EXPECT_NEAR(stage.state().time, 0.16, 1e-12);
  stage.batch();
  EXPECT_EQ(stage.first(7), 24.0F);
  EXPECT_EQ(stage.first(15), 24.0F) << "a batch at least, at rest";
  EXPECT_FALSE(stage.player.plays());
  EXPECT_EQ(stage.state().result, static_cast<std::uint32_t>(MotionResult::finished));
  EXPECT_EQ(stage.state().ended, 1U);
}

TEST(MotionPlayer, IsLeftAlongTheTailOfTheBatchBefore) {
  Stage stage(table("count"));
  stage.player.start(0, {}, {});
  stage.batch();
  const float promised = stage.first(8);
  stage.player.leave();
  stage.batch();
  EXPECT_EQ(stage.first(0), promised);
  EXPECT_EQ(stage.first(7), 107.0F);
  EXPECT_FALSE(stage.player.plays());
  EXPECT_EQ(stage.state().result, static_cast<std::uint32_t>(MotionResult::left));
}

TEST(MotionPlayer, PlaysWhereTheRobotStands) {
  Stage stage(table("count"));
  const Pose2 middle{1.0, 2.0, std::numbers::pi / 2.0};
  stage.player.start(0, {middle, 0.03, 0.36, 0.1}, {});
  stage.batch();
  EXPECT_NEAR(stage.plan->com[0][0], 1.0 - 0.02, 1e-12);
  EXPECT_NEAR(stage.plan->com[0][1], 2.0 + 0.01, 1e-12);
  EXPECT_NEAR(stage.plan->foot_position[0][1][0], 1.05, 1e-12);
  EXPECT_EQ(stage.plan->foot_position[0][1][2], 0.03);
  EXPECT_NEAR(stage.posture->stand_com[1], 2.03, 1e-12);
  EXPECT_NEAR(stage.posture->stand_foot[0][0], 0.95, 1e-12);
  EXPECT_EQ(stage.plan->motion, 1U);
}

// From wherever the joints are, smoothly; and who leaves on the ground stays there.
TEST(MotionPlayer, GoesToTheFirstPostureOfAMotionOnTheGround) {
  Stage stage(table("up", true));
  const std::array<double, 2> from{1.0, -1.0};
  stage.player.start(0, {}, from);
  float before = 1.0F;
  int batches = 0;
  for (; stage.state().state == static_cast<std::uint32_t>(MotionStage::approach) && batches < 40;
       ++batches) {
    stage.batch();
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_LE(stage.first(i), before + 1e-6F);
      EXPECT_LT(before - stage.first(i), 0.021F);
      before = stage.first(i);
    }
    EXPECT_EQ(stage.plan->support[0], kNothingStands);
  }
  EXPECT_GT(batches, 10);
  EXPECT_NEAR(before, 0.0F, 1e-6F);
  stage.batch();
  EXPECT_EQ(stage.first(0), 1.0F);
  stage.player.leave();
  stage.batch();
  EXPECT_FALSE(stage.player.plays());
  EXPECT_TRUE(stage.player.lies());
}

class TableFile : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }
  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(read_motion_table(file));
    } catch (const MotionTableError& error) {
      return error.what();
    }
    return "read";
  }
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / ("gaitway_motion_tables_" + std::to_string(getpid()));
  const std::filesystem::path file = folder / "count.motion";
};

TEST_F(TableFile, IsReadAsItWasWritten) {
  write_motion_table(table("count", true), file);
  const MotionTable read = read_motion_table(file);
  EXPECT_EQ(read.name, "count");
  EXPECT_EQ(read.robot_digest, 7U);
  EXPECT_TRUE(read.on_ground);
  EXPECT_FALSE(read.lies_on.has_value());
  EXPECT_EQ(read.path.offset_rad, table("count").path.offset_rad);
  EXPECT_EQ(read.ways.at(0).offset_rad, table("count").ways[0].offset_rad);
  EXPECT_EQ(read.exits.at(2).go_on_batches, 1U);
  EXPECT_EQ(motion_table_files(folder), std::vector{file});
  EXPECT_TRUE(motion_table_files(folder / "none").empty());
}

TEST_F(TableFile, HoldsWhereTheMotionBegins) {
  for (const LyingSide side : {LyingSide::front, LyingSide::back, LyingSide::left, LyingSide::right}) {
    MotionTable lying = table("count", true);
    lying.lies_on = side;
    write_motion_table(lying, file);
    const MotionTable read = read_motion_table(file);
    EXPECT_TRUE(read.on_ground);
    EXPECT_EQ(read.lies_on, side);
  }
  write_motion_table(table("count"), file);
  EXPECT_FALSE(read_motion_table(file).on_ground);
}

TEST_F(TableFile, IsRefusedWhereverItIsCutOffOrWrong) {
  write_motion_table(table("count"), file);
  const auto size = std::filesystem::file_size(file);
  for (std::uintmax_t left = 0; left < size; left += 41) {
    write_motion_table(table("count"), file);
    std::filesystem::resize_file(file, left);
    EXPECT_THAT(refusal(), HasSubstr("gaitway motion prepare")) << left;
  }
  MotionTable wrong = table("count");
  wrong.exits[1].way = 1;
  write_motion_table(wrong, file);
  EXPECT_THAT(refusal(), HasSubstr("a way out leads nowhere"));
  wrong = table("count", true);
  wrong.lies_on = LyingSide{4};
  write_motion_table(wrong, file);
  EXPECT_THAT(refusal(), HasSubstr("where it begins is not known"));
  wrong = table("count");
  wrong.path.offset_rad[5] = std::nanf("");
  write_motion_table(wrong, file);
  EXPECT_THAT(refusal(), HasSubstr("not those of a motion"));
}

}  // namespace
}  // namespace gaitway::trajectory
