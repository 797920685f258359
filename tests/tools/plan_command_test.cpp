// `gaitway plan` as a user meets it: ways through shipped worlds, reasons where there is none, pictures, and
// what it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "command_run.hpp"
#include "gaitway/navigation/robot_limits.hpp"
#include "gaitway/trajectory/gait_choice.hpp"

namespace gaitway::tools {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

class PlanCommand : public ::testing::Test {
 protected:
  PlanCommand() : folder_(fs::temp_directory_path() / ("gaitway_plan_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~PlanCommand() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  static test::CommandRun plan(const std::string& arguments) {
    return test::run_command(std::string(GAITWAY_PLAN_COMMAND) + " plan " + arguments);
  }

  fs::path folder_;
};

TEST_F(PlanCommand, FindsAWayThroughAShippedWorld) {
  const test::CommandRun run = plan("--world boxes --to 2,2,90 --json");
  ASSERT_EQ(run.code, 0) << run.all();
  const json told = json::parse(run.said);
  EXPECT_EQ(told.at("world"), "boxes");
  EXPECT_TRUE(told.at("found"));
  const json& steps = told.at("steps");
  ASSERT_GT(steps.size(), 15U);
  EXPECT_GE(told.at("bound"), 1.0);
  for (std::size_t i = 1; i < steps.size(); ++i) EXPECT_NE(steps[i].at("foot"), steps[i - 1].at("foot"));
  double x_m = 0.0, y_m = 0.0;
  for (std::size_t i = steps.size() - 2; i < steps.size(); ++i) {
    x_m += 0.5 * steps[i].at("x_m").get<double>();
    y_m += 0.5 * steps[i].at("y_m").get<double>();
    EXPECT_NEAR(steps[i].at("yaw_deg"), 90.0, 1e-6);
  }
  EXPECT_NEAR(x_m, 2.0, 1e-6);
  EXPECT_NEAR(y_m, 2.0, 1e-6);
  EXPECT_EQ(plan("--world boxes --to 2,2,90 --json").said, run.said);
}

TEST_F(PlanCommand, TellsStepsAndDrawsThem) {
  const fs::path picture = folder_ / "way.png";
  const test::CommandRun run = plan("--world stairs --to 2.3,0,0 --picture '" + picture.string() + "'");
  ASSERT_EQ(run.code, 0) << run.all();
  EXPECT_THAT(run.said, HasSubstr("steps, cost "));
  EXPECT_THAT(run.said, HasSubstr("30\n"));  // mm: on the landing
  EXPECT_GT(fs::file_size(picture), 5'000U);
  EXPECT_EQ(plan("--world empty --from 1,0,20 --to 1,0,20").said, "the feet are there already\n");
}

TEST_F(PlanCommand, NoWayIsToldWithItsReason) {
  const std::string closed = write("closed.yaml",
                                   "walls: [{from_m: [1, -2], to_m: [1, 2], height_m: 1}, {from_m: [-1, -2], "
                                   "to_m: [-1, 2], height_m: 1},\n"
                                   "        {from_m: [-1, 2], to_m: [1, 2], height_m: 1}, {from_m: [-1, -2], "
                                   "to_m: [1, -2], height_m: 1}]\n");
  const fs::path picture = folder_ / "none.png";
  test::CommandRun run = plan("--world " + closed + " --to 2,0,0 --picture '" + picture.string() + "'");
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.complaint, HasSubstr("no way (enclosed): "));
  EXPECT_TRUE(fs::exists(picture));
  run = plan("--world " + closed + " --to 1,0,0 --json");
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(json::parse(run.said).at("reason"), "goal_in_obstacle");
  EXPECT_EQ(json::parse(plan("--world " + closed + " --from 1,0,0 --to 0,0,0 --json").said).at("reason"),
            "start_in_obstacle");
  EXPECT_EQ(json::parse(plan("--world empty --to 1000,0,0 --json").said).at("reason"), "goal_outside_map");
}

TEST_F(PlanCommand, BadInputIsRefused) {
  const auto expect_refused = [](const std::string& arguments, const std::string& part) {
    const test::CommandRun run = plan(arguments);
    EXPECT_EQ(run.code, 1) << arguments;
    EXPECT_THAT(run.complaint, HasSubstr(part));
    EXPECT_EQ(run.said, "");
  };
  expect_refused("--world boxs --to 1,0,0", "Did you mean 'boxes'?");
  expect_refused("--world boxes", "--to");
  expect_refused("--world boxes --to 1,0", "--to");
  expect_refused("--world boxes --to 1,nan,0", "--to");
  expect_refused("--world boxes --to 1e300,0,0", "1000");
  expect_refused("--world boxes --from -1e300,0,0 --to 0,0,0", "1000");
  expect_refused("--world boxes --to 1,0,0 --robot nowhere", "nowhere");
  expect_refused("--world empty --to 1,0,0 --picture '" + (folder_ / "no" / "way.png").string() + "'",
                 "way.png");
  EXPECT_THAT(plan("--help").said, HasSubstr("Examples:"));
}

// The planner's limits are the gait's, and the body's outline has the robot's own size.
TEST(RobotLimits, AreThoseOfTheGaitAndTheBody) {
  const urdf::RobotModel robot = urdf::load_robot(fs::path(GAITWAY_URDF_DIR) / "humanoid22");
  const trajectory::GaitParameters gait = trajectory::choose_gait(robot).parameters;
  const planning::Limits limits = navigation::limits_of(robot);
  EXPECT_EQ(limits.max_step_forward_m, gait.max_step_forward_m);
  EXPECT_EQ(limits.max_step_turn_rad, gait.max_step_turn_rad);
  EXPECT_EQ(limits.min_sole_gap_m, gait.min_sole_gap_m);
  EXPECT_NEAR(limits.height_m, 0.81, 0.03);
  ASSERT_EQ(limits.bands.size(), 3U);
  double widest_m = 0.0;
  for (const Eigen::Vector2d& corner : limits.bands.back().outline_m)
    widest_m = std::max(widest_m, corner.y());
  EXPECT_NEAR(widest_m, 0.165, 0.05);
  for (const Eigen::Vector2d& corner : limits.bands.front().outline_m) EXPECT_LT(corner.y(), 0.12);
  EXPECT_NEAR(navigation::cell_for(limits), 0.010, 1e-9);
}

}  // namespace
}  // namespace gaitway::tools
