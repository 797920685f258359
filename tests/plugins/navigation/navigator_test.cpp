// The states of a way, with a robot that sets its feet exactly where it is told: a step every four cycles.
#include "gaitway/navigation/navigator.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cstring>
#include <memory>
#include <string>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::navigation {
namespace {

using planning::Pose;
using planning::Side;
using testing::HasSubstr;
using testing::StartsWith;
namespace walks = footstep_state::state;
namespace states = navigation_state::state;
namespace results = navigation_state::result;

constexpr std::int64_t kTick_ns = 10'000'000, kStep_ns = 320'000'000;

const urdf::RobotModel& humanoid() {
  static const urdf::RobotModel robot = urdf::load_robot(GAITWAY_URDF_DIR "/humanoid22");
  return robot;
}

world::World floor_with_wall() {
  world::World world;
  world::Solid wall;
  wall.kind = world::Kind::wall;
  wall.pose.translation() = Eigen::Vector3d(2.0, 0.0, 0.5);
  wall.size_m = {0.1, 6.0, 1.0};
  world.solids.push_back(wall);
  return world;
}

class NavigatorTest : public testing::Test {
 protected:
  NavigatorTest() {
    estimate.fall = estimate::fall::upright;
    for (const Side side : {Side::left, Side::right}) put(side, planner.limits().foot_of({}, side));
  }
  void put(Side side, const Pose& pose) {
    double* const foot = estimate.odometry_foot[static_cast<std::size_t>(side)];
    foot[0] = pose.x_m;
    foot[1] = pose.y_m;
    foot[2] = pose.yaw_rad;
  }
  [[nodiscard]] Pose middle() const {
    const auto foot = [this](std::size_t i) {
      return Pose{estimate.odometry_foot[i][0], estimate.odometry_foot[i][1], estimate.odometry_foot[i][2]};
    };
    return planning::middle_of(foot(0), foot(1));
  }
  void ask(const Pose& goal, bool cancel = false) {
    WalkToRequest request{};
    request.stamp_ns = now_ns;
    request.number = ++asked;
    request.cancel = cancel ? 1 : 0;
    request.goal[0] = goal.x_m;
    request.goal[1] = goal.y_m;
    request.goal[2] = goal.yaw_rad;
    navigator.ask(request, now_ns);
  }
  void tick() {
    now_ns += kTick_ns;
    estimate.stamp_ns = now_ns;
    navigator.step({.now_ns = now_ns,
                    .estimate = estimate,
                    .walk = walk,
                    .commanded = commanded,
                    .network_mode = mode,
                    .stops = stops},
                   *plan, *state, *way);
    if (walks_on) walk_on();
  }
  // Lands the step in flight, and begins the next one.
  void walk_on() {
    if (walk.step != 0 && now_ns < lands_ns) return;
    if (walk.step != 0) {
      put(side_of_step, {walk.landing[0], walk.landing[1], walk.landing[2]});
      walk.landed = walk.step;
      walk.step = 0;
    }
    const std::uint32_t next = std::max(plan->first, walk.landed + 1);
    if (plan->step_count == 0 || next - plan->first >= plan->step_count) {
      walk.state = walks::stands;
      return;
    }
    const std::uint32_t i = next - plan->first;
    walk.state = walks::follows;
    walk.step = next;
    side_of_step = static_cast<Side>(plan->side[i]);
    std::memcpy(walk.landing, plan->step[i], sizeof walk.landing);
    lands_ns = now_ns + kStep_ns;
  }
  template <class Done>
  void run_until(const Done& done, double most_s = 60.0) {
    const std::int64_t end_ns = now_ns + static_cast<std::int64_t>(most_s * 1e9);
    while (!done() && now_ns < end_ns) tick();
    ASSERT_TRUE(done()) << "after " << most_s << " s: state " << state->state << ", " << text();
  }
  void run_to_end() {
    tick();
    run_until([this] { return state->state == states::idle; });
  }
  [[nodiscard]] std::string text() const { return reinterpret_cast<const char*>(state->text); }

  WayPlanner planner{humanoid(), floor_with_wall(), {}};
  PlanningDesk desk{PlanningDesk::Where::in_step};
  Navigator navigator{planner, desk, PoseFilter({}, {}), {}};
  std::int64_t now_ns = 1'000'000'000;
  std::uint32_t asked = 0;
  Estimate estimate{};
  FootstepState walk{};
  bool commanded = false, walks_on = true;
  std::uint32_t mode = network_state::mode::batches;
  std::uint64_t stops = 0;
  std::int64_t lands_ns = 0;
  Side side_of_step = Side::left;
  std::unique_ptr<FootstepPlan> plan = std::make_unique<FootstepPlan>();
  std::unique_ptr<NavigationState> state = std::make_unique<NavigationState>();
  std::unique_ptr<NavigationWay> way = std::make_unique<NavigationWay>();
};

TEST_F(NavigatorTest, WithoutARequestNothingIsToBeWalked) {
  for (int i = 0; i < 20; ++i) tick();
  EXPECT_EQ(plan->step_count, 0U);
  EXPECT_EQ(state->state, states::idle);
  EXPECT_EQ(state->result, results::none);
  EXPECT_GT(plan->valid_until_ns, now_ns);
}

TEST_F(NavigatorTest, WalksToThePlaceAndSaysSo) {
  ask({0.7, -0.4, 0.5});
  tick();
  EXPECT_EQ(state->state, states::plans);
  EXPECT_EQ(state->answered, 1U);
  run_until([this] { return state->state == states::walks; });
  const double way_m = state->distance_left;
  EXPECT_GT(way_m, 0.75);
  EXPECT_EQ(state->steps_left, way->step_count);
  run_until([this] { return state->steps_left < 5; });
  EXPECT_LT(state->distance_left, 0.5 * way_m);
  run_to_end();
  EXPECT_EQ(state->result, results::arrived) << text();
  EXPECT_LT(planning::way_m(middle(), {0.7, -0.4, 0.5}), 1e-6);
  EXPECT_NEAR(middle().yaw_rad, 0.5, 1e-6);
  EXPECT_EQ(plan->step_count, 0U) << "nothing more is to be walked";
}

TEST_F(NavigatorTest, RefusesWithAReasonAndTheRobotStands) {
  ask({2.0, 0.0, 0.0});
  run_to_end();
  EXPECT_EQ(state->result, results::refused);
  EXPECT_THAT(text(), StartsWith("goal_in_obstacle: "));
  ask({3.0, 0.0, 0.0});
  run_to_end();
  EXPECT_EQ(state->result, results::arrived) << "round the wall: " << text();
  ask({NAN, 0.0, 0.0});
  run_to_end();
  EXPECT_EQ(state->result, results::refused);
  EXPECT_EQ(text(), "the goal must be three finite numbers");
  ask({500.0, 0.0, 0.0});
  run_to_end();
  EXPECT_EQ(state->result, results::refused);
  EXPECT_THAT(text(), StartsWith("goal_outside_map: "));
}

TEST_F(NavigatorTest, RefusesARobotThatCannotWalkNow) {
  const auto why = [this] {
    ask({0.5, 0.0, 0.0});
    tick();
    EXPECT_EQ(state->state, states::idle);
    EXPECT_EQ(state->result, results::refused);
    return text();
  };
  walks_on = false;
  estimate.fall = estimate::fall::lies;
  EXPECT_THAT(why(), HasSubstr("falls or lies"));
  estimate.fall = estimate::fall::upright;
  mode = network_state::mode::emergency_stop;
  EXPECT_THAT(why(), HasSubstr("an emergency stop is in force: release it first"));
  mode = network_state::mode::batches;
  commanded = true;
  EXPECT_THAT(why(), HasSubstr("somebody walks the robot"));
  commanded = false;
  walk.state = walks::other;
  EXPECT_THAT(why(), HasSubstr("does not stand"));
}

// Whoever asked has gone, or it was read again after a restart.
TEST_F(NavigatorTest, AnOldRequestIsNotWalked) {
  ask({0.5, 0.0, 0.0});
  run_to_end();
  Navigator successor(planner, desk, PoseFilter({}, {}), {});
  WalkToRequest old{};
  old.stamp_ns = now_ns - 1'000'000'000;
  old.number = 9;
  old.goal[0] = 1.0;
  successor.ask(old, now_ns);
  successor.step({.now_ns = now_ns, .estimate = estimate, .walk = walk}, *plan, *state, *way);
  EXPECT_EQ(state->state, states::idle);
  EXPECT_EQ(state->answered, 0U);
}

class TakenAway : public NavigatorTest {
 protected:
  void walk_half() {
    ask({1.0, 0.0, 0.0});
    tick();
    run_until([this] { return walk.landed == 5; });
  }
  void expect_end(std::uint32_t result, const std::string& why) {
    tick();
    EXPECT_EQ(state->state, states::idle);
    EXPECT_EQ(state->result, result);
    EXPECT_EQ(text(), why);
    EXPECT_EQ(plan->step_count, 0U);
    const std::uint32_t landed = walk.landed + 1;
    commanded = false;
    estimate.fall = estimate::fall::upright;
    for (int i = 0; i < 500; ++i) tick();
    EXPECT_LE(walk.landed, landed) << "it goes on by itself";
    EXPECT_EQ(state->state, states::idle);
  }
};

TEST_F(TakenAway, ByACancel) {
  walk_half();
  ask({}, true);
  expect_end(results::cancelled, "");
}
TEST_F(TakenAway, ByAStop) {
  walk_half();
  ++stops;
  expect_end(results::cancelled, "somebody stopped the robot");
}
TEST_F(TakenAway, ByAVelocity) {
  walk_half();
  commanded = true;
  expect_end(results::cancelled, "somebody walks the robot by velocities");
}
TEST_F(TakenAway, ByAFall) {
  walk_half();
  estimate.fall = estimate::fall::falls;
  expect_end(results::failed, "the robot fell");
}

TEST_F(NavigatorTest, APushedStepHasTheRestPlannedAnewFromWhereItLands) {
  ask({1.2, 0.0, 0.0});
  tick();
  run_until([this] { return walk.step == 6; });
  walk.landing[0] -= 0.04;
  run_until([this] { return state->replans == 1; }, 0.3);
  run_to_end();
  EXPECT_EQ(state->result, results::arrived) << text();
  EXPECT_LT(planning::way_m(middle(), {1.2, 0.0, 0.0}), 1e-6);
}

TEST_F(NavigatorTest, WhatHasComeIntoTheWayIsGoneRound) {
  ask({1.4, 0.0, 0.0});
  tick();
  run_until([this] { return walk.landed == 2; });
  const auto seen = std::make_unique<Obstacles>();
  seen->count = 1;
  seen->place[0][0] = 0.9;
  seen->size[0][0] = seen->size[0][1] = seen->size[0][2] = 0.3;
  navigator.see(*seen);
  double nearest_m = 1e9;
  run_until([&] {
    nearest_m = std::min(nearest_m, planning::way_m(middle(), {0.9, 0.0, 0.0}));
    return state->state == states::idle;
  });
  EXPECT_EQ(state->result, results::arrived) << text();
  EXPECT_EQ(state->replans, 1U);
  EXPECT_GT(nearest_m, 0.25) << "half of the box and half of the robot";
  navigator.see(*seen);
  tick();
  EXPECT_EQ(state->replans, 1U) << "the same again is no news";
}

TEST_F(NavigatorTest, WhatCamerasSeeInOdometryStandsInTheWorldAndTheirJitterIsNoNews) {
  const planning::Pose odometry{0.5, -0.2, 1.0};
  const auto seen = std::make_unique<Obstacles>();
  seen->count = 2;
  seen->frame = obstacles::frame::odometry;
  for (std::size_t i = 0; i < 2; ++i) {
    seen->place[i][0] = 1.0 + static_cast<double>(i);
    seen->size[i][0] = seen->size[i][1] = seen->size[i][2] = 0.2;
  }
  EXPECT_TRUE(planner.see(*seen, odometry));
  seen->place[0][0] += 0.01;
  seen->place[1][2] += 0.05;
  std::swap(seen->place[0], seen->place[1]);
  EXPECT_FALSE(planner.see(*seen, odometry)) << "the same boxes, in another order";
  EXPECT_TRUE(planner.see(*seen, {0.0, 0.0, 0.0})) << "they stand elsewhere in the world";
  seen->count = 1;
  EXPECT_TRUE(planner.see(*seen, {0.0, 0.0, 0.0})) << "one has gone";
}

TEST_F(NavigatorTest, AWayThatIsClosedWhileItIsWalkedFailsWithTheReason) {
  ask({1.4, 0.0, 0.0});
  tick();
  run_until([this] { return walk.landed == 2; });
  const auto seen = std::make_unique<Obstacles>();
  seen->count = 1;
  seen->place[0][0] = 1.4;
  seen->size[0][0] = seen->size[0][1] = seen->size[0][2] = 0.3;
  navigator.see(*seen);
  run_to_end();
  EXPECT_EQ(state->result, results::failed);
  EXPECT_THAT(text(), StartsWith("goal_in_obstacle: "));
  EXPECT_EQ(plan->step_count, 0U);
}

TEST_F(NavigatorTest, ANewGoalIsTakenInMidWalk) {
  ask({1.4, 0.0, 0.0});
  tick();
  run_until([this] { return walk.step == 5; });
  ask({0.3, 0.8, 1.5});
  run_to_end();
  EXPECT_EQ(state->answered, 2U);
  EXPECT_EQ(state->result, results::arrived) << text();
  EXPECT_EQ(state->replans, 0U) << "it is another way";
  EXPECT_LT(planning::way_m(middle(), {0.3, 0.8, 1.5}), 1e-6);
}

// The plan that is being made then is for the goal before, to which there is no way any more.
TEST_F(NavigatorTest, ANewGoalIsNotRefusedForTheOneBefore) {
  ask({1.4, 0.0, 0.0});
  tick();
  run_until([this] { return walk.step == 5; });
  const auto seen = std::make_unique<Obstacles>();
  seen->count = 1;
  seen->place[0][0] = 1.4;
  seen->size[0][0] = seen->size[0][1] = seen->size[0][2] = 0.3;
  navigator.see(*seen);
  tick();
  ASSERT_TRUE(desk.waits());
  ask({0.3, 0.8, 1.5});
  run_to_end();
  EXPECT_EQ(state->result, results::arrived) << text();
}

// A recovery, or a tail: the robot stands a little elsewhere, and the way begins anew from there.
TEST_F(NavigatorTest, GoesOnByItselfAfterAPushThatBroughtItToAStand) {
  ask({1.2, 0.0, 0.0});
  tick();
  run_until([this] { return walk.landed == 4; });
  walks_on = false;
  walk.state = walks::other;
  walk.step = 0;
  for (int i = 0; i < 50; ++i) tick();
  EXPECT_EQ(state->state, states::waits);
  EXPECT_EQ(plan->step_count, 0U) << "meanwhile nothing is to be walked";
  const Pose pushed{middle().x_m, 0.1, -0.2};
  for (const Side side : {Side::left, Side::right}) put(side, planner.limits().foot_of(pushed, side));
  walk.state = walks::stands;
  walks_on = true;
  run_to_end();
  EXPECT_EQ(state->result, results::arrived) << text();
  EXPECT_EQ(state->replans, 1U);
}

TEST_F(NavigatorTest, OneThatDoesNotComeToAStandIsGivenUp) {
  ask({1.2, 0.0, 0.0});
  tick();
  run_until([this] { return walk.landed == 4; });
  walks_on = false;
  walk.state = walks::other;
  run_until([this] { return state->state == states::idle; }, 11.0);
  EXPECT_EQ(state->result, results::failed);
  EXPECT_EQ(text(), "the robot did not come to a stand within 10 s");
}

TEST_F(NavigatorTest, AWalkThatDoesNotFollowIsGivenUp) {
  walks_on = false;
  ask({1.2, 0.0, 0.0});
  run_to_end();
  EXPECT_EQ(state->result, results::failed);
  EXPECT_EQ(text(), "the walk does not follow the planned footsteps");
}

// Told by something in the room: the steps go to the same place in the world, so elsewhere in odometry.
TEST_F(NavigatorTest, AMeasuredPoseMovesTheStepsInTheFrameOdometry) {
  ask({1.2, 0.0, 0.0});
  tick();
  run_until([this] { return walk.landed == 2; });
  const double before = plan->step[plan->step_count - 1][1];
  for (int i = 0; i < 20; ++i) {
    PoseMeasurement measurement{};
    measurement.stamp_ns = now_ns;
    measurement.base[1] = 0.02;  // further left than it thinks
    measurement.deviation[0] = 0.002;
    measurement.deviation[1] = 0.01;
    navigator.measure(measurement);
    tick();
  }
  EXPECT_NEAR(state->odometry[1], 0.02, 0.002);
  EXPECT_NEAR(plan->step[plan->step_count - 1][1], before - 0.02, 0.005);
  run_to_end();
  EXPECT_EQ(state->result, results::arrived) << text();
}

}  // namespace
}  // namespace gaitway::navigation
