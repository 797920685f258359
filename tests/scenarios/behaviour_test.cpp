// Missions run by the whole chain: falls, getting up, giving up, persons who take over.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <random>

#include "behaviour_run.hpp"

namespace gaitway::scenarios {
namespace {

using testing::Contains;
using testing::HasSubstr;
namespace states = behaviour_state::state;

// A tree of these nodes, in a file of its own.
std::string mission_of(const std::string& name, std::string_view nodes) {
  const std::string file = fmt::format("{}mission_{}_{}.xml", testing::TempDir(), name, getpid());
  std::ofstream(file) << R"(<root BTCPP_format="4" main_tree_to_execute="Main"><BehaviorTree ID="Main">)"
                      << nodes
                      << R"(</BehaviorTree><BehaviorTree ID="StandUp"><GetUp/></BehaviorTree></root>)";
  return file;
}

constexpr const char* kWalks = R"(<Walk forward="0.15 m/s"/>)";

struct Push {
  const char* name;
  std::array<double, 3> direction;
};
class FelledRobot : public testing::TestWithParam<std::tuple<int, int>> {};
constexpr std::array<Push, 4> kPushes{
    {{"ahead", {1, 0, 0}}, {"back", {-1, 0, 0}}, {"left", {0, 1, 0}}, {"right", {0, -1, 0}}}};

TEST_P(FelledRobot, GetsUp) {
  const auto [push, seed] = GetParam();
  BehaviourRun run({.seed = static_cast<std::uint64_t>(seed), .mission = "stand_up_after_falls"});
  run.advance_until(1.0);
  const auto& d = kPushes[static_cast<std::size_t>(push)].direction;
  run.push({d[0], d[1], d[2]});
  ASSERT_TRUE(run.advance_until([&] { return run.fall() != estimate::fall::upright; }, 2.0));
  EXPECT_TRUE(run.advance_until([&] { return run.stands(); }, 30.0)) << run.said();
  run.advance_until(run.time_s() + 3.0);
  EXPECT_TRUE(run.stands()) << run.said();
  EXPECT_EQ(run.state().state, states::runs);
  EXPECT_LE(run.orders.motions().size(), 3U);
}
INSTANTIATE_TEST_SUITE_P(Pushes, FelledRobot, testing::Combine(testing::Range(0, 4), testing::Range(1, 3)),
                         [](const auto& trial) {
                           return std::string(
                                      kPushes[static_cast<std::size_t>(std::get<0>(trial.param))].name) +
                                  "_" + std::to_string(std::get<1>(trial.param));
                         });

TEST(Behaviour, GivesUpAfterThreeAttempts) {
  BehaviourRun run({.mission = mission_of("blocked", R"(<Sequence><WaitUntil what="fallen"/>
                                                        <Fallback><GetUp front="none" back="none"/>
                                                        <WaitUntil what="stands"/></Fallback></Sequence>)")});
  run.advance_until(1.0);
  run.push({1.0, 0.0, 0.0});
  run.advance_until(40.0);
  EXPECT_EQ(run.orders.motions().size(), 3U);
  EXPECT_THAT(run.lines(), Contains(HasSubstr("gives up after 3 attempts")));
  EXPECT_EQ(run.state().state, states::runs) << "it waits for somebody to help";
}

TEST(Behaviour, AKickIsLeftWithinACycleOfTheFallAndNotGoneOnWith) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    BehaviourRun run(
        {.seed = seed,
         .mission = mission_of("kick", R"(<Sequence><WaitUntil what="stands"/><PlayMotion motion="kick"/>
                                                       <Walk/></Sequence>)")});
    ASSERT_TRUE(run.advance_until([&] { return run.motion().state == 2; }, 3.0)) << run.said();
    run.advance_until(run.time_s() + 0.1 * static_cast<double>(seed));
    run.push({0.0, 1.0, 0.0});
    ASSERT_TRUE(run.advance_until([&] { return run.fall() != estimate::fall::upright; }, 2.0));
    const double fell_s = run.time_s();
    EXPECT_TRUE(run.advance_until([&] { return run.motion().state != 2; }, 0.2)) << seed;
    run.advance_until(fell_s + 5.0);
    const auto& motions = run.orders.motions();
    ASSERT_EQ(motions.size(), 2U) << seed;
    EXPECT_EQ(motions[1].name, "") << "leave it";
    EXPECT_LE(motions[1].at_s - fell_s, 0.08) << seed;
    EXPECT_EQ(run.state().state, states::failed);
  }
}

TEST(Behaviour, WhileAPersonCommandsItWaitsAndBeginsAnewWhenItIsLetGo) {
  BehaviourRun run({.mission = mission_of("walk", kWalks)});
  ASSERT_TRUE(run.advance_until([&] { return !run.stands(); }, 3.0));
  run.advance_until(run.time_s() + 2.0);
  run.person_takes();
  const double taken_s = run.time_s();
  EXPECT_TRUE(run.advance_until([&] { return run.state().state == states::waits; }, 0.16));
  const std::int64_t last_ns = run.orders.walk().stamp_ns;
  run.advance_until(taken_s + 8.0);
  EXPECT_EQ(run.orders.walk().stamp_ns, last_ns) << "nothing is ordered";
  EXPECT_TRUE(run.stands());
  run.person_lets_go();
  const double back_s = run.time_s();
  EXPECT_TRUE(run.advance_until(
      [&] { return run.orders.walk().walk != 0 && run.orders.walk().stamp_ns > last_ns; }, 1.0));
  EXPECT_LE(run.time_s() - back_s, 0.16) << "two cycles";
  EXPECT_EQ(run.state().state, states::runs);
}

TEST(Behaviour, ARobotThatFellUnderAPersonsCommandGetsUpAndDoesNothingElse) {
  BehaviourRun run({.mission = mission_of("walk", kWalks)});
  run.person_takes();
  run.advance_until(2.0);
  EXPECT_EQ(run.state().state, states::waits);
  run.push({-1.0, 0.0, 0.0});
  ASSERT_TRUE(run.advance_until([&] { return run.fall() == estimate::fall::lies; }, 5.0));
  EXPECT_TRUE(run.advance_until([&] { return run.stands(); }, 30.0)) << run.said();
  EXPECT_EQ(run.state().state, states::waits);
  const std::int64_t walk_ns = run.orders.walk().stamp_ns;
  run.advance_until(run.time_s() + 5.0);
  EXPECT_TRUE(run.stands());
  EXPECT_EQ(run.orders.walk().stamp_ns, walk_ns) << "no walk since the person has taken the command";
  EXPECT_EQ(run.orders.motions().size(), 1U);
}

// A person has stopped it: it lies until it is told to get up.
TEST(Behaviour, ARobotThatFellAfterAStopLies) {
  BehaviourRun run({.mission = "stand_up_after_falls"});
  run.advance_until(1.0);
  run.cosimulation.apply({run.time_s(), simulator::StopEvent{}});
  run.advance_until(2.0);
  run.push({-1.0, 0.0, 0.0});
  run.advance_until(15.0);
  EXPECT_EQ(run.fall(), estimate::fall::lies);
  EXPECT_TRUE(run.orders.motions().empty());
  run.person_lets_go();
  EXPECT_TRUE(run.advance_until([&] { return run.stands(); }, 30.0)) << run.said();
}

// At random instants: GAITWAY_STOPS of them, or ten.
TEST(Behaviour, AStopThatIsNotLetGoIsNeverFollowedByAnything) {
  const char* const wanted = std::getenv("GAITWAY_STOPS");
  const int trials = wanted != nullptr ? std::atoi(wanted) : 10;
  std::mt19937 random(7);
  for (int trial = 0; trial < trials; ++trial) {
    BehaviourRun run({.seed = static_cast<std::uint64_t>(trial + 1), .mission = "patrol"});
    run.advance_until(1.0 + 0.001 * static_cast<double>(random() % 15000));
    run.cosimulation.apply({run.time_s(), simulator::StopEvent{}});
    EXPECT_TRUE(run.advance_until([&] { return run.stands(); }, 6.0)) << trial;
    const auto way = run.orders.way().number;
    run.advance_until(run.time_s() + 4.0);
    EXPECT_TRUE(run.stands()) << trial;
    EXPECT_EQ(run.orders.way().number, way) << trial;
  }
}

TEST(Behaviour, PatrolsFromCornerToCorner) {
  BehaviourRun run({.mission = "patrol"});
  EXPECT_TRUE(run.advance_until(
      [&] {
        const auto at = run.cosimulation.plant().truth().com_m;
        return std::hypot(at.x() - 0.8, at.y() - 0.8) < 0.15 && run.stands();
      },
      60.0))
      << run.said();
}

// Tells where tag 7 is, as cameras would that see it within 35 degrees of the robot's heading.
class Eyes {
 public:
  explicit Eyes(BehaviourRun& run)
      : run_(run),
        client_(run.block.local_client("vision")),
        vision_(client_.write<VisionState>("vision_state")),
        targets_(client_.write<SeenTargets>("seen_targets")),
        estimates_(client_.read<Estimate>("estimate")) {}

  void look() {
    const std::int64_t now_ns = run_.cosimulation.now_ns();
    if (now_ns % 80'000'000 != 0) return;
    VisionState state{};
    state.stamp_ns = now_ns;
    state.state = vision_state::state::sees;
    vision_.publish(state, now_ns);
    Estimate estimate{};
    static_cast<void>(estimates_.read(estimate));
    const Eigen::Isometry3d& base = run_.cosimulation.plant().truth().base;
    const double heading = std::atan2(base.linear()(1, 0), base.linear()(0, 0));
    const double x = kX_m - base.translation().x(), y = kY_m - base.translation().y();
    const double bearing = std::remainder(std::atan2(y, x) - heading, 2.0 * M_PI);
    const double in_odometry = bearing + estimate.odometry_base[2];
    seen_.stamp_ns = now_ns;
    if (std::abs(bearing) < 0.6 && estimate.fall == estimate::fall::upright) {
      seen_.count = 1;
      seen_.id[0] = 7;
      seen_.seen_ns[0] = now_ns;
      seen_.position[0][0] = estimate.odometry_base[0] + std::hypot(x, y) * std::cos(in_odometry);
      seen_.position[0][1] = estimate.odometry_base[1] + std::hypot(x, y) * std::sin(in_odometry);
      seen_.position[0][2] = 0.3;
    }
    targets_.publish(seen_, now_ns);
  }
  [[nodiscard]] double distance_m() const {
    const auto at = run_.cosimulation.plant().truth().com_m;
    return std::hypot(at.x() - kX_m, at.y() - kY_m);
  }

 private:
  static constexpr double kX_m = -1.2, kY_m = 0.3;
  BehaviourRun& run_;
  msgclient::Client client_;
  msgclient::Writer<VisionState> vision_;
  msgclient::Writer<SeenTargets> targets_;
  msgclient::Reader<Estimate> estimates_;
  SeenTargets seen_{};
};

bool is_over(BehaviourRun& run) {
  const std::uint32_t state = run.state().state;
  return state == states::succeeded || state == states::failed;
}

TEST(Behaviour, FindsATagThatIsBehindItAndWalksThere) {
  BehaviourRun run({.mission = "find_and_walk_to_tag"});
  Eyes eyes(run);
  EXPECT_TRUE(run.advance_until([&] { return eyes.look(), is_over(run); }, 90.0)) << run.said();
  EXPECT_EQ(run.state().state, states::succeeded) << run.said();
  EXPECT_NEAR(eyes.distance_m(), 0.5, 0.12);
}

// Felled on the way: it gets up, looks for the tag anew, and arrives.
TEST(Behaviour, AFallOnTheWayToTheTagIsGotOver) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    BehaviourRun run({.seed = seed, .mission = "find_and_walk_to_tag"});
    Eyes eyes(run);
    ASSERT_TRUE(run.advance_until(
        [&] { return eyes.look(), run.navigation().state == navigation_state::state::walks; }, 40.0))
        << run.said();
    const double walks_s = run.time_s();
    run.advance_until([&] { return eyes.look(), run.time_s() > walks_s + 1.0; }, 2.0);
    run.push({seed % 2 == 0 ? 1.0 : -1.0, 0.0, 0.0});
    EXPECT_TRUE(run.advance_until([&] { return eyes.look(), run.fall() == estimate::fall::lies; }, 5.0))
        << seed;
    EXPECT_TRUE(run.advance_until([&] { return eyes.look(), is_over(run); }, 120.0)) << run.said();
    EXPECT_EQ(run.state().state, states::succeeded) << seed << ": " << run.said();
    EXPECT_NEAR(eyes.distance_m(), 0.5, 0.15) << seed;
  }
}

TEST(Behaviour, PeopleStartChangeAndEndMissions) {
  BehaviourRun run({.mission = ""});
  run.advance_until(1.0);
  EXPECT_EQ(run.state().state, states::none);
  std::uint32_t number = run.ask(behaviour_request::verb::start, "patrole");
  ASSERT_TRUE(run.advance_until([&] { return run.state().answered == number; }, 0.3));
  EXPECT_EQ(run.state().refused, 1U);
  EXPECT_THAT(run.said(), HasSubstr("patrol"));
  const std::string file = mission_of("changed", kWalks);
  number = run.ask(behaviour_request::verb::start, file);
  ASSERT_TRUE(run.advance_until([&] { return run.state().answered == number; }, 0.3));
  EXPECT_EQ(run.state().refused, 0U) << run.said();
  ASSERT_TRUE(run.advance_until([&] { return !run.stands(); }, 3.0));
  // The walk goes on in the tree that the file has become.
  static_cast<void>(mission_of("changed", R"(<Walk forward="0.05 m/s"/>)"));
  const std::uint32_t revision = run.state().revision;
  number = run.ask(behaviour_request::verb::change);
  ASSERT_TRUE(run.advance_until([&] { return run.state().answered == number; }, 0.3));
  EXPECT_EQ(run.state().refused, 0U) << run.said();
  EXPECT_GT(run.state().revision, revision);
  run.advance_until(run.time_s() + 0.2);
  EXPECT_DOUBLE_EQ(run.orders.walk().velocity[0], 0.05);
  EXPECT_FALSE(run.stands());
  // A tree without the walk is refused while it walks.
  static_cast<void>(mission_of("changed", R"(<WaitUntil what="fallen"/>)"));
  number = run.ask(behaviour_request::verb::change);
  ASSERT_TRUE(run.advance_until([&] { return run.state().answered == number; }, 0.3));
  EXPECT_EQ(run.state().refused, 1U);
  EXPECT_THAT(run.said(), HasSubstr("Walk"));
  number = run.ask(behaviour_request::verb::end);
  EXPECT_TRUE(run.advance_until([&] { return run.state().state == states::none; }, 5.0)) << run.said();
  EXPECT_TRUE(run.stands());
}

TEST(Behaviour, ReloadedWhileItWalksItBeginsAnewAndTheRobotDoesNotFall) {
  BehaviourRun run({.mission = "patrol"});
  ASSERT_TRUE(
      run.advance_until([&] { return run.navigation().state == navigation_state::state::walks; }, 5.0));
  run.advance_until(run.time_s() + 2.0);
  auto& changes = run.cosimulation.plugins().changes();
  ASSERT_TRUE(changes.schedule(changes.prepare_reload("behaviour", "")));
  std::optional<core::ChangeResult> result;
  ASSERT_TRUE(run.advance_until([&] { return (result = changes.take_result()).has_value(); }, 1.0));
  EXPECT_TRUE(result->done) << result->text;
  EXPECT_TRUE(run.advance_until([&] { return run.stands(); }, 5.0)) << "the way before has been ended";
  EXPECT_TRUE(
      run.advance_until([&] { return run.navigation().state == navigation_state::state::walks; }, 5.0));
  EXPECT_FALSE(run.cosimulation.plant().fallen());
}

TEST(Behaviour, AMissionThatIsOverDoesNotBeginAnewByAReload) {
  BehaviourRun run({.mission = mission_of("over", "<AlwaysSuccess/>")});
  run.advance_until(1.0);
  EXPECT_EQ(run.state().state, states::succeeded);
  auto& changes = run.cosimulation.plugins().changes();
  ASSERT_TRUE(changes.schedule(changes.prepare_reload("behaviour", "")));
  run.advance_until(2.0);
  EXPECT_EQ(run.state().state, states::succeeded);
}

class BehaviourFails : public testing::TestWithParam<core::PluginFaultKind> {};

TEST_P(BehaviourFails, TheWalkEndsAndTheRobotStands) {
  for (int trial = 0; trial < 3; ++trial) {
    // Not from the first moment on: the estimate settles then, and a walk may not come to its end.
    BehaviourRun run(
        {.seed = static_cast<std::uint64_t>(trial + 1),
         .mission = mission_of("walk", R"(<Delay delay_msec="1000"><Walk forward="0.15 m/s"/></Delay>)")});
    run.advance_until(4.0 + 0.31 * trial);
    EXPECT_FALSE(run.stands());
    run.cosimulation.apply({run.time_s(), simulator::PluginFault{"behaviour", GetParam(), 0.0, 0.006}});
    run.advance_until(run.time_s() + 6.0);
    EXPECT_FALSE(run.cosimulation.plant().fallen()) << trial;
    if (GetParam() == core::PluginFaultKind::throws) {
      EXPECT_TRUE(run.stands()) << "nobody renews the walk";
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Ways, BehaviourFails,
                         testing::Values(core::PluginFaultKind::throws, core::PluginFaultKind::not_a_number,
                                         core::PluginFaultKind::jumps, core::PluginFaultKind::overruns));

TEST(Behaviour, InAProcessOfItsOwnItDoesTheSame) {
  BehaviourRun run({.mission = "stand_up_after_falls", .isolation = "process"});
  run.advance_until(1.0);
  run.push({1.0, 0.0, 0.0});
  ASSERT_TRUE(run.advance_until([&] { return run.fall() != estimate::fall::upright; }, 2.0));
  EXPECT_TRUE(run.advance_until([&] { return run.stands(); }, 30.0)) << run.said();
}

}  // namespace
}  // namespace gaitway::scenarios
