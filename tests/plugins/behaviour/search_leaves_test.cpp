// FindTag over topics that tests write: where it looks, which way it turns, and when it gives up.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scripted_robot.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::NodeStatus;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

// One that turns as it is asked, whose head scans, and that stands as soon as it is not asked to walk.
class SearchingRobot : public ScriptedRun {
 public:
  explicit SearchingRobot(std::string_view nodes) : ScriptedRun(nodes) {
    vision.state = vision_state::state::sees;
  }

  NodeStatus live() {
    const NodeStatus status = tick();
    const auto& walking = robot->orders.walking();
    footsteps.state = walking ? footstep_state::state::other : footstep_state::state::stands;
    if (walking) {
      estimate.odometry_base[2] += walking->turn_rad_per_s * 0.08;
      turned_rad += walking->turn_rad_per_s * 0.08;
    }
    if (const auto& look = robot->orders.head()) head = *look;
    const double phase = 2.0 * kPi * 1e-9 * static_cast<double>(now_ns) / std::max(head.period, 1.0);
    estimate.head[0] = head.mode == head_command::mode::scan ? head.extent * std::sin(phase) : 0.0;
    return status;
  }
  NodeStatus live_for(double seconds) {
    NodeStatus status = NodeStatus::running;
    for (double s = 0.0; s < seconds && status == NodeStatus::running; s += 0.08) status = live();
    return status;
  }

  HeadCommand head{};
  double turned_rad = 0.0;
};

TEST(FindTag, WhatIsSeenIsFoundAtOnceAndToldWhere) {
  ScriptedRun run(R"(<Sequence><FindTag id="7" bearing="{b}" distance="{d}"/><Sleep msec="1"/></Sequence>)");
  run.vision.state = vision_state::state::sees;
  run.see_tag(7, 1.0, 1.0);
  run.tick();
  EXPECT_FALSE(run.robot->orders.walking());
  EXPECT_NEAR(std::get<double>(run.tree.values()[*run.tree.entry("b")]), kPi / 4.0, 1e-9);
  EXPECT_NEAR(std::get<double>(run.tree.values()[*run.tree.entry("d")]), std::sqrt(2.0), 1e-9);
}

TEST(FindTag, LooksFromSideToSideBeforeItTurnsAndFailsOnceAround) {
  SearchingRobot run(R"(<FindTag id="7"/>)");
  run.live_for(2.0);
  EXPECT_EQ(run.head.mode, head_command::mode::scan);
  EXPECT_DOUBLE_EQ(run.turned_rad, 0.0);
  EXPECT_EQ(run.live_for(120.0), NodeStatus::failure);
  EXPECT_THAT(run.take_sayings(), ElementsAre(HasSubstr("it has looked all around")));
  EXPECT_GT(run.turned_rad, 2.0 * kPi - 0.2);
  EXPECT_LT(run.turned_rad, 2.0 * kPi + 1.1);
}

TEST(FindTag, StopsWhereItSeesItAndKeepsItsEyesOnIt) {
  SearchingRobot run(R"(<FindTag id="7"/>)");
  while (run.turned_rad < 0.5) ASSERT_EQ(run.live(), NodeStatus::running);
  NodeStatus status = NodeStatus::running;
  for (int i = 0; i < 50 && status == NodeStatus::running; ++i) {
    run.see_tag(7, 0.5, 1.5);
    status = run.live();
  }
  EXPECT_EQ(status, NodeStatus::success);
  EXPECT_LT(run.turned_rad, 0.6);
  EXPECT_EQ(run.footsteps.state, footstep_state::state::stands);
  EXPECT_EQ(run.head.mode, head_command::mode::point);
  EXPECT_DOUBLE_EQ(run.head.point[1], 1.5);
}

// After a fall it faces elsewhere, and odometry has another place in the world.
TEST(FindTag, LooksFirstWhereTheTagWasSeenLast) {
  SearchingRobot run(R"(<FindTag id="7"/>)");
  run.see_tag(7, 2.0, 0.0);
  ASSERT_EQ(run.live(), NodeStatus::success);
  run.now_ns += 5'000'000'000;
  run.navigation.odometry[0] = 0.5;
  run.navigation.odometry[2] = 1.0;  // the world's x axis lies 1 rad to the right of odometry's
  run.estimate.odometry_base[2] = 1.5;
  ASSERT_EQ(run.live(), NodeStatus::running);
  EXPECT_EQ(run.head.mode, head_command::mode::point);
  EXPECT_NEAR(run.head.point[0], 1.5 * std::cos(1.0), 1e-9);
  EXPECT_NEAR(run.head.point[1], -1.5 * std::sin(1.0), 1e-9);
  do {
    ASSERT_EQ(run.live(), NodeStatus::running);
  } while (run.robot->orders.walking());
  EXPECT_NEAR(run.turned_rad, -2.1, 0.1) << "to the right, until it is before it";
  EXPECT_EQ(run.live_for(4.0), NodeStatus::running);
  EXPECT_EQ(run.head.mode, head_command::mode::scan) << "it is not there any more";
}

TEST(FindTag, AnotherTagsPlaceSaysNothing) {
  SearchingRobot run(R"(<Sequence><FindTag id="7"/><FindTag id="8"/></Sequence>)");
  run.see_tag(7, 2.0, 0.0);
  EXPECT_EQ(run.live(), NodeStatus::running);
  EXPECT_EQ(run.live(), NodeStatus::running);
  EXPECT_EQ(run.head.mode, head_command::mode::scan);
}

TEST(FindTag, WithoutEyesThereIsNothingToFind) {
  SearchingRobot run(R"(<FindTag id="7"/>)");
  run.vision.state = vision_state::state::blind;
  EXPECT_EQ(run.live(), NodeStatus::failure);
  EXPECT_THAT(run.take_sayings(), ElementsAre(HasSubstr("there are no cameras that see")));
}

TEST(FindTag, GoesOnWhereTheHeadStopsInTheMiddleOfItsScan) {
  SearchingRobot run(R"(<FindTag id="7"/>)");
  run.live_for(1.5);
  ASSERT_GT(std::abs(run.estimate.head[0]), 0.1);
  for (int i = 0; i < 60 && !run.robot->orders.walking(); ++i) {
    run.head.mode = head_command::mode::ahead;  // somebody else has it
    ASSERT_EQ(run.live(), NodeStatus::running);
  }
  EXPECT_TRUE(run.robot->orders.walking()) << "it turns to look from there";
}

TEST(FindTag, EndsWhenTheEyesFail) {
  SearchingRobot run(R"(<FindTag id="7"/>)");
  while (run.turned_rad < 0.5) ASSERT_EQ(run.live(), NodeStatus::running);
  run.vision.state = vision_state::state::blind;
  EXPECT_EQ(run.live(), NodeStatus::failure);
  EXPECT_FALSE(run.robot->orders.walking());
  EXPECT_EQ(run.head.mode, head_command::mode::ahead) << "it does not scan on";
}

TEST(FindTag, HaltedItStandsBeforeItHasEnded) {
  SearchingRobot run(R"(<FindTag id="7"/>)");
  while (run.turned_rad < 0.5) ASSERT_EQ(run.live(), NodeStatus::running);
  EXPECT_FALSE(run.halt());
  EXPECT_FALSE(run.robot->orders.walking());
  run.footsteps.state = footstep_state::state::stands;
  bool has_ended = false;
  for (int i = 0; i < 4 && !has_ended; ++i) has_ended = run.halt();
  EXPECT_TRUE(has_ended);
}

// The one that takes over orders before the other one is halted.
TEST(HeadLeaves, WhoTakesTheHeadOverKeepsIt) {
  SearchingRobot run(
      R"(<ReactiveFallback><Sequence><SeesTag id="7"/><LookAtTag id="7"/></Sequence><LookAround/></ReactiveFallback>)");
  run.live();
  EXPECT_EQ(run.head.mode, head_command::mode::scan);
  run.see_tag(7, 1.0, 0.5);
  run.live();
  EXPECT_EQ(run.head.mode, head_command::mode::point);
  run.targets.count = 0;
  run.live();
  EXPECT_EQ(run.head.mode, head_command::mode::scan);
  run.halt();
  ASSERT_TRUE(run.robot->orders.head());
  EXPECT_EQ(run.robot->orders.head()->mode, head_command::mode::ahead);
}

}  // namespace
}  // namespace gaitway::behaviour_leaves
