// A parameter in one line, however much there is to say of it.
#include "gaitway/instance/parameter_set.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "gaitway/instance/configuration.hpp"

namespace gaitway::core {
namespace {

constexpr std::size_t kRoom = 503;

Parameter step_time() {
  return {.name = "step_time",
          .kind = ParameterKind::number,
          .unit = "s",
          .doc = "of one step",
          .fallback = "0.4",
          .value = "0.5",
          .lowest = 0.2,
          .highest = std::numeric_limits<double>::infinity(),
          .live = true};
}

TEST(ParameterLine, SaysAllThatThereIs) {
  EXPECT_EQ(
      parameter_line(step_time(), kRoom),
      R"({"name":"step_time","value":"0.5","unit":"s","doc":"of one step","live":true,"lowest":0.2,"highest":null})");
}

Parameter text(const std::string& value) {
  Parameter parameter;
  parameter.name = "solver";
  parameter.kind = ParameterKind::text;
  parameter.doc = "for people";
  parameter.value = value;
  return parameter;
}

TEST(ParameterLine, OfATextHasNoLimits) {
  const nlohmann::json line = nlohmann::json::parse(parameter_line(text("kdl \"fast\""), kRoom));
  EXPECT_EQ(line.at("value"), "kdl \"fast\"");
  EXPECT_TRUE(line.at("lowest").is_null());
  EXPECT_FALSE(line.at("live"));
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
    const std::string doc = nlohmann::json::parse(text).at("doc");  // throws if it is no UTF-8
    EXPECT_TRUE(doc.empty() || doc.ends_with("\u00e4\u2026")) << doc;
    EXPECT_GT(text.size() + 40, room);
  }
}

TEST(ParameterLine, ShortensItsValueIfItMust) {
  const nlohmann::json line = nlohmann::json::parse(parameter_line(text(std::string(600, '"')), kRoom));
  EXPECT_EQ(line.at("doc"), "");
  EXPECT_TRUE(line.at("value").get<std::string>().ends_with("\u2026"));
}

TEST(ParameterLine, MendsWhatIsNoUtf8) {
  Parameter parameter = step_time();
  parameter.doc = "bad \xff byte";
  EXPECT_EQ(nlohmann::json::parse(parameter_line(parameter, kRoom)).at("doc"), "bad \ufffd byte");
}

TEST(ParameterLine, RefusesANameThatFillsIt) {
  Parameter parameter = step_time();
  parameter.name.assign(600, 'x');
  EXPECT_THROW(static_cast<void>(parameter_line(parameter, kRoom)), PluginError);
}

}  // namespace
}  // namespace gaitway::core
