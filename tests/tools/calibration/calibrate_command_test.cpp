// `gaitway calibrate` as a user meets it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "command_run.hpp"
#include "robots/robot_variants.hpp"

namespace gaitway::calibration {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

using gaitway::test::text_of;

class CalibrateCommand : public ::testing::Test {
 protected:
  CalibrateCommand() { std::filesystem::create_directory(folder_); }
  ~CalibrateCommand() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string file(const char* name) const { return (folder_ / name).string(); }
  int run(const std::string& arguments) {
    const gaitway::test::CommandRun run =
        gaitway::test::run_command(std::string(GAITWAY_COMMAND) + " calibrate " + arguments);
    said_ = run.said;
    complaint_ = run.complaint;
    return run.code;
  }
  void expect_refused(const std::string& arguments, const char* part) {
    EXPECT_EQ(run(arguments), 1) << arguments;
    EXPECT_THAT(complaint_, HasSubstr(part));
    EXPECT_EQ(said_, "");
  }

  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("gaitway-calibrate-" + std::to_string(getpid()));
  std::string said_, complaint_;
};

TEST_F(CalibrateCommand, what_it_recorded_gives_the_calibration_that_it_found) {
  ASSERT_EQ(run("--simulate --seed 4 --rounds 1 --measure-s 0.3 --out " + file("found.yaml") + " --record " +
                file("poses.yaml")),
            0)
      << complaint_;
  EXPECT_THAT(said_, AllOf(HasSubstr("left_knee"), HasSubstr("truth"), HasSubstr("the poses cannot tell")));
  const std::string found = text_of(file("found.yaml"));
  EXPECT_THAT(found, AllOf(HasSubstr("robot: humanoid22"), HasSubstr("force_cell_gains")));
  ASSERT_EQ(run("--measurements " + file("poses.yaml") + " --out " + file("again.yaml")), 0) << complaint_;
  EXPECT_THAT(said_, testing::Not(HasSubstr("truth")));
  const auto zero_of = [](const std::string& text, const std::string& joint) {
    const std::string key = joint + ": {value: ";
    const std::size_t place = text.find(key);
    return place == std::string::npos ? 1e9 : std::stod(text.substr(place + key.size()));
  };
  const std::string again = text_of(file("again.yaml"));
  for (const char* const joint : {"left_hip_roll", "right_ankle_pitch", "waist_pitch"}) {
    EXPECT_NEAR(zero_of(again, joint), zero_of(found, joint), 0.002) << joint;
  }
  // Another robot's cells: 40 % off is no gain.
  std::string spoilt = text_of(file("poses.yaml"));
  for (std::size_t at = 0; (at = spoilt.find("left_knee: ", at)) != std::string::npos; ++at) {
    spoilt.replace(at, 12, "left_knee: 4");
  }
  std::ofstream(file("spoilt.yaml")) << spoilt;
  EXPECT_EQ(run("--measurements " + file("spoilt.yaml")), 3) << said_;
  EXPECT_THAT(complaint_, HasSubstr("unexplained"));
}

TEST_F(CalibrateCommand, refuses_bad_input) {
  expect_refused("", "either --simulate or --measurements");
  expect_refused("--simulate --measurements x.yaml", "one of them alone");
  expect_refused("--simulate --mismatch -1", "between 0 and 10");
  expect_refused("--simulate --rounds 0", "between 1 and 10");
  expect_refused("--simulate --measure-s 100", "between 0.1 and 60");
  expect_refused("--simulate --measure-s 5", "no pose is held");
  expect_refused("--simulate --seeds 3 --out x.yaml", "of one robot");
  expect_refused("--measurements /nowhere.yaml", "/nowhere.yaml");
  expect_refused("--bus-log /nowhere.log", "/nowhere.log");
  expect_refused("--bus-log x --simulate", "one of them alone");
  std::ofstream(file("silent.log")) << "(0.000075) can0 008#000000\n";
  expect_refused("--bus-log " + file("silent.log"), "in 0 poses");
  expect_refused("--simulat", "--simulate");
}

// humanoid22's would be out of its reach.
TEST_F(CalibrateCommand, another_body_takes_the_shipped_poses_in_its_own_size) {
  test::RobotVariant variant;
  variant.scale(0.7);
  EXPECT_NE(run("--simulate --seed 4 --rounds 1 --measure-s 0.3 --robot '" + variant.folder().string() + "'"),
            1)
      << complaint_;
  EXPECT_THAT(said_, HasSubstr("left_knee"));
}

}  // namespace
}  // namespace gaitway::calibration
