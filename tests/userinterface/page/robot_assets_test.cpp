// What browsers are given: the page, and the robot's description as JSON.
#include "gaitway/page/robot_assets.hpp"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::page {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

urdf::RobotModel humanoid() {
  return urdf::load_robot(std::string(GAITWAY_SOURCE_DIR) + "/urdf/humanoid22");
}

json description_of(const AssetTable& table) {
  return json::parse(table.find("/robot.json")->body);
}

TEST(AssetTable, HoldsThePageWithoutAnythingFromElsewhereOrInline) {
  AssetTable table;
  add_page(table);
  for (const char* path : {"/", "/page.js", "/page.css", "/icon.svg"}) {
    ASSERT_NE(table.find(path), nullptr) << path;
    EXPECT_FALSE(table.find(path)->wants_token);
  }
  const std::string& html = table.find("/")->body;
  EXPECT_THAT(html, HasSubstr("src=\"page.js\""));
  EXPECT_THAT(html, Not(HasSubstr("http")));
  EXPECT_THAT(html, Not(HasSubstr("<style")));
  EXPECT_LT(table.find("/page.js")->gzip.size(), 300'000U);
  EXPECT_LT(table.find("/page.js")->body.size(), 1'000'000U);
}

TEST(AssetTable, ThePageKnowsTheVersionThatIsServedBesideIt) {
  AssetTable table;
  add_page(table);
  EXPECT_THAT(page_version(), ::testing::MatchesRegex("[0-9a-f]{16}"));
  EXPECT_EQ(json::parse(table.find("/version.json")->body), (json{{"page", page_version()}}));
  EXPECT_FALSE(table.find("/version.json")->wants_token);
  EXPECT_THAT(table.find("/page.js")->body, HasSubstr(page_version()));
}

TEST(AssetTable, FindsAPathWithAQueryAndNothingElse) {
  AssetTable table;
  add_page(table);
  EXPECT_EQ(table.find("/?x=1"), table.find("/"));
  for (const char* path : {"", "/page.js/", "//", "/../page.js", "/PAGE.JS", "page.js"}) {
    EXPECT_EQ(table.find(path), nullptr) << path;
  }
}

TEST(RobotAssets, SayThatTheRobotIsASimulationByHowItMayBePushed) {
  AssetTable table;
  add_robot(table, humanoid(),
            {.push = PushBounds{
                 .least_N = 0.1, .most_N = 200.0, .usual_N = 20.0, .shortest_s = 0.01, .longest_s = 2.0}});
  EXPECT_EQ(description_of(table)["bounds"]["push"],
            (json{{"least", 0.1}, {"most", 200.0}, {"usual", 20.0}, {"shortest", 0.01}, {"longest", 2.0}}));
}

TEST(RobotAssets, DescribesLinksJointsSolesMotionsAndBounds) {
  const urdf::RobotModel robot = humanoid();
  AssetTable table;
  add_robot(table, robot,
            {.forward_m_per_s = 1.0, .turn_rad_per_s = 2.0, .velocity_holds_s = 0.5, .lease_s = 1.0});
  EXPECT_TRUE(table.find("/robot.json")->wants_token);
  const json description = description_of(table);
  EXPECT_EQ(description["name"], robot.name);
  ASSERT_EQ(description["links"].size(), robot.links.size());
  ASSERT_EQ(description["joints"].size(), robot.joints.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    EXPECT_EQ(description["joints"][i]["name"], robot.joints[i].name);
    EXPECT_EQ(description["joints"][i]["child"], robot.joints[i].child_link);
    EXPECT_EQ(description["joints"][i]["axis"][1], robot.joints[i].axis.y());
  }
  std::size_t shapes = 0;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const urdf::Link& link = robot.links[i];
    shapes += description["links"][i]["shapes"].size();
    EXPECT_EQ(description["links"][i]["shapes"].size(),
              (link.visual.empty() ? link.collision : link.visual).size());
  }
  EXPECT_GT(shapes, 20U);
  EXPECT_EQ(description["soles"][1]["size"][0], robot.feet[1].size_m.x());
  EXPECT_THAT(description["motions"],
              ElementsAre("bow", "get_up_back", "get_up_front", "kick", "squat", "wave"));
  EXPECT_EQ(description["bounds"]["velocity_holds"], 0.5);
  EXPECT_FALSE(description["bounds"].contains("push")) << "nobody pushes a real robot from a page";
}

TEST(RobotAssets, GivesMeshesAsTheyAreAndABoxForOneThatIsMissing) {
  std::string folder = ::testing::TempDir() + "gaitway_page_XXXXXX";
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  const std::filesystem::path there = std::filesystem::path(folder) / "there.stl";
  std::ofstream(there) << "a mesh";
  urdf::RobotModel robot = humanoid();
  urdf::Shape shape;
  shape.kind = urdf::Shape::Kind::mesh;
  shape.size_m = {0.1, 0.2, 0.3};
  shape.mesh.file = there;
  robot.links[0].visual = {shape};
  shape.mesh.file = std::filesystem::path(folder) / "missing.stl";
  robot.links[1].visual = {shape};
  AssetTable table;
  add_robot(table, robot, {});
  const json description = description_of(table);
  const json& first = description["links"][0]["shapes"][0];
  EXPECT_EQ(first["kind"], "mesh");
  ASSERT_NE(table.find(first["mesh"].get<std::string>()), nullptr);
  EXPECT_EQ(table.find(first["mesh"].get<std::string>())->body, "a mesh");
  EXPECT_EQ(description["links"][1]["shapes"][0]["kind"], "box");
  EXPECT_EQ(description["links"][1]["shapes"][0]["size"][2], 0.3);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace gaitway::page
