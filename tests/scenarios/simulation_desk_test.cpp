// Pushes that a local process asks for while the robot stands or walks: what they do, what is refused, and
// that the record of them plays again to the bit.
#include "gaitway/simulator/simulation_desk.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/text_file.hpp"
#include "gaitway/simulation/control_client.hpp"
#include "gaitway/simulator/command_log.hpp"
#include "gaitway/world/world_file.hpp"

namespace gaitway::scenarios {
namespace {

using simulation::Answer;
using simulation::Push;
using simulator::PushEvent;
using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

const urdf::RobotModel& robot() {
  static const urdf::RobotModel model = urdf::load_robot(GAITWAY_ROBOT);
  return model;
}

std::unique_ptr<simulator::Cosimulation> new_run(std::uint64_t seed = 3) {
  simulator::CosimulationOptions options;
  options.plant.seed = seed;
  options.main_controller.configuration = GAITWAY_CONFIGURATION;
  options.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
  return std::make_unique<simulator::Cosimulation>(robot(), options);
}

// A run with a desk, and somebody who asks it.
class AskedRun {
 public:
  void advance(double seconds) {
    const std::int64_t end_ns = run->now_ns() + std::llround(seconds * 1e9);
    while (run->now_ns() < end_ns) {
      desk_.step();
      run->advance_millisecond();
    }
  }
  // What becomes of it in the milliseconds that come next.
  Answer ask(const Push& push) {
    const std::uint32_t number = client_.push(push, run->now_ns());
    for (int ms = 0; ms < 3; ++ms) {
      advance(0.001);
      client_.step(run->now_ns());
      if (const auto answer = client_.take_answer()) {
        EXPECT_EQ(answer->number, number);
        return *answer;
      }
    }
    return {.text = "no answer has come"};
  }
  [[nodiscard]] double x_m() const { return run->plant().truth().com_m.x(); }

  std::unique_ptr<simulator::Cosimulation> run = new_run();
  simulator::CommandLog log{*run};

 private:
  process::PrivateFolder folder_{"gaitway_desk_test"};
  simulator::SimulationDesk desk_{*run, folder_.path() / "simulation.sock",
                                  [this](const auto& event) { log.on_applied(event); }};
  simulation::ControlClient client_{folder_.path() / "simulation.sock"};
};

TEST(SimulationDesk, APushMovesTheRobotWhereItPoints) {
  AskedRun run;
  run.advance(1.0);
  const double before_m = run.x_m();
  const Answer answer = run.ask({.link = "trunk", .force_N = {20.0, 0.0, 0.0}, .duration_s = 0.1});
  ASSERT_TRUE(answer.accepted) << answer.text;
  run.advance(0.15);
  EXPECT_GT(run.x_m(), before_m + 0.005);
  EXPECT_FALSE(run.run->plant().fallen());
}

TEST(SimulationDesk, EveryLinkCanBePushed) {
  AskedRun run;
  run.advance(0.2);
  for (const urdf::Link& link : robot().links) {
    const Answer answer = run.ask({.link = link.name, .force_N = {0.0, 0.5, 0.0}, .duration_s = 0.01});
    EXPECT_TRUE(answer.accepted) << link.name << ": " << answer.text;
    run.advance(0.01);
  }
  EXPECT_THAT(run.log.events(), SizeIs(robot().links.size()));
}

TEST(SimulationDesk, UnknownLinksAreRefusedByName) {
  AskedRun run;
  const Answer answer = run.ask({.link = "tunk", .force_N = {1.0, 0.0, 0.0}, .duration_s = 0.1});
  EXPECT_FALSE(answer.accepted);
  EXPECT_THAT(answer.text, AllOf(HasSubstr("link is 'tunk'"), HasSubstr("humanoid22"),
                                 HasSubstr("Did you mean 'trunk'?")));
  EXPECT_THAT(run.log.events(), SizeIs(0));
}

TEST(SimulationDesk, NoMorePushesAtOnceThanPeopleHaveHands) {
  AskedRun run;
  const Push light{.link = "trunk", .force_N = {0.1, 0.0, 0.0}, .duration_s = 0.5};
  for (std::size_t i = 0; i < simulator::PushTaker::kMostPushes; ++i) {
    EXPECT_TRUE(run.ask(light).accepted);
  }
  EXPECT_THAT(run.ask(light).text, HasSubstr("8 pushes are under way"));
  run.advance(0.5);
  EXPECT_TRUE(run.ask(light).accepted);
}

TEST(SimulationDesk, AheadOfTheRobotIsWhereItLooks) {
  AskedRun run;
  run.run->apply({.at_s = 0.0, .action = simulator::WalkEvent{.turn_rate_rad_per_s = 0.8}});
  run.advance(2.5);
  const Eigen::Vector3d looks = run.run->plant().truth().base.linear().col(0);
  ASSERT_GT(std::atan2(looks.y(), looks.x()), 0.3) << "it has turned";
  ASSERT_TRUE(run.ask({.link = "trunk",
                       .force_N = {5.0, 0.0, 1.0},
                       .frame = simulation::Frame::heading,
                       .duration_s = 0.02})
                  .accepted);
  const auto& push = std::get<PushEvent>(run.log.events().at(0).action);
  EXPECT_NEAR(push.direction.x(), 5.0 * looks.x() / looks.head<2>().norm(), 0.05);
  EXPECT_NEAR(push.direction.y(), 5.0 * looks.y() / looks.head<2>().norm(), 0.05);
  EXPECT_EQ(push.direction.z(), 1.0);
  EXPECT_NEAR(push.impulse_Ns, std::hypot(5.0, 1.0) * 0.02, 1e-12);
}

TEST(SimulationDesk, ItsRecordPlaysAgainToTheBit) {
  AskedRun run;
  run.advance(0.7);
  ASSERT_TRUE(
      run.ask({.link = "left_forearm", .force_N = {1.0 / 3.0, -7.1, 0.123456789}, .duration_s = 0.0123})
          .accepted);
  run.advance(0.3);
  ASSERT_TRUE(run.ask({.link = "trunk", .force_N = {0.0, 17.0, 0.0}, .duration_s = 0.1}).accepted);
  run.advance(1.0);
  const process::PrivateFolder folder("gaitway_desk_test");
  const std::filesystem::path file = folder.path() / "commands.yaml";
  process::write_text_file(file, run.log.scenario(static_cast<double>(run.run->now_ns()) * 1e-9));
  const simulator::Scenario scenario = simulator::load_scenario(file, robot());
  ASSERT_THAT(scenario.events, SizeIs(2));
  const auto again = new_run();
  const auto unpushed = new_run();
  auto next = scenario.events.begin();
  while (again->now_ns() < run.run->now_ns()) {
    for (; next != scenario.events.end() && next->at_s <= static_cast<double>(again->now_ns()) * 1e-9 + 1e-9;
         ++next) {
      again->apply(*next);
    }
    again->advance_millisecond();
    unpushed->advance_millisecond();
  }
  const auto pose = [](const simulator::Cosimulation& one) {
    return std::vector(one.plant().positions().begin(), one.plant().positions().end());
  };
  EXPECT_EQ(pose(*again), pose(*run.run));
  EXPECT_NE(pose(*unpushed), pose(*run.run));
}

TEST(SimulationDesk, ItsRecordNamesTheWorld) {
  const process::PrivateFolder folder("gaitway_desk_world_test");
  const std::filesystem::path world = folder.path() / "course.yaml", file = folder.path() / "commands.yaml";
  process::write_text_file(world, "boxes: [{name: crate, position_m: [2, 0], size_m: [0.3, 0.3, 0.3]}]\n");
  simulator::CosimulationOptions options;
  options.plant.world = world::read_world(world, 7);
  options.main_controller.configuration = GAITWAY_CONFIGURATION;
  options.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
  simulator::Cosimulation run(robot(), options);
  process::write_text_file(file, simulator::CommandLog(run).scenario(1.0));
  const simulator::Scenario scenario = simulator::load_scenario(file, robot());
  ASSERT_TRUE(scenario.world);
  const world::World again = world::load_world(*scenario.world);
  EXPECT_EQ(again.file, world);
  EXPECT_EQ(again.random_seed, 7U);
  EXPECT_EQ(again.solids.at(0).name, "crate");
}

// A release is answered slots after it began, and its replay begins when it did.
TEST(CommandLog, WhatPeopleAskedIsLoggedWhenItBegan) {
  const std::vector<simulator::ScenarioEvent> asked{
      {.at_s = 1.207, .action = simulator::EmergencyStopEvent{}, .asked = true},
      {.at_s = 2.114, .action = simulator::ReleaseEvent{}, .asked = true},
      {.at_s = 3.5, .action = simulator::StopEvent{}, .asked = true}};
  const auto run = new_run();
  simulator::CommandLog log(*run);
  auto next = asked.begin();
  while (run->now_ns() < 4'000'000'000) {
    for (; next != asked.end() && std::llround(next->at_s * 1e9) <= run->now_ns(); ++next) run->apply(*next);
    const std::int64_t began_ns = run->now_ns();
    run->advance_millisecond();
    log.on_millisecond(began_ns);
  }
  ASSERT_EQ(log.events().size(), asked.size());
  for (std::size_t i = 0; i < asked.size(); ++i) {
    EXPECT_NEAR(log.events()[i].at_s, asked[i].at_s, 1e-9);
    EXPECT_EQ(log.events()[i].action.index(), asked[i].action.index());
    EXPECT_TRUE(log.events()[i].asked);
  }
}

}  // namespace
}  // namespace gaitway::scenarios
