// Worlds as a user meets them: `gaitway run --world`, scenarios with one, `gaitway world`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

namespace gaitway::tools {
namespace {

using testing::HasSubstr;

class WorldCommand : public ::testing::Test {
 protected:
  WorldCommand()
      : folder_(std::filesystem::temp_directory_path() /
                ("gaitway_world_command_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~WorldCommand() override { std::filesystem::remove_all(folder_); }

  static std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  // What it says is in said_ and complaint_.
  int gaitway(const std::string& arguments) {
    const std::string line = std::string(GAITWAY_COMMAND) + " " + arguments + " >'" +
                             (folder_ / "said").string() + "' 2>'" + (folder_ / "complaint").string() + "'";
    const int code = WEXITSTATUS(std::system(line.c_str()));
    said_ = text_of(folder_ / "said");
    complaint_ = text_of(folder_ / "complaint");
    return code;
  }
  int run(const std::string& arguments) {
    return gaitway("run --no-pictures --out '" + (folder_ / "out").string() + "' " + arguments);
  }
  [[nodiscard]] nlohmann::json summary() const {
    return nlohmann::json::parse(text_of(folder_ / "out" / "summary.json"));
  }

  std::filesystem::path folder_;
  std::string said_, complaint_;
};

TEST_F(WorldCommand, ARunInAShippedWorldTellsThatNothingWasTouched) {
  ASSERT_EQ(run("--world boxes --seconds 3"), 0) << complaint_;
  EXPECT_THAT(said_, HasSubstr("body contacts             none"));
  EXPECT_EQ(summary().at("world").at("name"), "boxes");
  EXPECT_EQ(summary().at("contacts").at("total"), 0);
  EXPECT_THAT(text_of(folder_ / "out" / "report.html"), HasSubstr("<title>box 'carton box 1'</title>"));
}

TEST_F(WorldCommand, AContactIsToldWithLinkThingForceAndTime) {
  const std::string world =
      write("wall.yaml", "walls: [{name: north, from_m: [0.4, -1], to_m: [0.4, 1], height_m: 1}]\n");
  (void)run("--world " + world + " --seconds 5");
  const nlohmann::json contacts = summary().at("contacts");
  ASSERT_GT(contacts.at("total"), 0);
  const nlohmann::json first = contacts.at("first").at(0);
  EXPECT_EQ(first.at("with"), "north");
  EXPECT_EQ(first.at("kind"), "wall");
  EXPECT_GT(first.at("peak_N"), 0.0);
  EXPECT_GT(first.at("from_s"), 1.5);
  EXPECT_THAT(said_, HasSubstr(first.at("link").get<std::string>() + " touches wall 'north': "));
}

TEST_F(WorldCommand, AScenarioNamesItsWorldAndTheOptionOverrulesIt) {
  (void)write("crate.yaml", "boxes: [{name: crate, position_m: [2, 0], size_m: [0.3, 0.3, 0.3]}]\n");
  const std::string scenario =
      write("walk.yaml",
            "seconds: 1.5\nworld: crate.yaml\nworld_seed: 5\nevents:\n  - {at_s: 1.0, walk: [0.1, 0, 0]}\n");
  ASSERT_EQ(run("--scenario " + scenario), 0) << complaint_;
  EXPECT_EQ(summary().at("world").at("name"), "crate");
  EXPECT_EQ(summary().at("world").at("random_seed"), 5);
  ASSERT_EQ(run("--scenario " + scenario + " --world empty"), 0) << complaint_;
  EXPECT_EQ(summary().at("world").at("name"), "empty");
}

TEST_F(WorldCommand, BadWorldsAreRefusedAndNothingMoves) {
  const auto expect_refused = [&](const std::string& arguments, const std::vector<std::string>& parts) {
    EXPECT_EQ(run(arguments), 1) << arguments;
    for (const std::string& part : parts) EXPECT_THAT(complaint_, HasSubstr(part));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out" / "summary.json"));
  };
  expect_refused("--world boxs", {"--world: world = 'boxs'", "Did you mean 'boxes'?"});
  expect_refused("--world-seed 3", {"--world-seed: needs a world"});
  expect_refused("--world " + write("key.yaml", "boxs: []\n"), {"key.yaml:1: ", "Did you mean 'boxes'?"});
  expect_refused("--world " + write("inside.yaml",
                                    "start: {position_m: [1, 0]}\n"
                                    "boxes: [{name: crate, position_m: [1, 0], size_m: [1, 1, 1]}]\n"),
                 {"inside.yaml:1: start: the robot's ", "inside of box 'crate'"});
  expect_refused("--world " + write("large.yaml", "boxes: [{position_m: [50, 0], size_m: [1, 1, 1]}]\n"),
                 {"large.yaml:1: ", "the world is too large"});
  expect_refused("--scenario " + write("none.yaml", "seconds: 1\nworld: nowhere\n"),
                 {"none.yaml:2: world = 'nowhere': there is no such file"});
  expect_refused("--scenario " + write("seed.yaml", "seconds: 1\nworld_seed: 2\n"),
                 {"seed.yaml:2: world_seed", "needs a world"});
  expect_refused(
      "--world empty --scenario " + write("tiles.yaml", "seconds: 1\nconditions: {tiles_m: 0.005}\n"),
      {"the world 'empty' has a ground of its own"});
}

TEST_F(WorldCommand, ListsChecksAndDraws) {
  ASSERT_EQ(gaitway("world list"), 0) << complaint_;
  for (const char* const name : {"boxes", "course", "doorway", "empty", "rough", "slalom", "stairs"}) {
    EXPECT_THAT(said_, HasSubstr(name));
  }
  ASSERT_EQ(gaitway("world check boxes"), 0) << complaint_;
  EXPECT_THAT(said_, HasSubstr("45 boxes, 4 walls"));
  EXPECT_THAT(said_, HasSubstr("has room at its start"));
  EXPECT_EQ(gaitway("world check " + write("bad.yaml", "walls: 3\n")), 1);
  EXPECT_THAT(complaint_, HasSubstr("bad.yaml:1: walls = '3': must be a list"));
  EXPECT_EQ(gaitway("world check " + write("in.yaml", "boxes: [{position_m: [0, 0], size_m: [1, 1, 1]}]\n")),
            1);
  EXPECT_THAT(complaint_, HasSubstr("inside of box 'box 1'"));
  const std::filesystem::path picture = folder_ / "boxes.png";
  ASSERT_EQ(gaitway("world draw boxes --world-seed 2 --out '" + picture.string() + "'"), 0) << complaint_;
  EXPECT_GT(std::filesystem::file_size(picture), 20'000U);
}

}  // namespace
}  // namespace gaitway::tools
