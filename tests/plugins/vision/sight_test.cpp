// The whole of vision over ray-traced pictures: what is where, how exactly, and the same each time.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <span>

#include "gaitway/vision/vision.hpp"
#include "watching_robot.hpp"

namespace gaitway::vision::testing {
namespace {

const Box* nearest_box(const Vision& vision, const Eigen::Vector2d& to_m) {
  const Box* nearest = nullptr;
  for (const Box& box : vision.obstacles()) {
    if (nearest == nullptr || (box.middle_m - to_m).norm() < (nearest->middle_m - to_m).norm())
      nearest = &box;
  }
  return nearest;
}

TEST(Sight, FreeGroundIsFreeAndTheRestUnknown) {
  WatchingRobot robot;
  robot.watch(4);
  int free = 0, obstacles = 0;
  const Eigen::Vector2d eye = robot.camera_m();
  for (int cell = 0; cell < kMapSide * kMapSide; ++cell) {
    if (robot.vision().map().state(cell) == CellState::obstacle) ++obstacles;
    if (robot.vision().map().state(cell) != CellState::free) continue;
    ++free;
    EXPECT_GT(robot.vision().map().middle_of(cell).x(), eye.x()) << "nothing behind the camera has been seen";
    EXPECT_NEAR(robot.vision().map().height_m(cell), 0.0, 0.08);
  }
  EXPECT_EQ(obstacles, 0);
  EXPECT_GT(free, 400);
  EXPECT_EQ(robot.vision().fault(), Fault::none);
}

TEST(Sight, ABoxIsAnObstacleWhereItStands) {
  WatchingRobot robot;
  robot.scene.boxes.push_back({{1.0, 0.1, 0.1}, {0.2, 0.3, 0.2}, 0.0});
  robot.watch(6);
  const Box* const box = nearest_box(robot.vision(), {1.0, 0.1});
  ASSERT_NE(box, nullptr);
  EXPECT_EQ(robot.vision().obstacles().size(), 1U);
  EXPECT_NEAR(box->middle_m.x(), 1.0, 0.04);
  EXPECT_NEAR(box->middle_m.y(), 0.1, 0.03);
  EXPECT_NEAR(box->height_m, 0.2, 0.03);
}

TEST(Sight, ABoxThatComesIntoViewLateIsAnObstacle) {
  WatchingRobot robot;
  robot.wait(40'000'000'000);
  robot.scene.boxes.push_back({{1.0, 0.1, 0.1}, {0.2, 0.3, 0.2}, 0.0});
  robot.watch(6);
  EXPECT_NE(nearest_box(robot.vision(), {1.0, 0.1}), nullptr);
}

TEST(Sight, WhatIsBehindABoxIsUnknown) {
  WatchingRobot robot;
  robot.scene.boxes.push_back({{0.9, 0.0, 0.25}, {0.1, 0.6, 0.5}, 0.0});
  robot.watch(6);
  const int behind = robot.vision().map().cell_at(1.25, 0.0);
  EXPECT_EQ(robot.vision().map().state(behind), CellState::unknown);
}

TEST(Sight, GroundWithoutTextureIsUnknown) {
  WatchingRobot robot;
  robot.scene.ground_contrast = 0.0;
  robot.watch(4);
  for (int cell = 0; cell < kMapSide * kMapSide; ++cell) {
    ASSERT_NE(robot.vision().map().state(cell), CellState::free);
  }
  EXPECT_EQ(robot.vision().fault(), Fault::few_matches);
}

TEST(Sight, ABoxThatIsTakenAwayIsFreeOnlyOnceItIsSeen) {
  WatchingRobot robot;
  robot.scene.boxes.push_back({{1.0, 0.0, 0.1}, {0.2, 0.2, 0.2}, 0.0});
  robot.watch(8);
  ASSERT_EQ(robot.vision().obstacles().size(), 1U);
  robot.head_pitch_rad(-0.3);  // looks over it: nothing says that it is gone
  robot.scene.boxes.clear();
  robot.watch(8);
  EXPECT_EQ(robot.vision().obstacles().size(), 1U);
  robot.head_pitch_rad(0.35);
  robot.watch(16);
  EXPECT_TRUE(robot.vision().obstacles().empty());
  EXPECT_EQ(robot.vision().map().state(robot.vision().map().cell_at(1.0, 0.0)), CellState::free);
}

TEST(Sight, ATagIsWhereItHangs) {
  WatchingRobot robot;
  robot.head_pitch_rad(0.0);
  robot.scene.tags.push_back(facing_tag(7, {1.2, 0.15, 0.45}, 0.3));
  robot.watch(5);
  SeenTargets seen{};
  robot.vision().write(seen);
  ASSERT_EQ(seen.count, 1U);
  EXPECT_EQ(seen.id[0], 7U);
  EXPECT_EQ(seen.kind[0], seen_targets::kind::tag);
  EXPECT_NEAR(seen.position[0][0], 1.2, 0.02);
  EXPECT_NEAR(seen.position[0][1], 0.15, 0.01);
  EXPECT_NEAR(seen.position[0][2], 0.45, 0.01);
  const Eigen::Quaterniond turn(seen.orientation[0][0], seen.orientation[0][1], seen.orientation[0][2],
                                seen.orientation[0][3]);
  EXPECT_LT(turn.angularDistance(Eigen::Quaterniond(robot.scene.tags[0].pose.linear())), 0.15);
  EXPECT_GT(seen.covariance[0][0], 0.0);
}

TEST(Sight, TheSamePicturesGiveTheSameBits) {
  const auto run = [] {
    WatchingRobot robot;
    robot.scene.boxes.push_back({{1.1, -0.1, 0.1}, {0.2, 0.3, 0.2}, 0.4});
    robot.scene.tags.push_back(facing_tag(3, {1.5, 0.3, 0.4}, -0.2));
    robot.speed({0.2, 0.0, 0.0});
    robot.watch(6);
    auto map = std::make_unique<GroundMap>();
    robot.vision().write(*map);
    SeenTargets seen{};
    robot.vision().write(seen);
    return std::pair(std::move(map), seen);
  };
  const auto first = run(), second = run();
  EXPECT_EQ(std::memcmp(first.first.get(), second.first.get(), sizeof(GroundMap)), 0);
  EXPECT_EQ(std::memcmp(&first.second, &second.second, sizeof(SeenTargets)), 0);
}

TEST(Sight, ASuccessorKnowsWhatItsPredecessorKnew) {
  WatchingRobot robot;
  robot.scene.boxes.push_back({{1.0, 0.1, 0.1}, {0.2, 0.3, 0.2}, 0.0});
  robot.watch(6);
  std::vector<std::byte> room(65536);
  StateWriter writer(room);
  robot.vision().save(writer);
  Vision successor(robot.model(), robot.camera(), {});
  StateReader reader(std::span<std::byte>(room).first(writer.size()));
  successor.restore(reader);
  EXPECT_EQ(reader.remaining(), 0U);
  EXPECT_EQ(successor.obstacles().size(), 1U);
  for (int cell = 0; cell < kMapSide * kMapSide; ++cell) {
    ASSERT_EQ(successor.map().state(cell), robot.vision().map().state(cell));
  }
}

}  // namespace
}  // namespace gaitway::vision::testing
