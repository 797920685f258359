// `gaitway robot import` as a user meets it: what it writes, what it leaves alone, and what it says of files
// that it cannot bring.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "command_run.hpp"
#include "gaitway/process/private_folder.hpp"
#include "importer/generated_humanoid.hpp"
#include "tools/robot/import_page.hpp"

namespace gaitway::tools {
namespace {

using gaitway::test::text_of;
using importer::test::Humanoid;
using testing::HasSubstr;

class RobotImport : public testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

  // The exit code; what it printed is in `said_`.
  int command(const std::string& arguments) {
    const gaitway::test::CommandRun run =
        gaitway::test::run_command(std::string(GAITWAY_ROBOT_COMMAND) + " robot " + arguments);
    said_ = run.all();
    return run.code;
  }
  int import(const Humanoid& humanoid, const std::string& options = "") {
    const std::filesystem::path file = importer::test::write_humanoid(humanoid, path("maker"));
    return command("import '" + file.string() + "' --out '" + path("robots/new").string() + "' " + options);
  }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::ofstream(path(name)) << text;
  }
  // Nothing lies beside the robot's folder: no folder in the making was left.
  void expect_alone(const std::string& parent, std::size_t entries) const {
    const auto all = std::filesystem::directory_iterator(path(parent));
    EXPECT_EQ(static_cast<std::size_t>(std::distance(begin(all), end(all))), entries);
  }

  process::PrivateFolder folder_{"gaitway-import"};
  std::string said_;
};

TEST_F(RobotImport, WritesAFolderThatIsDescribedWithAPageAndAPicture) {
  ASSERT_EQ(import({}), 0) << said_;
  for (const char* const part : {"60", "left_knee", "gaitway robot check"})
    EXPECT_THAT(said_, HasSubstr(part));
  for (const char* const file : {"robot.urdf", "robot.yaml", "import.html"}) {
    EXPECT_TRUE(std::filesystem::is_regular_file(path("robots/new") / file)) << file;
  }
  EXPECT_TRUE(std::filesystem::exists(path("robots/new/robot.png")) ||
              said_.find("no picture") != said_.npos);
  EXPECT_THAT(text_of(path("robots/new/import.html")), HasSubstr("left_knee"));
  EXPECT_THAT(text_of(path("robots/new/robot.yaml")), HasSubstr("guess"));
  expect_alone("robots", 1);
  EXPECT_NE(command("describe '" + path("robots/new").string() + "'"), 1) << said_;
}

TEST_F(RobotImport, OverwritesNothingUnaskedAndWithForceOnlyItsOwn) {
  ASSERT_EQ(import({}, "--quiet"), 0) << said_;
  write("robots/new/robot.yaml", text_of(path("robots/new/robot.yaml")) + "# corrected\n");
  write("robots/new/notes.txt", "mine\n");
  write("robots/new/meshes/mine.stl", "mine\n");
  EXPECT_EQ(import({}), 1);
  EXPECT_THAT(said_, testing::AllOf(HasSubstr("is there already"), HasSubstr("--force")));
  EXPECT_THAT(text_of(path("robots/new/robot.yaml")), HasSubstr("# corrected"));
  ASSERT_EQ(import({}, "--force --quiet"), 0) << said_;
  EXPECT_THAT(text_of(path("robots/new/robot.yaml")), testing::Not(HasSubstr("# corrected")));
  EXPECT_EQ(text_of(path("robots/new/notes.txt")), "mine\n");
  EXPECT_EQ(text_of(path("robots/new/meshes/mine.stl")), "mine\n");
  expect_alone("robots", 1);
}

TEST_F(RobotImport, EvenWithForceReplacesNothingThatNoImportWrote) {
  write("robots/new/robot.yaml", "mine\n");
  for (const char* const force : {"", "--force"}) {
    EXPECT_EQ(import({}, force), 1);
    EXPECT_THAT(said_, testing::AllOf(HasSubstr("no import wrote"), testing::Not(HasSubstr("--force"))))
        << force;
  }
  EXPECT_EQ(text_of(path("robots/new/robot.yaml")), "mine\n");
  expect_alone("robots/new", 1);
}

TEST_F(RobotImport, NeverWritesIntoTheFolderThatItReads) {
  const std::filesystem::path urdf = importer::test::write_humanoid(
      {.foot = importer::test::FootShape::tapered_mesh}, path("generated/urdf"));
  for (const char* const out : {"generated", "generated/urdf", "generated/urdf/."}) {
    EXPECT_EQ(command("import '" + urdf.string() + "' --force --out '" + path(out).string() + "'"), 1);
    EXPECT_THAT(said_, HasSubstr("is read from there")) << out;
  }
  EXPECT_TRUE(std::filesystem::exists(path("generated/urdf/left_foot.stl")));
  expect_alone("generated", 1);
}

TEST_F(RobotImport, IntoALinkedFolderStaysThere) {
  std::filesystem::create_directories(path("elsewhere/new"));
  std::filesystem::create_directories(path("robots"));
  std::filesystem::create_directory_symlink(path("elsewhere/new"), path("robots/new"));
  ASSERT_EQ(import({}, "--quiet"), 0) << said_;
  ASSERT_EQ(import({}, "--quiet --force"), 0) << said_;
  EXPECT_TRUE(std::filesystem::is_symlink(path("robots/new")));
  EXPECT_TRUE(std::filesystem::exists(path("elsewhere/new/robot.urdf")));
  expect_alone("robots", 1);
}

TEST_F(RobotImport, LeavesNothingBehindWhenItFails) {
  Humanoid endless;
  endless.endless_knees = true;
  EXPECT_EQ(import(endless), 1);
  EXPECT_THAT(said_, testing::AllOf(HasSubstr("robot.urdf"), HasSubstr("left_knee"), HasSubstr("limit")));
  EXPECT_FALSE(std::filesystem::exists(path("robots/new")));
  EXPECT_FALSE(std::filesystem::exists(path("robots")));
  ASSERT_EQ(import({}, "--quiet"), 0) << said_;
  const std::string before = text_of(path("robots/new/robot.yaml"));
  EXPECT_EQ(import(endless, "--force"), 1);
  EXPECT_EQ(text_of(path("robots/new/robot.yaml")), before);
  expect_alone("robots", 1);
  EXPECT_EQ(command("import '" + path("nowhere.urdf").string() + "'"), 1);
  EXPECT_THAT(said_, HasSubstr("nowhere.urdf"));
}

TEST(ImportPicture, ShowsABodyThatItsMakerDrewBlack) {
  urdf::RobotModel robot = urdf::load_robot(GAITWAY_URDF_DIR "/humanoid22");
  std::vector<urdf::Shape>& drawn = robot.links.front().visual;
  ASSERT_GE(drawn.size(), 1U);
  drawn.resize(1);
  drawn.insert(drawn.end(), 2, drawn.front());
  drawn[0].rgba = {0.0, 0.0, 0.0, 0.5};
  drawn[1].rgba = {0.2, 0.0, 0.0, 1.0};
  drawn[2].rgba = {0.1, 0.4, 0.7, 1.0};
  const std::vector<urdf::Shape> seen = with_visible_colours(robot).links.front().visual;
  EXPECT_GE(seen[0].rgba.head<3>().minCoeff(), 0.2);
  EXPECT_EQ(seen[0].rgba[3], 0.5) << "as transparent as before";
  EXPECT_GE(seen[1].rgba.head<3>().mean(), 0.2);
  EXPECT_GT(seen[1].rgba[0], seen[1].rgba[1] + 0.1) << "still red";
  EXPECT_EQ(seen[2].rgba, drawn[2].rgba) << "bright enough";
}

}  // namespace
}  // namespace gaitway::tools
