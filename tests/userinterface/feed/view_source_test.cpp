// What the view shows of a robot that stands, walks and is stopped.
#include "gaitway/api/view_source.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gaitway/api/feed.hpp"
#include "gaitway/api/plan_digest.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "humanoid.hpp"
#include "simulation.hpp"

namespace gaitway::api {
namespace {

using page::Activity;
using test::humanoid;

constexpr std::size_t kBaseCoordinates = 7;  // of the plant, before the joints

class WatchedRobot {
 public:
  // By its own clock, as if that were the wall's.
  void run_until(double time_s) {
    GenericSink sink(ViewSource::wants, [this](Topic topic, const auto& message, std::int64_t) {
      source.take(topic, message, run.now_ns());
    });
    while (static_cast<double>(run.now_ns()) < time_s * 1e9) {
      run.advance_millisecond();
      digest.step(run.now_ns());
      feed.poll(run.now_ns(), sink);
    }
  }
  [[nodiscard]] page::ViewState state(std::int64_t later_ns = 0) {
    return source.state(feed.robot_ns(), feed.heartbeat_age_ns(), "somebody", run.now_ns() + later_ns);
  }

  simulator::Cosimulation run{humanoid(), options()};
  PlanDigest digest{run.client()};
  Feed feed{run.client(), humanoid()};
  ViewSource source{run.client(), humanoid()};

 private:
  static simulator::CosimulationOptions options() {
    simulator::CosimulationOptions result = served_walk();
    result.people_outside = false;
    return result;
  }
};

TEST(ViewSource, KnowsNothingBeforeTheRobotHasBeenHeardOf) {
  WatchedRobot robot;
  const page::ViewState state = robot.state();
  EXPECT_EQ(state.joint_count, 0U);
  EXPECT_TRUE(std::isnan(state.base_height_m));
  for (const std::size_t part : {0U, 1U, 3U}) {  // the message controller's state is there from the start
    EXPECT_TRUE(std::isnan(state.age_s[part])) << part;
  }
}

TEST(ViewSource, ShowsAStand) {
  WatchedRobot robot;
  robot.run_until(2.0);
  const page::ViewState state = robot.state();
  EXPECT_EQ(state.joint_count, humanoid().joints.size());
  EXPECT_EQ(state.activity, Activity::stands);
  EXPECT_EQ(state.mode, 0.0);
  EXPECT_EQ(state.commander, "somebody");
  EXPECT_EQ(state.contact[0] + state.contact[1], 2.0);
  EXPECT_NEAR(state.foot_force_N[0] + state.foot_force_N[1],
              humanoid().total_mass_kg() * facts::kGravity_m_per_s2, 5.0);
  EXPECT_NEAR(state.base_height_m, robot.run.plant().truth().base.translation().z(), 0.01);
  EXPECT_LT(std::hypot(state.com_m[0], state.com_m[1]), 0.1);
  EXPECT_NEAR(state.com_m[2], robot.run.plant().truth().com_m.z(), 0.01);
  EXPECT_LT(std::hypot(state.zmp_m[0] - state.com_m[0], state.zmp_m[1] - state.com_m[1]), 0.02);
  EXPECT_EQ(state.footstep_count, 0U);
  EXPECT_EQ(state.batches_late + state.batches_refused, 0U);
  for (std::size_t joint = 0; joint < state.joint_count; ++joint) {
    EXPECT_FALSE(state.joint_trouble[joint]);
    EXPECT_NEAR(state.joints_rad[joint], robot.run.plant().positions()[kBaseCoordinates + joint], 0.03)
        << joint;
  }
  for (const double age_s : state.age_s) {
    EXPECT_LT(age_s, 0.05);
  }
}

TEST(ViewSource, ShowsAWalkWithItsFootstepsAndAStop) {
  WatchedRobot robot;
  robot.run_until(1.0);
  robot.run.apply({0.0, simulator::WalkEvent{.velocity_m_per_s = {0.2, 0.0}, .turn_rate_rad_per_s = 0.0}});
  robot.run_until(4.0);
  const page::ViewState walks = robot.state();
  EXPECT_EQ(walks.activity, Activity::walks);
  ASSERT_GE(walks.footstep_count, 1U);
  EXPECT_LT(std::abs(walks.footsteps[0][0]), 0.3);
  EXPECT_LT(std::abs(walks.footsteps[0][1]), 0.15);
  EXPECT_GT(walks.base_place_m[0], 0.2);
  EXPECT_NEAR(walks.velocity[0], 0.2, 0.15);
  robot.run.apply({0.0, simulator::StopEvent{}});
  robot.run_until(4.3);
  EXPECT_EQ(robot.state().mode, 1.0);
  EXPECT_EQ(robot.state().activity, Activity::walks);
}

TEST(ViewSource, GrowsOldWhenNothingComes) {
  WatchedRobot robot;
  robot.run_until(1.0);
  constexpr std::int64_t kLater_ns = 700'000'000;
  const page::ViewState state = robot.state(kLater_ns);
  EXPECT_GE(state.age_s[0], 0.7);
  EXPECT_GE(state.age_s[1], 0.7);
}

}  // namespace
}  // namespace gaitway::api
