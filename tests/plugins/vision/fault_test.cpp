// What is wrong with the cameras is said by its name, at once, and nothing is seen by pictures that are no
// good.
#include <gtest/gtest.h>

#include <algorithm>

#include "watching_robot.hpp"

namespace gaitway::vision::testing {
namespace {

// A robot that has seen a box, and its map from then.
class Faults : public ::testing::Test {
 protected:
  Faults() {
    robot.scene.boxes.push_back({{1.1, 0.0, 0.1}, {0.2, 0.3, 0.2}, 0.0});
    robot.scene.tags.push_back(facing_tag(5, {1.6, 0.4, 0.4}, 0.0));
    robot.watch(6);
    EXPECT_EQ(robot.vision().fault(), Fault::none);
    known = robot.vision().obstacles().size();
    EXPECT_GE(known, 1U);
    seen_ns = robot.vision().mapped_ns();
  }

  VisionState state() {
    VisionState now{};
    robot.vision().write(now, 0, 0);
    return now;
  }
  // Map and obstacles are what they were.
  void expect_blind(Fault fault) {
    EXPECT_EQ(robot.vision().fault(), fault);
    EXPECT_EQ(state().state, vision_state::state::blind);
    EXPECT_EQ(robot.vision().obstacles().size(), known);
    EXPECT_GT(state().text[0], 0);
  }
  void expect_recovery(int pairs) {
    robot.spoil = nullptr;
    robot.exposure = {};
    robot.watch(pairs);
    EXPECT_EQ(robot.vision().fault(), Fault::none);
    EXPECT_EQ(state().state, vision_state::state::sees);
    EXPECT_GT(robot.vision().mapped_ns(), seen_ns);
  }

  WatchingRobot robot;
  std::size_t known = 0;  // obstacles: the box, and the tag's board
  std::int64_t seen_ns = 0;
};

TEST_F(Faults, NoPictures) {
  robot.wait(300'000'000);
  EXPECT_EQ(robot.vision().fault(), Fault::none) << "one dropped pair is no fault";
  robot.wait(300'000'000);
  expect_blind(Fault::no_pictures);
  EXPECT_EQ(robot.vision().mapped_ns(), seen_ns);
  expect_recovery(2);
}

TEST_F(Faults, NoneEver) {
  WatchingRobot other;
  other.wait(600'000'000);
  EXPECT_EQ(other.vision().fault(), Fault::no_pictures);
}

TEST_F(Faults, LatePictures) {
  robot.spoil = [](TakenPair& taken) { taken.pair.stamp_ns -= 200'000'000; };
  robot.watch(2);
  expect_blind(Fault::late_pictures);
  EXPECT_EQ(robot.vision().mapped_ns(), seen_ns);
  expect_recovery(2);
}

TEST_F(Faults, FrozenPictures) {
  std::vector<std::uint8_t> kept;
  robot.spoil = [&kept](TakenPair& taken) {
    if (kept.empty()) kept = taken.right;
    taken.right = kept;
    taken.refer();
  };
  robot.watch(3);
  expect_blind(Fault::frozen_pictures);
  expect_recovery(3);
}

TEST_F(Faults, DroppedPairsAreCounted) {
  robot.spoil = [](TakenPair& taken) { taken.pair.number += 4; };
  robot.watch(1);
  EXPECT_EQ(state().dropped, 4U);
}

TEST_F(Faults, DarkAndBrightAndDeadCameras) {
  const auto check = [this](std::size_t side, double gain, double noise, Fault fault) {
    robot.exposure = {};
    robot.exposure.gain[side] = gain;
    robot.exposure.noise = noise;
    const std::int64_t before_ns = robot.vision().mapped_ns();
    robot.watch(1);
    EXPECT_EQ(robot.vision().fault(), fault);
    EXPECT_EQ(robot.vision().mapped_ns(), before_ns);
    EXPECT_EQ(robot.vision().obstacles().size(), known);
    EXPECT_EQ(state().state, vision_state::state::impaired) << "the other one still finds tags";
  };
  check(0, 0.05, 2.0, Fault::left_dark);
  check(1, 0.05, 2.0, Fault::right_dark);
  check(0, 40.0, 2.0, Fault::left_bright);
  check(1, 40.0, 2.0, Fault::right_bright);
  for (const bool left : {true, false}) {
    robot.exposure = {};
    robot.spoil = [left](TakenPair& taken) {
      std::ranges::fill(left ? taken.left : taken.right, std::uint8_t{0});
    };
    robot.watch(1);
    EXPECT_EQ(robot.vision().fault(), left ? Fault::left_dead : Fault::right_dead);
  }
  expect_recovery(4);
}

TEST_F(Faults, OneCameraStillFindsTags) {
  robot.head_pitch_rad(0.0);
  robot.watch(4);
  robot.spoil = [](TakenPair& taken) { std::ranges::fill(taken.left, std::uint8_t{0}); };
  robot.watch(2);
  SeenTargets seen{};
  robot.vision().write(seen);
  ASSERT_EQ(seen.count, 1U);
  EXPECT_EQ(seen.seen_ns[0], seen.stamp_ns);
  EXPECT_NEAR(seen.position[0][0], 1.6, 0.05);
  EXPECT_NEAR(seen.position[0][1], 0.4, 0.03);
}

TEST_F(Faults, ExchangedCameras) {
  robot.spoil = [](TakenPair& taken) {
    std::swap(taken.left, taken.right);
    taken.refer();
  };
  robot.watch(8);
  expect_blind(Fault::cameras_exchanged);
  expect_recovery(6);
}

TEST_F(Faults, TheWrongSize) {
  robot.spoil = [](TakenPair& taken) {
    taken.pair.width = 240;
    taken.pair.height = 320;
  };
  robot.watch(1);
  expect_blind(Fault::wrong_size);
  expect_recovery(1);
}

TEST_F(Faults, TooLittleInCommon) {
  robot.scene.boxes.clear();
  robot.scene.ground_contrast = 0.0;
  robot.watch(2);
  EXPECT_EQ(robot.vision().fault(), Fault::few_matches);
  EXPECT_EQ(robot.vision().obstacles().size(), known)
      << "what was there stays there until it is seen to be gone";
}

TEST_F(Faults, ARobotThatLiesLeavesItsMapAlone) {
  robot.fallen(true);
  robot.watch(3);
  EXPECT_EQ(robot.vision().mapped_ns(), seen_ns);
  EXPECT_EQ(state().state, vision_state::state::impaired);
}

// It may lie a step from where it stood, and odometry does not know.
TEST_F(Faults, WhatItSawBeforeAFallIsForgottenWhenItIsUpAgain) {
  ASSERT_FALSE(robot.vision().obstacles().empty());
  robot.fallen(true);
  robot.watch(3);
  EXPECT_FALSE(robot.vision().obstacles().empty()) << "until it is up again, that is what is told";
  robot.fallen(false);
  robot.scene.boxes.clear();
  robot.wait(1'000'000'000);
  EXPECT_TRUE(robot.vision().obstacles().empty()) << "also where there are no pictures any more";
  robot.watch(3);
  for (const Box& box : robot.vision().obstacles()) {
    EXPECT_GT((box.middle_m - Eigen::Vector2d(1.1, 0.0)).norm(), 0.3)
        << "but for the tag's board, which is there: " << box.middle_m.transpose();
  }
}

// One degree about each axis of either camera.
class TurnedCamera : public ::testing::TestWithParam<Eigen::Vector3d> {};

TEST_P(TurnedCamera, IsSaid) {
  WatchingRobot robot;
  robot.scene.boxes.push_back({{1.3, 0.3, 0.1}, {0.2, 0.3, 0.2}, 0.0});
  robot.turn_right_camera(GetParam());
  robot.watch(14);
  EXPECT_EQ(robot.vision().fault(), Fault::cameras_misaligned);
  EXPECT_TRUE(robot.vision().obstacles().empty()) << "no obstacles out of a wrong calibration";
}

INSTANTIATE_TEST_SUITE_P(EachAxis, TurnedCamera,
                         ::testing::Values(Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(-1, 0, 0),
                                           Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, -1, 0),
                                           Eigen::Vector3d(0, 0, 1.5)));

// One look was odd; since then there is nothing that it could be judged by.
TEST(WronglySuspectedCameras, SeeAgainWhereLittleIsClear) {
  WatchingRobot robot;
  robot.turn_right_camera({1.0, 0.0, 0.0});
  robot.watch(1);
  robot.turn_right_camera(Eigen::Vector3d::Zero());
  robot.scene.ground_contrast = 14.0;  // distances show, single corners do not
  robot.exposure.noise = 3.0;
  robot.watch(1);
  VisionState state{};
  robot.vision().write(state, 0, 0);
  EXPECT_EQ(state.state, vision_state::state::impaired) << "said while the map waits";
  const std::int64_t odd_ns = robot.vision().mapped_ns();
  robot.watch(14);
  EXPECT_GT(robot.vision().mapped_ns(), odd_ns);
  EXPECT_EQ(robot.vision().fault(), Fault::none);
  robot.vision().write(state, 0, 0);
  EXPECT_EQ(state.state, vision_state::state::sees);
}

TEST(AlignmentWatch, AFaultIsOverLongAfterTheLastEvidence) {
  const Alignment misaligned{.verdict = Alignment::Verdict::misaligned}, nothing{};
  AlignmentWatch watch;
  watch.judge(misaligned, {});
  EXPECT_TRUE(watch.is_suspected());
  EXPECT_EQ(watch.fault(), Fault::none);
  watch.judge(misaligned, {});
  EXPECT_EQ(watch.fault(), Fault::cameras_misaligned);
  for (int pair = 0; pair < 60; ++pair) watch.judge(nothing, {});
  EXPECT_EQ(watch.fault(), Fault::cameras_misaligned) << "some seconds without a clear view say nothing";
  watch.judge(misaligned, {});
  for (int pair = 0; pair < 60; ++pair) watch.judge(nothing, {});
  EXPECT_EQ(watch.fault(), Fault::cameras_misaligned);
  for (int pair = 0; pair < 60; ++pair) watch.judge(nothing, {});
  EXPECT_EQ(watch.fault(), Fault::none);
  EXPECT_FALSE(watch.is_suspected());
}

TEST(AlignmentWatch, AShiftOfTheGroundIsForgottenAsWell) {
  const GroundShift shifted{.median_px = 4.0, .spread_px = 0.3, .points = 4000}, unseen{};
  AlignmentWatch watch;
  for (int pair = 0; pair < 5; ++pair) watch.judge({}, shifted);
  EXPECT_EQ(watch.fault(), Fault::cameras_misaligned);
  for (int pair = 0; pair < 120; ++pair) watch.judge({}, unseen);
  EXPECT_FALSE(watch.is_suspected());
  watch.judge({}, shifted);
  EXPECT_TRUE(watch.is_suspected()) << "at once, when it shows again";
}

}  // namespace
}  // namespace gaitway::vision::testing
