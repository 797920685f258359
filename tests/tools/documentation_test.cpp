// docs/first-plugin.md shows what is built, and the examples beside it walk.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "gaitway/simulator/simulated_robot.hpp"

namespace gaitway {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(std::filesystem::path(GAITWAY_SOURCE_DIR) / file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> blocks(const std::string& document, const std::string& language) {
  std::vector<std::string> found;
  const std::string open = "```" + language + "\n";
  for (std::size_t at = document.find(open); at != std::string::npos; at = document.find(open, at)) {
    at += open.size();
    found.push_back(document.substr(at, document.find("```", at) - at));
  }
  return found;
}

// A template as `gaitway new-plugin dance` writes it.
std::string as_dance(std::string text) {
  for (const auto& [token, name] : {std::pair{"PluginName", "Dance"}, std::pair{"plugin_name", "dance"}}) {
    for (std::size_t at = text.find(token); at != std::string::npos; at = text.find(token, at)) {
      text.replace(at, std::string(token).size(), name);
    }
  }
  return text;
}

std::string example(const std::string& name) {
  return std::string(GAITWAY_PLUGIN_DIR) + "/libgaitway_plugin_" + name + ".so";
}

TEST(FirstPlugin, EverySnippetIsBuilt) {
  const std::vector<std::string> built{as_dance(text_of("tools/new_plugin/templates/trajectory.cpp")),
                                       as_dance(text_of("tools/new_plugin/templates/trajectory_test.cpp")),
                                       text_of("docs/examples/dance.cpp")};
  const std::vector<std::string> snippets = blocks(text_of("docs/first-plugin.md"), "cpp");
  ASSERT_GE(snippets.size(), 6U);
  for (const std::string& snippet : snippets) {
    EXPECT_TRUE(std::any_of(built.begin(), built.end(), [&snippet](const std::string& file) {
      return file.find(snippet) != std::string::npos;
    })) << snippet;
  }
}

TEST(FirstPlugin, TheRobotDances) {
  SimulatedRobot robot({.with = {example("dance")}});
  robot.run_for(1.0);
  robot.walk(0.1);
  double left_m = 0.0, right_m = 0.0;
  while (robot.is_upright() && robot.time_s() < 14.0) {
    const double before_m = robot.whereabouts().y_m;
    robot.run_for(2.0);
    left_m = std::max(left_m, robot.whereabouts().y_m - before_m);
    right_m = std::max(right_m, before_m - robot.whereabouts().y_m);
  }
  ASSERT_TRUE(robot.is_upright());
  EXPECT_EQ(robot.faults("dance"), 0U);
  EXPECT_GT(robot.whereabouts().x_m, 0.8);
  EXPECT_GT(left_m, 0.02);
  EXPECT_GT(right_m, 0.02);
}

TEST(PluginInC, TheRobotWalksAndNods) {
  SimulatedRobot robot({.with = {example("nod")}});
  robot.run_for(1.0);
  robot.walk(0.12);
  robot.run_for(12.0);
  ASSERT_TRUE(robot.is_upright());
  EXPECT_EQ(robot.faults("nod"), 0U);
  EXPECT_GT(robot.whereabouts().x_m, 1.0);
  double lowest_rad = 1.0, highest_rad = -1.0;
  for (int i = 0; i < 40; ++i) {
    robot.run_for(0.05);
    const double bow_rad = robot.topic<Correction>("correction").base_attitude_offset[1];
    lowest_rad = std::min(lowest_rad, bow_rad);
    highest_rad = std::max(highest_rad, bow_rad);
  }
  EXPECT_NEAR(lowest_rad, 0.0, 0.005);
  EXPECT_NEAR(highest_rad, 0.03, 0.005);
}

TEST(SimulatedRobot, SaysWhatIsWrong) {
  SimulatedRobot robot;
  EXPECT_THROW((void)robot.joint_position("nose"), std::invalid_argument);
  EXPECT_THROW((void)robot.faults("nobody"), std::invalid_argument);
  EXPECT_THROW((void)robot.topic<WalkCommand>("unknown_topic"), std::runtime_error);
  EXPECT_THROW(SimulatedRobot({.with = {"nowhere.so"}}), std::runtime_error);
}

TEST(SimulatedRobot, IsTheSameForTheSameSeed) {
  const auto walked = [](std::uint64_t seed) {
    SimulatedRobot robot({.seed = seed});
    robot.run_for(1.0);
    robot.walk(0.15, 0.0, 0.1);
    robot.run_for(3.0);
    return robot.whereabouts().x_m;
  };
  EXPECT_EQ(walked(3), walked(3));
  EXPECT_NE(walked(3), walked(4));
}

}  // namespace
}  // namespace gaitway
