// Levels and values of /diagnostics.
#include "gaitway/api/diagnostics.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <string_view>

#include "humanoid.hpp"

namespace gaitway::api {
namespace {

using test::humanoid;

template <std::size_t size>
void set_text(std::uint8_t (&to)[size], std::string_view text) {
  std::memcpy(to, text.data(), text.size());
}

class DiagnosticsTest : public ::testing::Test {
 protected:
  DiagnosticsTest() {
    plugins->plugin_count = 2;
    set_text(plugins->name[0], "zmp");
    set_text(plugins->name[1], "trajectory");
    plugins->steps[0] = 100;
    plugins->p99_step_ns[0] = 1'250;
    condition.plugins = plugins.get();
    condition.network = &network;
    condition.health = &health;
    condition.stamp_ns = 2'000'000'000;
  }
  ros::DiagnosticStatus status(std::string_view name) {
    for (const ros::DiagnosticStatus& status : diagnostics.report(condition).status) {
      if (status.name == name) return status;
    }
    ADD_FAILURE() << "no status " << name;
    return {};
  }
  static std::string value(const ros::DiagnosticStatus& status, std::string_view key) {
    for (const ros::KeyValue& value : status.values) {
      if (value.key == key) return value.value;
    }
    return "none";
  }
  static void expect(const ros::DiagnosticStatus& status, DiagnosticLevel level, std::string_view part) {
    EXPECT_EQ(status.level, static_cast<std::uint8_t>(level)) << status.name << ": " << status.message;
    EXPECT_NE(status.message.find(part), std::string::npos) << status.message;
  }

  std::unique_ptr<PluginStatistics> plugins = std::make_unique<PluginStatistics>();
  NetworkState network{};
  NetworkHealth health{};
  RobotCondition condition;
  Diagnostics diagnostics{humanoid()};
};

TEST_F(DiagnosticsTest, HaveAStatusForEachPluginBusNodesAndLoop) {
  const ros::DiagnosticArray array = diagnostics.report(condition);
  ASSERT_EQ(array.status.size(), 5U);
  EXPECT_EQ(array.status[0].name, "plugin/zmp");
  EXPECT_EQ(array.status[1].name, "plugin/trajectory");
  EXPECT_EQ(array.status[2].name, "bus");
  EXPECT_EQ(array.status[3].name, "nodes");
  EXPECT_EQ(array.status[4].name, "loop");
  EXPECT_EQ(array.header.stamp.sec, 2);
  for (const ros::DiagnosticStatus& status : array.status) {
    EXPECT_EQ(status.level, 0) << status.name << ": " << status.message;
    EXPECT_EQ(status.hardware_id, "humanoid22");
  }
}

TEST_F(DiagnosticsTest, APluginsLevelIsItsStates) {
  const std::array levels{DiagnosticLevel::ok, DiagnosticLevel::warning, DiagnosticLevel::error,
                          DiagnosticLevel::warning};
  const std::array<std::string_view, 4> texts{"works", "failed", "out of service", "stopped"};
  for (std::uint32_t state = 0; state < 4; ++state) {
    plugins->state[0] = state;
    expect(status("plugin/zmp"), levels[state], texts[state]);
  }
  EXPECT_EQ(value(status("plugin/zmp"), "steps"), "100");
  EXPECT_EQ(value(status("plugin/zmp"), "p99_step_us"), "1.2");
}

TEST_F(DiagnosticsTest, NewFaultsOfAPluginAreAWarningOnce) {
  plugins->faults[1] = 7;
  expect(status("plugin/trajectory"), DiagnosticLevel::ok, "works");
  plugins->faults[1] = 10;
  expect(status("plugin/trajectory"), DiagnosticLevel::warning, "3 faults");
  expect(status("plugin/trajectory"), DiagnosticLevel::ok, "works");
}

TEST_F(DiagnosticsTest, TheBusSaysItsStateAndNewIncidents) {
  health.forged = 2;
  expect(status("bus"), DiagnosticLevel::ok, "error-active");
  health.expired = 4;
  expect(status("bus"), DiagnosticLevel::warning, "4 incidents");
  EXPECT_EQ(value(status("bus"), "forged"), "2");
  health.bus_state = 1;
  health.transmit_errors = 130;
  expect(status("bus"), DiagnosticLevel::warning, "error-passive");
  EXPECT_EQ(value(status("bus"), "transmit_errors"), "130");
  health.bus_state = 2;
  expect(status("bus"), DiagnosticLevel::error, "bus-off");
  health.bus_state = 3;
  expect(status("bus"), DiagnosticLevel::error, "down");
}

TEST_F(DiagnosticsTest, NodesAreNamedByTheirJoints) {
  health.faults[3] = 1 | 2;
  expect(status("nodes"), DiagnosticLevel::warning, "1 report faults");
  EXPECT_EQ(value(status("nodes"), "left_knee"), "position limit, torque saturated");
  health.missing = std::uint64_t{1} << 21;
  expect(status("nodes"), DiagnosticLevel::error, "1 joints are missing");
  EXPECT_EQ(value(status("nodes"), "right_elbow"), "missing");
  EXPECT_EQ(value(status("nodes"), "left_hip_yaw"), "none");
}

TEST_F(DiagnosticsTest, TheLoopSaysItsModeAndWhatWasLate) {
  const std::array levels{DiagnosticLevel::ok, DiagnosticLevel::warning, DiagnosticLevel::ok,
                          DiagnosticLevel::error};
  const std::array<std::string_view, 4> texts{"batches", "safe tail", "holds", "/release ends it"};
  for (std::uint32_t mode = 0; mode < 4; ++mode) {
    network.mode = mode;
    expect(status("loop"), levels[mode], texts[mode]);
  }
  network.mode = 0;
  network.late = 2;
  network.refused = 1;
  expect(status("loop"), DiagnosticLevel::warning, "3 batches late or refused");
  EXPECT_EQ(value(status("loop"), "late"), "2");
}

TEST_F(DiagnosticsTest, ASilentMessageControllerIsSaidBeforeAllElse) {
  network.mode = 3;
  condition.heartbeat_age_ns = 1'500'000'000;
  expect(status("loop"), DiagnosticLevel::stale, "silent");
  EXPECT_EQ(value(status("loop"), "heartbeat_age_ms"), "1500");
}

TEST_F(DiagnosticsTest, WhatNobodyHasWrittenIsStale) {
  condition.plugins = nullptr;
  condition.network = nullptr;
  condition.health = nullptr;
  const ros::DiagnosticArray array = diagnostics.report(condition);
  ASSERT_EQ(array.status.size(), 3U);
  for (const ros::DiagnosticStatus& status : array.status) {
    EXPECT_EQ(status.level, static_cast<std::uint8_t>(DiagnosticLevel::stale)) << status.name;
  }
}

TEST_F(DiagnosticsTest, StatesAndCountsBeyondTheTablesDoNoHarm) {
  plugins->plugin_count = 4'000'000'000;
  plugins->state[0] = 4'000'000'000;
  health.bus_state = 99;
  network.mode = 99;
  std::memset(health.faults, 0xFF, sizeof health.faults);
  health.missing = ~std::uint64_t{0};
  EXPECT_EQ(diagnostics.report(condition).status.size(), 16U + 3U);
}

}  // namespace
}  // namespace gaitway::api
