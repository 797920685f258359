// The parts of vision on their own: map, boxes, memory of targets, poses of tags, sizes as people write them.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "gaitway/input/complaint.hpp"
#include "gaitway/vision/obstacle_boxes.hpp"
#include "gaitway/vision/tag_pose.hpp"
#include "gaitway/vision/tag_sizes.hpp"
#include "standing_robot.hpp"

namespace gaitway::vision::testing {
namespace {

CellSighting obstacle_at(const Eigen::Vector2d& place_m, double height_m = 0.2) {
  return {.what = CellSighting::What::obstacle, .height_m = height_m, .middle_m = place_m, .points = 10};
}

void see(HeightMap& map, const CellSighting& sighting, int cell, int times) {
  for (int i = 0; i < times; ++i) map.see(cell, sighting, 1'000'000'000 + i);
}

TEST(HeightMap, OneSightingDecidesNothing) {
  HeightMap map(0.04);
  const int cell = map.cell_at(0.5, 0.1);
  see(map, obstacle_at({0.5, 0.1}), cell, 1);
  EXPECT_EQ(map.state(cell), CellState::unknown);
  see(map, obstacle_at({0.5, 0.1}), cell, 2);
  EXPECT_EQ(map.state(cell), CellState::obstacle);
  EXPECT_NEAR(map.obstacle_m(cell).x(), 0.5, 1e-3);
  EXPECT_NEAR(map.height_m(cell), 0.2, 1e-3);
}

TEST(HeightMap, AnObstacleStaysUntilItWasSeenFreeForLong) {
  HeightMap map(0.04);
  const int cell = map.cell_at(0.5, 0.1);
  see(map, obstacle_at({0.5, 0.1}), cell, 20);
  see(map, {.what = CellSighting::What::ground}, cell, 9);
  EXPECT_EQ(map.state(cell), CellState::obstacle);
  map.forget(100'000'000'000);
  EXPECT_EQ(map.state(cell), CellState::obstacle) << "obstacles are not forgotten";
  see(map, {.what = CellSighting::What::ground}, cell, 1);
  EXPECT_EQ(map.state(cell), CellState::free);
  map.forget(100'000'000'000);
  EXPECT_EQ(map.state(cell), CellState::unknown);
}

TEST(HeightMap, WhatBeginsToShowIsNotForgotten) {
  HeightMap map(0.04);
  const int cell = map.cell_at(0.5, 0.1);
  see(map, obstacle_at({0.5, 0.1}), cell, 1);
  map.forget(900'000'000);
  see(map, obstacle_at({0.5, 0.1}), cell, 2);
  EXPECT_EQ(map.state(cell), CellState::obstacle);
}

TEST(HeightMap, WhatIsSeenThroughIsUnknownThen) {
  HeightMap map(0.04);
  const int cell = map.cell_at(0.5, 0.1);
  see(map, obstacle_at({0.5, 0.1}), cell, 4);
  see(map, {.what = CellSighting::What::seen_through}, cell, 10);
  EXPECT_EQ(map.state(cell), CellState::unknown) << "its ground was not seen";
}

TEST(HeightMap, GoesWithTheRobotInWholeCells) {
  HeightMap map(0.04);
  see(map, obstacle_at({0.5, 0.1}), map.cell_at(0.5, 0.1), 4);
  map.centre({1.2, 0.0});
  EXPECT_EQ(map.state(map.cell_at(0.5, 0.1)), CellState::obstacle);
  EXPECT_EQ(map.cell_at(-1.5, 0.0), -1);
  map.centre({9.0, 0.0});
  map.centre({0.5, 0.0});
  EXPECT_EQ(map.state(map.cell_at(0.5, 0.1)), CellState::unknown) << "what leaves the map is gone";
  EXPECT_EQ(map.cell_at(std::nan(""), 0.0), -1);
}

TEST(ObstacleBoxes, ATurnedBoxIsOneBox) {
  HeightMap map(0.04);
  const Eigen::Rotation2Dd turn(0.5);
  for (double u = -0.2; u <= 0.2; u += 0.01) {
    for (double v = -0.1; v <= 0.1; v += 0.01) {
      const Eigen::Vector2d at = Eigen::Vector2d(1.0, 0.2) + turn * Eigen::Vector2d(u, v);
      see(map, obstacle_at(at), map.cell_at(at.x(), at.y()), 3);
    }
  }
  const std::vector<Box> boxes = boxes_in(map, {0.0, 0.0});
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_NEAR(boxes[0].middle_m.x(), 1.0, 0.03);
  EXPECT_NEAR(boxes[0].middle_m.y(), 0.2, 0.03);
  EXPECT_NEAR(boxes[0].size_m.maxCoeff(), 0.4, 0.05);
  EXPECT_NEAR(boxes[0].size_m.minCoeff(), 0.2, 0.05);
  EXPECT_NEAR(std::remainder(boxes[0].yaw_rad - 0.5, std::acos(0.0)), 0.0, 0.15);
}

TEST(ObstacleBoxes, TwoWallsThatMeetAreTwoBoxes) {
  HeightMap map(0.04);
  for (double along = 0.0; along < 1.2; along += 0.01) {
    for (const Eigen::Vector2d& at : {Eigen::Vector2d(0.3 + along, 0.6), Eigen::Vector2d(1.5, 0.6 - along)}) {
      see(map, obstacle_at(at), map.cell_at(at.x(), at.y()), 3);
    }
  }
  double area_m2 = 0.0;
  for (const Box& box : boxes_in(map, {0.0, 0.0})) area_m2 += box.size_m.prod();
  EXPECT_LT(area_m2, 0.3) << "the room between the walls is no obstacle";
}

// Of a block of points, cell by cell as one pair shows them, thrice.
void see_block(HeightMap& map, const Eigen::Isometry2d& pose, const Eigen::Vector2d& size_m) {
  struct Sum {
    int points = 0;
    Eigen::Vector2d first = Eigen::Vector2d::Zero();
    Eigen::Vector3d second = Eigen::Vector3d::Zero();
  };
  std::map<int, Sum> cells;
  constexpr int kParts = 100;
  for (int i = 0; i < kParts * kParts; ++i) {
    const Eigen::Vector2d share((i % kParts + 0.5) / kParts - 0.5, (i / kParts + 0.5) / kParts - 0.5);
    const Eigen::Vector2d at = pose * share.cwiseProduct(size_m);
    Sum& sum = cells[map.cell_at(at.x(), at.y())];
    ++sum.points;
    sum.first += at;
    sum.second += Eigen::Vector3d(at.x() * at.x(), at.y() * at.y(), at.x() * at.y());
  }
  for (const auto& [cell, sum] : cells) {
    CellSighting seen = obstacle_at(sum.first / sum.points);
    const Eigen::Vector2d& mean = seen.middle_m;
    seen.spread_m2 = sum.second / sum.points -
                     Eigen::Vector3d(mean.x() * mean.x(), mean.y() * mean.y(), mean.x() * mean.y());
    see(map, seen, cell, 3);
  }
}

// Wherever its sides lie in their cells; and from where one of them is seen so aslant that it shows no face.
TEST(ObstacleBoxes, ASideIsWhereWhatTheCellsShowEnds) {
  for (int step = 0; step < 8; ++step) {
    for (const double eye_y_m : {0.0, 0.3}) {
      HeightMap map(0.04);
      Eigen::Isometry2d pose = Eigen::Isometry2d::Identity();
      pose.translation() = Eigen::Vector2d(1.1, 0.005 * step);
      see_block(map, pose, {0.24, 0.34});
      const std::vector<Box> boxes = boxes_in(map, {0.0, eye_y_m});
      ASSERT_EQ(boxes.size(), 1U);
      EXPECT_NEAR(boxes[0].middle_m.y(), pose.translation().y(), 0.008) << step << " " << eye_y_m;
      EXPECT_NEAR(boxes[0].size_m.maxCoeff(), 0.34, 0.012) << step << " " << eye_y_m;
    }
  }
}

TEST(HeightMap, KnowsHowWideWhatACellShowsIs) {
  HeightMap map(0.04);
  Eigen::Isometry2d pose = Eigen::Isometry2d::Identity();
  pose.translation() = Eigen::Vector2d(0.51, 0.1);
  see_block(map, pose, {0.02, 0.03});
  const Eigen::Vector3d spread_m2 = map.spread_m2(map.cell_at(0.51, 0.1));
  EXPECT_NEAR(std::sqrt(12.0 * spread_m2.x()), 0.02, 0.001);
  EXPECT_NEAR(std::sqrt(12.0 * spread_m2.y()), 0.03, 0.001);
}

TEST(ObstacleBoxes, NoiseChangesNothing) {
  ObstacleList list;
  const Box box{{1.0, 0.2}, 0.3, {0.4, 0.2}, 0.3};
  EXPECT_TRUE(list.renew({box}));
  Box moved = box;
  moved.middle_m.x() += 0.01;
  EXPECT_FALSE(list.renew({moved}));
  EXPECT_EQ(list.boxes()[0].middle_m.x(), 1.0);
  moved.middle_m.x() += 0.05;
  EXPECT_TRUE(list.renew({moved}));
}

TagSighting sighting(int id, const Eigen::Vector3d& place_m) {
  return {.id = id,
          .position_m = place_m,
          .covariance_m2 = 1e-4 * Eigen::Matrix3d::Identity(),
          .orientation = Eigen::Quaterniond::Identity(),
          .knows_orientation = true,
          .size_m = 0.1};
}

TEST(TargetMemory, IsToldFromTheSecondSightingOn) {
  TargetMemory memory(10'000'000'000);
  SeenTargets told{};
  memory.see(sighting(4, {1, 2, 0.5}), 1'000'000'000);
  memory.write(told, 0);
  EXPECT_EQ(told.count, 0U);
  memory.see(sighting(4, {1.004, 2, 0.5}), 1'080'000'000);
  memory.write(told, 0);
  ASSERT_EQ(told.count, 1U);
  EXPECT_EQ(told.seen_ns[0], 1'080'000'000);
  EXPECT_NEAR(told.position[0][0], 1.002, 0.001);
  EXPECT_LT(told.covariance[0][0], 1e-4);
  memory.forget(12'000'000'000);
  memory.write(told, 0);
  EXPECT_EQ(told.count, 0U);
}

TEST(TargetMemory, ATargetThatWasCarriedOffIsWhereItIsNow) {
  TargetMemory memory(10'000'000'000);
  for (int i = 0; i < 10; ++i) memory.see(sighting(4, {1, 2, 0.5}), 1'000'000'000 + i * 80'000'000);
  memory.see(sighting(4, {1.5, 2, 0.5}), 1'800'000'000);
  SeenTargets told{};
  memory.write(told, 0);
  ASSERT_EQ(told.count, 1U);
  EXPECT_NEAR(told.position[0][0], 1.5, 0.01);
}

TEST(TargetMemory, WhatIsNoNumberIsNotTakenIn) {
  TargetMemory memory(100'000'000'000);
  const double none = std::nan("");
  std::vector<TagSighting> wrong(5, sighting(4, {1, 2, 0.5}));
  wrong[0].position_m.y() = none;
  wrong[1].covariance_m2(0, 1) = none;
  wrong[2].orientation.x() = none;
  wrong[3].covariance_m2.setZero();
  wrong[4].size_m = none;
  memory.see(wrong[1], 900'000'000);
  for (int i = 0; i < 10; ++i) memory.see(sighting(4, {1, 2, 0.5}), 1'000'000'000 + i * 80'000'000);
  for (const TagSighting& one : wrong) memory.see(one, 1'800'000'000);
  SeenTargets told{};
  memory.write(told, 0);
  ASSERT_EQ(told.count, 1U);
  EXPECT_EQ(told.seen_ns[0], 1'720'000'000);
  EXPECT_NEAR(told.position[0][1], 2.0, 1e-6);
  EXPECT_GT(told.covariance[0][0], 0.0);
  EXPECT_NEAR(told.orientation[0][0], 1.0, 1e-6);
}

TEST(TargetMemory, TheOldestMakesRoom) {
  TargetMemory memory(100'000'000'000);
  for (int id = 0; id < 40; ++id) {
    for (int i = 0; i < 2; ++i) memory.see(sighting(id, {1, 2, 0.5}), 1'000'000'000 + id * 1'000'000 + i);
  }
  SeenTargets told{};
  memory.write(told, 0);
  EXPECT_EQ(told.count, kMaxTargets);
  EXPECT_EQ(std::ranges::count(told.id, 39U), 1);
  EXPECT_EQ(std::ranges::count(told.id, 0U), 0);
}

const RectifiedGeometry kGeometry{
    .focal_px = 250.0, .cx_px = 160.0, .cy_px = 120.0, .base_m = 0.06, .width = 320, .height = 240};

FoundTag seen_tag(const Eigen::Isometry3d& pose, double size_m, double eye_x_m) {
  FoundTag tag{.id = 1};
  const double h = 0.5 * size_m;
  const Eigen::Vector3d corners[]{{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    tag.corner_px[i] = kGeometry.project(pose * corners[i] - Eigen::Vector3d(eye_x_m, 0, 0));
  }
  return tag;
}

TEST(TagPose, IsExactWithoutNoise) {
  for (const double turn_rad : {-0.9, -0.3, 0.2, 0.8}) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitY()) *
                    Eigen::AngleAxisd(std::acos(-1.0), Eigen::Vector3d::UnitX()).toRotationMatrix();
    pose.translation() = Eigen::Vector3d(0.2, -0.1, 1.4);
    const FoundTag left = seen_tag(pose, 0.15, 0.0), right = seen_tag(pose, 0.15, 0.06);
    for (const bool both : {false, true}) {
      const auto found = tag_pose(kGeometry, &left, both ? &right : nullptr, 0.15, 0.2, 1.0);
      ASSERT_TRUE(found) << turn_rad << both;
      EXPECT_LT((found->pose.translation() - pose.translation()).norm(), 1e-4);
      EXPECT_LT(Eigen::AngleAxisd(found->pose.linear().transpose() * pose.linear()).angle(), 1e-3);
    }
  }
}

TEST(TagPose, CornersOfNoSquareAreNoTag) {
  FoundTag tag{.id = 1};
  tag.corner_px = {{{100, 140}, {150, 141}, {170, 100}, {101, 60}}};
  EXPECT_FALSE(tag_pose(kGeometry, &tag, nullptr, 0.15, 0.2, 0.5));
}

TEST(TagSizes, AsPeopleWriteThem) {
  const std::vector<TagSize> sizes = tag_sizes_in(" 3: 0.2 m, 17:80 mm ");
  ASSERT_EQ(sizes.size(), 2U);
  EXPECT_EQ(sizes[1].id, 17);
  EXPECT_NEAR(sizes[1].size_m, 0.08, 1e-9);
  EXPECT_TRUE(tag_sizes_in("").empty());
  for (const char* const wrong :
       {"3", "3: 0.2", "3: x m", "587: 0.2 m", "-1: 0.2 m", "3: 1 mm", "3: 0.2 m, 3: 0.1 m"}) {
    EXPECT_THROW((void)tag_sizes_in(wrong), input::InputError) << wrong;
  }
}

TEST(CameraHistory, KnowsWhereTheCameraWasBetweenTwoTicks) {
  StandingRobot robot;
  robot.speed = {0.3, 0.1, 0.5};
  CameraHistory history(robot.model(), robot.model().link_index(robot.camera().link),
                        robot.camera().left_in_link);
  EXPECT_FALSE(history.at(0));
  for (std::int64_t now_ns = 0; now_ns <= 2'000'000'000; now_ns += 10'000'000) {
    history.add(robot.joints(now_ns), robot.estimate(now_ns));
  }
  for (const std::int64_t at_ns : {1'200'000'000LL, 1'503'700'000LL, 1'999'000'000LL}) {
    const auto found = history.at(at_ns);
    ASSERT_TRUE(found);
    const Eigen::Isometry3d truth = robot.camera_pose(at_ns);
    EXPECT_LT((found->pose.translation() - truth.translation()).norm(), 2e-4);
    EXPECT_LT(Eigen::AngleAxisd(found->pose.linear().transpose() * truth.linear()).angle(), 1e-4);
  }
  EXPECT_FALSE(history.at(900'000'000)) << "longer ago than what is remembered";
  EXPECT_FALSE(history.at(2'100'000'000)) << "not yet";
}

}  // namespace
}  // namespace gaitway::vision::testing
