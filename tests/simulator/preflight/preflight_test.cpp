// What is tried on many simulated robots before it is sent to one.
#include "gaitway/preflight/preflight.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "gaitway/process/private_folder.hpp"
#include "gaitway/world/world_file.hpp"

namespace gaitway::preflight {
namespace {

using testing::HasSubstr;

const std::filesystem::path& source_tree() {
  static const std::filesystem::path tree = GAITWAY_SOURCE_DIR;
  return tree;
}

const urdf::RobotModel& humanoid22() {
  static const urdf::RobotModel robot = urdf::load_robot(source_tree() / "urdf/humanoid22");
  return robot;
}

PreflightOptions with(int robots) {
  PreflightOptions options;
  options.robot.main_controller.configuration = source_tree() / "core/config/walk.yaml";
  options.robot.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
  options.robots = robots;
  return options;
}

simulator::ScenarioEvent push(double at_s, double impulse_Ns) {
  return {at_s,
          simulator::PushEvent{.body = "trunk", .direction = {0.0, 1.0, 0.0}, .impulse_Ns = impulse_Ns}};
}

const Flight kWalk{.events = {{1.0, simulator::WalkEvent{.velocity_m_per_s = {0.15, 0.0}}}}, .seconds = 4.0};

TEST(Preflight, AWalkThatRobotsBearPasses) {
  const Verdict verdict = fly(humanoid22(), kWalk, with(4));
  ASSERT_EQ(verdict.trials.size(), 4U);
  EXPECT_TRUE(verdict.all_passed()) << verdict_text(verdict);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(verdict.trials[i].seed, i + 1);
    EXPECT_NEAR(verdict.trials[i].ended_s, 4.0, 1e-6);
    EXPECT_GT(verdict.trials[i].largest_tilt_rad, 0.0);
  }
  EXPECT_NE(verdict.trials[0].largest_tilt_rad, verdict.trials[1].largest_tilt_rad)
      << "each is another robot";
  EXPECT_THAT(verdict_text(verdict), HasSubstr("4 of 4"));
}

TEST(Preflight, WhatFellsThemDoesNot) {
  Flight flight = kWalk;
  flight.events.push_back(push(2.0, 15.0));
  const Verdict verdict = fly(humanoid22(), flight, with(3));
  EXPECT_EQ(verdict.passed(), 0);
  EXPECT_TRUE(verdict.worst().fell);
  EXPECT_GT(verdict.worst().ended_s, 2.0);
  EXPECT_LT(verdict.worst().ended_s, 4.0);
  for (const Trial& trial : verdict.trials) EXPECT_LE(verdict.worst().ended_s, trial.ended_s);
  EXPECT_THAT(verdict_text(verdict),
              AllOf(HasSubstr("NOT passed"), HasSubstr("0 of 3"), HasSubstr("fell after")));
  EXPECT_EQ(verdict_json(verdict).at("passed"), 0);
}

// Between the two: some stay up, and that is not enough.
TEST(Preflight, OneThatFallsIsEnough) {
  Verdict verdict;
  verdict.trials.resize(3);
  for (std::size_t i = 0; i < 3; ++i) verdict.trials[i].seed = i + 1;
  verdict.trials[1].fell = true;
  verdict.trials[1].ended_s = 3.0;
  EXPECT_FALSE(verdict.all_passed());
  EXPECT_EQ(verdict.passed(), 2);
  EXPECT_EQ(verdict.worst().seed, 2U);
}

TEST(Preflight, TheVerdictDoesNotDependOnTheProcessors) {
  Flight flight = kWalk;
  flight.events.push_back(push(2.0, 4.0));
  PreflightOptions alone = with(4), together = with(4);
  alone.processes = 1;
  together.processes = 3;
  auto a = verdict_json(fly(humanoid22(), flight, alone)),
       b = verdict_json(fly(humanoid22(), flight, together));
  a.erase("wall_s");
  b.erase("wall_s");
  EXPECT_EQ(a, b);
}

TEST(Preflight, WhatTheRobotRefusesDoesNotPass) {
  const Flight flight{.events = {{1.0, simulator::MotionEvent{"somersault"}}}, .seconds = 2.0};
  const Verdict verdict = fly(humanoid22(), flight, with(2));
  EXPECT_EQ(verdict.passed(), 0);
  EXPECT_FALSE(verdict.worst().fell);
  EXPECT_THAT(verdict.worst().refusal, HasSubstr("somersault"));
}

TEST(Preflight, WhatHasNotBeenDoneInItsTimeDoesNotPass) {
  const Flight wave{.events = {{1.0, simulator::MotionEvent{"wave"}}}, .seconds = 2.0};
  const Verdict verdict = fly(humanoid22(), wave, with(1));
  EXPECT_FALSE(verdict.all_passed());
  EXPECT_THAT(verdict.worst().refusal, HasSubstr("has not ended within 2 s"));
  Flight longer = wave;
  longer.seconds = 12.0;
  EXPECT_TRUE(fly(humanoid22(), longer, with(1)).all_passed());
}

TEST(Preflight, AWayMustArrive) {
  PreflightOptions options = with(1);
  options.robot.main_controller.plugins = core::read_configuration(source_tree() / "core/config/walk.yaml");
  core::PluginEntry& navigation = options.robot.main_controller.plugins->plugins.emplace_back();
  navigation.name = "navigation";
  navigation.library = "libgaitway_plugin_navigation.so";
  navigation.parameters = {{"plans_in_step", "true", 0},
                           {"world", (source_tree() / "tools/worlds/empty.yaml").string(), 0}};
  options.robot.localization.is_there = true;
  options.robot.plant.world = world::read_world(source_tree() / "tools/worlds/empty.yaml");
  Flight flight{.events = {{1.0, simulator::WalkToEvent{std::array{0.5, 0.0, 0.0}}}}, .seconds = 3.0};
  EXPECT_THAT(fly(humanoid22(), flight, options).worst().refusal, HasSubstr("has not arrived within 3 s"));
  flight.seconds = 15.0;
  const Verdict verdict = fly(humanoid22(), flight, options);
  EXPECT_TRUE(verdict.all_passed()) << verdict_text(verdict);
}

TEST(Preflight, ContactsAreTold) {
  PreflightOptions options = with(1);
  options.robot.plant.world = world::read_world(source_tree() / "tools/worlds/doorway.yaml");
  const Flight flight{.events = {{0.5, simulator::SpawnEvent{.name = "wall",
                                                             .size_m = {0.2, 2.0, 1.0},
                                                             .position_m = {0.6, 0.0, 0.5},
                                                             .mass_kg = std::nullopt}},
                                 {1.0, simulator::WalkEvent{.velocity_m_per_s = {0.15, 0.0}}}},
                      .seconds = 8.0};
  const Verdict verdict = fly(humanoid22(), flight, options);
  EXPECT_GT(verdict.trials[0].body_contacts, 0U);
  EXPECT_THAT(verdict.trials[0].first_contact, HasSubstr("touches wall"));
}

TEST(Preflight, BeginsInThePostureOfTheRobot) {
  PreflightOptions options = with(2);
  for (const urdf::Joint& joint : humanoid22().joints) {
    const double bend_rad = joint.name.ends_with("knee")          ? 0.5
                            : joint.name.ends_with("ankle_pitch") ? -0.5
                                                                  : 0.0;
    options.robot.plant.start_rad.push_back(joint.home_rad + bend_rad);
  }
  const Verdict leaning = fly(humanoid22(), kWalk, options), upright = fly(humanoid22(), kWalk, with(2));
  EXPECT_GT(leaning.worst().largest_tilt_rad, upright.worst().largest_tilt_rad + 0.05);
}

TEST(Preflight, WhatCannotBeFlownIsRefused) {
  EXPECT_THROW(static_cast<void>(fly(humanoid22(), kWalk, with(0))), std::invalid_argument);
  Flight nothing = kWalk;
  nothing.seconds = 0.0;
  EXPECT_THROW(static_cast<void>(fly(humanoid22(), nothing, with(1))), std::invalid_argument);
  PreflightOptions options = with(1);
  options.robot.plant.start_rad = {0.0};
  try {
    static_cast<void>(fly(humanoid22(), kWalk, options));
    ADD_FAILURE() << "flown";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("has 22 joints, not 1"));
  }
}

TEST(Preflight, ThePictureShowsTheFall) {
  Flight flight = kWalk;
  flight.events.push_back(push(2.0, 15.0));
  const PreflightOptions options = with(1);
  const Verdict verdict = fly(humanoid22(), flight, options);
  const process::PrivateFolder folder("gaitway_preflight");
  draw_trial(folder.path() / "worst.png", humanoid22(), flight, options, verdict.worst());
  EXPECT_GT(std::filesystem::file_size(folder.path() / "worst.png"), 10'000U);
}

}  // namespace
}  // namespace gaitway::preflight
