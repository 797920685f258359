// Motions that a page shows without the robot's moving.
#include "gaitway/page/motion_assets.hpp"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "gaitway/trajectory/motion_table.hpp"

namespace gaitway::page {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

class MotionAssets : public ::testing::Test {
 protected:
  MotionAssets() {
    std::string name = ::testing::TempDir() + "gaitway_motions_XXXXXX";
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  ~MotionAssets() override { std::filesystem::remove_all(folder_); }

  // Two batches: 17 points, a joint that moves by 0.01 rad with each.
  [[nodiscard]] trajectory::MotionTable motion(const std::string& name) const {
    trajectory::MotionTable table;
    table.name = name;
    table.description = "Moves a little.";
    table.robot_digest = trajectory::robot_digest(robot_.directory);
    table.joint_count = robot_.joints.size();
    table.path.points.resize(17);
    table.path.points[5].foot_m[1] = {0.02, -0.05, 0.03};
    table.path.points[5].support = 0;
    table.path.offset_rad.assign(17 * table.joint_count, 0.0F);
    for (std::size_t i = 0; i < 17; ++i) {
      table.path.offset_rad[i * table.joint_count + 3] = 0.01F * static_cast<float>(i);
    }
    table.exits.resize(3);
    return table;
  }
  void write(const trajectory::MotionTable& table) {
    trajectory::write_motion_table(table, folder_ / (table.name + ".motion"));
  }
  json list() {
    add_motions(assets_, robot_, std::array{folder_, folder_ / "none"});
    EXPECT_TRUE(assets_.find("/motions.json")->wants_token);
    return json::parse(assets_.find("/motions.json")->body);
  }

  urdf::RobotModel robot_ = urdf::load_robot(std::string(GAITWAY_SOURCE_DIR) + "/urdf/humanoid22");
  std::filesystem::path folder_;
  AssetTable assets_;
};

TEST_F(MotionAssets, TellDurationStartAndPostures) {
  trajectory::MotionTable lying = motion("rise");
  lying.on_ground = true;
  lying.lies_on = trajectory::LyingSide::front;
  write(lying);
  write(motion("wink"));
  const json motions = list();
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_EQ(motions[0]["start"], "lies on its front");
  EXPECT_EQ(motions[1]["name"], "wink");
  EXPECT_EQ(motions[1]["start"], "stands");
  EXPECT_EQ(motions[1]["duration"], 0.16);
  const Asset* const asset = assets_.find("/" + motions[1]["postures"].get<std::string>());
  ASSERT_NE(asset, nullptr);
  EXPECT_TRUE(asset->wants_token);
  const json postures = json::parse(asset->body);
  EXPECT_EQ(postures["period"], 0.05);
  ASSERT_EQ(postures["postures"].size(), 4U);  // of 0, 50, 100, 150 ms
  EXPECT_NEAR(postures["postures"][1]["joints"][3], robot_.joints[3].home_rad + 0.05, 1e-4);
  EXPECT_EQ(postures["postures"][1]["support"], 0);
  EXPECT_EQ(postures["postures"][1]["feet"][1], (json{0.02, -0.05, 0.03, 0.0}));
}

TEST_F(MotionAssets, SayWhyOneIsNotShown) {
  trajectory::MotionTable other = motion("of_another");
  other.robot_digest ^= 1U;
  write(other);
  std::ofstream(folder_ / "damaged.motion") << "no motion";
  const json motions = list();
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_THAT(motions[0]["refused"].get<std::string>(), HasSubstr("no prepared motion of this version"));
  EXPECT_THAT(motions[1]["refused"].get<std::string>(), HasSubstr("another robot's description"));
  EXPECT_FALSE(motions[1].contains("postures"));
  EXPECT_EQ(assets_.find("/motion/of_another.json"), nullptr);
}

}  // namespace
}  // namespace gaitway::page
