// What a plug-in library says of itself, and that a bad one harms nobody.
#include "gaitway/isolation/plugin_probe.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/manager/plugin_exchange.hpp"

namespace gaitway::core {
namespace {

using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::HasSubstr;

std::filesystem::path library(const std::string& name) {
  return std::filesystem::path(GAITWAY_TEST_PLUGINS) / (name + ".so");
}

ProbeOptions options() {
  return {.robot_directory = GAITWAY_TEST_ROBOT, .plugin_path = {GAITWAY_TEST_PLUGINS}};
}

std::string complaint_of(const std::string& name, milliseconds patience = milliseconds(10'000)) {
  ProbeOptions some = options();
  some.patience = patience;
  try {
    (void)probe_plugin(library(name), some);
  } catch (const PluginError& error) {
    return error.what();
  }
  return "";
}

TEST(PluginProbe, TellsTopicsAndDescriptor) {
  const PluginDescription plain_c = probe_plugin(library("plain_c"), options());
  EXPECT_EQ(plain_c.name, "plain_c");
  EXPECT_EQ(plain_c.version, "1.0.0");
  EXPECT_EQ(plain_c.text, "Counts its steps");
  EXPECT_EQ(plain_c.file.filename(), "plain_c.so");
  EXPECT_EQ(plain_c.period, Period::tick);
  EXPECT_TRUE(plain_c.writes("count"));
  EXPECT_FALSE(plain_c.writes("fail_at"));
  ASSERT_EQ(plain_c.parameters.size(), 1U);
  EXPECT_EQ(plain_c.parameters[0].name, "fail_at");
  EXPECT_EQ(plain_c.parameters[0].kind, ParameterKind::integer);
  EXPECT_EQ(plain_c.parameters[0].fallback, "0");
  EXPECT_EQ(plain_c.parameters[0].highest, 1e6);
}

TEST(PluginProbe, SurvivesWhatAPluginDoes) {
  EXPECT_THAT(complaint_of("throws_in_constructor"), HasSubstr("its constructor failed"));
  EXPECT_THAT(complaint_of("crashes_in_constructor"),
              HasSubstr("was ended by SIGABRT while it constructed the plug-in"));
  EXPECT_THAT(complaint_of("hangs_in_constructor", milliseconds(200)),
              HasSubstr("has not constructed the plug-in within 0.2 s"));
  EXPECT_THAT(complaint_of("other_abi"), HasSubstr("ABI"));
  EXPECT_THAT(complaint_of("not_there"), HasSubstr("not_there.so"));
}

TEST(PluginProbe, KnowsPluginsByTheirEntry) {
  EXPECT_TRUE(is_plugin_library(library("relay")));
  EXPECT_FALSE(is_plugin_library(library("missing_symbol")));
  EXPECT_FALSE(is_plugin_library(library("not_there")));
}

TEST(PluginExchange, ReplacesWhoWritesTheSameTopics) {
  const Configuration before{
      "some.yaml", {{.name = "a", .library = "plain_c.so"}, {.name = "b", .library = "joint_planner.so"}}};
  const std::vector<std::filesystem::path> added{library("plain_c")};
  const PluginExchange after = put_in(before, added, options());
  ASSERT_EQ(after.configuration.plugins.size(), 2U);
  EXPECT_EQ(after.configuration.plugins[0].name, "plain_c");
  EXPECT_EQ(after.configuration.plugins[1].name, "b");
  EXPECT_THAT(after.added[0].replaced, ElementsAre("a"));
  EXPECT_THAT(after.added[0].lost_outputs, ElementsAre());
  EXPECT_THAT(describe(after.added[0]), testing::EndsWith("replaces a"));
  EXPECT_EQ(after.writer_of("count"), "plain_c");
  EXPECT_EQ(after.writer_of("estimate"), "");
}

TEST(PluginExchange, AddsWhoWritesSomethingElse) {
  const Configuration before{"some.yaml", {{.name = "b", .library = "joint_planner.so"}}};
  const std::vector<std::filesystem::path> added{library("plain_c")};
  const PluginExchange after = put_in(before, added, options());
  EXPECT_EQ(after.configuration.plugins.size(), 2U);
  EXPECT_THAT(describe(after.added[0]), testing::EndsWith("is added"));
}

}  // namespace
}  // namespace gaitway::core
