// What browsers are told of a robot's calibration.
#include "gaitway/page/calibration_assets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "gaitway/process/private_folder.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::page {
namespace {

using nlohmann::json;

// humanoid22's folder, with another calibration; empty: none.
json calibration_json(const std::string& calibration) {
  const process::PrivateFolder folder("gaitway_calibration");
  const std::filesystem::path robot = folder.path() / "robot";
  std::filesystem::copy(std::string(GAITWAY_SOURCE_DIR) + "/urdf/humanoid22", robot,
                        std::filesystem::copy_options::recursive);
  if (!calibration.empty()) {
    std::ofstream(robot / "calibration.yaml") << calibration;
  }
  AssetTable table;
  add_calibration(table, urdf::load_robot(robot));
  const Asset* const asset = table.find("/calibration.json");
  EXPECT_TRUE(asset != nullptr && asset->wants_token);
  return json::parse(asset->body);
}

TEST(CalibrationAssets, TellAllThatTheFileHas) {
  constexpr double kHalfADegree_rad = 0.008726646259971648;
  const json told = calibration_json(
      "robot: humanoid22\n"
      "made: 2026-11-25T03:21:29Z\n"
      "joint_zeros_deg:\n  left_hip_roll: {value: -0.5, deviation: 0.25}\n"
      "trunk_com_offset_m: {value: [0.004, -0.002, 0.01]}\n"
      "force_cell_gains:\n  left: {value: [1.01, 0.99, 1.02, 0.98]}\n"
      "  right: {value: [1.03, 1.0, 1.0, 0.97], deviation: [0.01, 0.02, 0.03, 0.04]}\n");
  EXPECT_EQ(told["there"], true);
  EXPECT_EQ(told["made"], "2026-11-25T03:21:29Z");
  ASSERT_EQ(told["joints"].size(), 22U);
  const json& roll = told["joints"][1];
  EXPECT_EQ(roll["name"], "left_hip_roll");
  EXPECT_DOUBLE_EQ(roll["zero"]["value"][0].get<double>(), -kHalfADegree_rad);
  EXPECT_DOUBLE_EQ(roll["zero"]["deviation"][0].get<double>(), kHalfADegree_rad / 2);
  EXPECT_EQ(roll["trim_channel"], 0);
  EXPECT_EQ(told["joints"][0]["zero"], nullptr);
  EXPECT_EQ(told["joints"][0]["trim_channel"], nullptr);
  EXPECT_EQ(told["trunk_com_offset"], (json{{"value", {0.004, -0.002, 0.01}}, {"deviation", nullptr}}));
  EXPECT_EQ(told["feet"][0]["gain"]["value"], (json{1.01, 0.99, 1.02, 0.98}));
  EXPECT_EQ(told["feet"][0]["gain"]["deviation"], nullptr);
  EXPECT_EQ(told["feet"][1]["gain"]["deviation"], (json{0.01, 0.02, 0.03, 0.04}));
  EXPECT_EQ(told["feet"][1]["sensor"], "cells");
  EXPECT_EQ(told["imu"],
            (json{{"link", "trunk"}, {"place", {0.0, 0.0, 0.1}}, {"turn", {0.0, 0.0, 0.0, 1.0}}}));
}

TEST(CalibrationAssets, SayThatThereIsNone) {
  const json told = calibration_json("");
  EXPECT_EQ(told["there"], false);
  EXPECT_EQ(told["made"], nullptr);
  EXPECT_EQ(told["joints"].size(), 22U);
  EXPECT_EQ(told["joints"][1]["zero"], nullptr);
  EXPECT_EQ(told["trunk_com_offset"], nullptr);
  EXPECT_EQ(told["feet"][0]["gain"], nullptr);
}

TEST(CalibrationAssets, SayThatNobodyWroteDownWhenItWasMade) {
  const json told = calibration_json("robot: humanoid22\n");
  EXPECT_EQ(told["there"], true);
  EXPECT_EQ(told["made"], nullptr);
}

}  // namespace
}  // namespace gaitway::page
