// A parameter in one line, however much there is to say of it.
#include "gaitway/facts/parameter_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/parameter_set.hpp"

namespace gaitway::core {
namespace {

using ::testing::EndsWith;

constexpr std::size_t kRoom = 503;

Parameter step_time() {
  return {.name = "step_time",
          .kind = ParameterKind::number,
          .unit = "s",
          .doc = "of one step",
          .fallback = "0.4",
          .value = "0.5",
          .lowest = 0.2,
          .highest = 1.0,
          .live = true};
}

TEST(ParameterLine, SaysAllThatThereIs) {
  const std::string text = parameter_line(step_time(), kRoom);
  EXPECT_EQ(text, "step_time\t0.5\ts\tlive\tof one step");
  const auto read = facts::read_parameter_line(text);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->name, "step_time");
  EXPECT_EQ(read->value, "0.5");
  EXPECT_EQ(read->unit, "s");
  EXPECT_TRUE(read->live);
  EXPECT_EQ(read->doc, "of one step");
}

TEST(ParameterLine, HoldsWhateverAPlugInWrites) {
  Parameter parameter = step_time();
  parameter.name = "a\tb";
  parameter.unit.clear();
  parameter.doc = "two\nlines\tand a \"tab\"";
  parameter.live = false;
  const std::string text = parameter_line(parameter, kRoom);
  const auto read = facts::read_parameter_line(text);
  ASSERT_TRUE(read) << text;
  EXPECT_EQ(read->name, "a b");
  EXPECT_EQ(read->unit, "");
  EXPECT_FALSE(read->live);
  EXPECT_EQ(read->doc, "two lines and a \"tab\"");
}

TEST(ParameterLine, ShortensItsDocAtACharacter) {
  Parameter parameter = step_time();
  parameter.doc.clear();
  for (int i = 0; i < 300; ++i) {
    parameter.doc += "\u00e4";
  }
  for (std::size_t room = 110; room < kRoom; ++room) {
    const std::string text = parameter_line(parameter, room);
    EXPECT_LE(text.size(), room);
    EXPECT_GT(text.size() + 4, room);
    EXPECT_THAT(text, EndsWith("\u00e4\u2026"));
  }
}

TEST(ParameterLine, ShortensItsValueIfItMust) {
  Parameter parameter = step_time();
  parameter.value.assign(600, '"');
  const std::string text = parameter_line(parameter, kRoom);
  EXPECT_EQ(text.size(), kRoom);
  const auto read = facts::read_parameter_line(text);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->doc, "");
  EXPECT_THAT(std::string(read->value), EndsWith("\"\u2026"));
}

TEST(ParameterLine, RefusesANameThatFillsIt) {
  Parameter parameter = step_time();
  parameter.name.assign(600, 'x');
  EXPECT_THROW(static_cast<void>(parameter_line(parameter, kRoom)), PluginError);
}

TEST(ParameterLine, WhatIsNoneIsNotRead) {
  for (const char* const text :
       {"", "a", "a\tb\tc\t", "\t1\tm\tlive\tno name", "a\t1\tm\tperhaps\tdoc", "a\t1\tm\tlive\tdoc\tmore"}) {
    EXPECT_FALSE(facts::read_parameter_line(text)) << text;
  }
}

}  // namespace
}  // namespace gaitway::core
