// Numbers with units, whole numbers, flags, texts.
#include "gaitway/instance/parameter_set.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

namespace gaitway::core {
namespace {

using testing::HasSubstr;

ParameterSet with(const std::string& name, const std::string& text, const std::filesystem::path& robot = {}) {
  return {"walk.yaml", "gait", {{name, text, 12}}, robot};
}
const std::filesystem::path kRobotOfUnits = GAITWAY_TEST_ROBOT;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

gaitway_parameter declaration(const char* name, gaitway_value fallback, const char* unit = "1") {
  return {.name = name,
          .unit = unit,
          .doc = "",
          .fallback = fallback,
          .lowest = -kInfinity,
          .highest = kInfinity,
          .live = 0,
          .reserved = 0};
}
gaitway_value number_value(double value) {
  return {GAITWAY_NUMBER, 0, value, 0, nullptr};
}
double number(ParameterSet set, const char* name, double fallback, const char* unit) {
  return set.declare(declaration(name, number_value(fallback), unit)).number;
}
std::int64_t integer(ParameterSet set, const char* name, std::int64_t fallback, const char* unit) {
  return set.declare(declaration(name, {GAITWAY_INTEGER, 0, 0.0, fallback, nullptr}, unit)).integer;
}
bool flag(ParameterSet set, const char* name, bool fallback) {
  return set.declare(declaration(name, {GAITWAY_FLAG, 0, 0.0, fallback ? 1 : 0, nullptr}, "")).integer != 0;
}

template <class Function>
std::string refusal(const Function& function) {
  try {
    function();
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return {};
}
std::string number_refusal(const std::string& text, const char* unit = "s") {
  return refusal([&] { static_cast<void>(number(with("x", text), "x", 0.4, unit)); });
}
std::string integer_refusal(const std::string& text) {
  return refusal([&] { static_cast<void>(integer(with("x", text), "x", 3, "1")); });
}

TEST(ParameterSet, NumberWithItsUnitWithoutItAndInManyForms) {
  for (const char* const text : {"0.5 s", "0.5s", "0.5", "5e-1 s", " +0.5  s ", "5e-1"}) {
    EXPECT_EQ(number(with("x", text), "x", 0.4, "s"), 0.5) << text;
  }
  EXPECT_EQ(number(with("x", "-3 m/s^2"), "x", 0.0, "m/s^2"), -3.0);
  EXPECT_EQ(number(with("y", "1"), "x", 0.4, "s"), 0.4);  // not given: the default
}

TEST(ParameterSet, AnotherUnitIsRefusedByName) {
  EXPECT_THAT(number_refusal("0.5 m"),
              HasSubstr("walk.yaml:12: parameter 'x' of 'gait' = '0.5 m': is in 'm', but must be in 's', in "
                        "another unit of that kind, or in 'T' of the robot's body (h: hip height"));
  EXPECT_THAT(number_refusal("0.5 h"), HasSubstr("is in 'h', but must be in 's'"));
  EXPECT_THAT(number_refusal("0.5 parsec", "m/s"), HasSubstr("or in 'h*T^-1' of the robot's body"));
  EXPECT_THAT(number_refusal("0.1 m", "1"), HasSubstr("is in 'm', but must be a plain number"));
}

TEST(ParameterSet, AnotherUnitOfTheSameKindIsConverted) {
  EXPECT_DOUBLE_EQ(number(with("x", "500 ms"), "x", 0.4, "s"), 0.5);
  EXPECT_DOUBLE_EQ(number(with("x", "25 mm"), "x", 0.4, "m"), 0.025);
  EXPECT_DOUBLE_EQ(number(with("x", "90 deg/s"), "x", 0.4, "rad/s"), std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(number(with("x", "3 rad/(cm*s)"), "x", 0.4, "rad/(m*s)"), 300.0);
}

// 0.36 m of hip height, 6.84 kg.
TEST(ParameterSet, UnitsOfTheRobotsBodyAreConverted) {
  const double time_s = std::sqrt(0.36 / 9.81), weight_N = 6.84 * 9.81;
  const auto read = [](const char* text, const char* unit) {
    return number(with("x", text, kRobotOfUnits), "x", 0.4, unit);
  };
  EXPECT_NEAR(read("0.5 h", "m"), 0.18, 1e-9);
  EXPECT_NEAR(read("1.67 T", "s"), 1.67 * time_s, 1e-9);
  EXPECT_NEAR(read("0.25 h/T", "m/s"), 0.25 * 0.36 / time_s, 1e-9);
  EXPECT_NEAR(read("2 1/T", "1/s"), 2.0 / time_s, 1e-9);
  EXPECT_NEAR(read("0.1 W", "N"), 0.1 * weight_N, 1e-6);
  EXPECT_NEAR(read("0.2 W*h", "N*m"), 0.2 * weight_N * 0.36, 1e-6);
  EXPECT_NEAR(read("1e-4 T^6", "s^6"), 1e-4 * std::pow(time_s, 6.0), 1e-12);
}

TEST(ParameterSet, OfANumberInUnitsOfTheBodyTheRangeIsStillTheParameters) {
  ParameterSet set = with("x", "0.5 h", kRobotOfUnits);
  gaitway_parameter wanted = declaration("x", number_value(0.1), "m");
  wanted.highest = 0.15;
  EXPECT_THAT(refusal([&] { static_cast<void>(set.declare(wanted)); }),
              HasSubstr("= '0.5 h': is 0.18 m, but must be at most 0.15 m"));
}

TEST(ParameterSet, UnitsOfTheBodyNeedARobotThatLoads) {
  EXPECT_THAT(number_refusal("1 T"), HasSubstr("no robot is known here. Write it in 's'"));
  EXPECT_THAT(refusal([] { static_cast<void>(number(with("x", "1 T", "/nowhere"), "x", 0.4, "s")); }),
              HasSubstr("the robot cannot be read: /nowhere"));
}

TEST(ParameterSet, AChangeWhileThePluginRunsMayBeInUnitsOfTheBody) {
  ParameterSet set = with("y", "1", kRobotOfUnits);
  gaitway_parameter wanted = declaration("x", number_value(0.1), "m");
  wanted.live = 1;
  static_cast<void>(set.declare(wanted));
  EXPECT_NEAR(set.read_change("x", "0.5 h").number, 0.18, 1e-9);
  EXPECT_THAT(
      refusal([&] { static_cast<void>(set.read_change("x", "0.5 T")); }),
      HasSubstr("change at run time: parameter 'x' of 'gait' = '0.5 T': is in 'T', but must be in 'm'"));
}

TEST(ParameterSet, WhatIsNoNumberIsRefused) {
  for (const char* const text : {"fast", "", "s", "nan", "inf", "-inf s", "1e999", "+-1", "true"}) {
    EXPECT_THAT(number_refusal(text), HasSubstr("must be a finite number in s. Write for example '0.4 s'"))
        << text;
  }
  EXPECT_THAT(number_refusal("1,5 s"),
              HasSubstr("= '1,5 s': must be a number with a decimal point, not with a comma. Write '1.5 s'"));
}

TEST(ParameterSet, WholeNumbers) {
  EXPECT_EQ(integer(with("x", "-7"), "x", 3, "1"), -7);
  EXPECT_EQ(integer(with("x", "4 ms"), "x", 3, "ms"), 4);
  for (const char* const text : {"1.5", "1e3", "99999999999999999999", "many"}) {
    EXPECT_THAT(integer_refusal(text), HasSubstr("must be a whole number")) << text;
  }
}

TEST(ParameterSet, Flags) {
  EXPECT_FALSE(flag(with("x", "false"), "x", true));
  EXPECT_TRUE(flag(with("y", "false"), "x", true));
  EXPECT_THAT(refusal([] { static_cast<void>(flag(with("x", "yes"), "x", true)); }),
              HasSubstr("must be true or false"));
}

TEST(ParameterSet, Texts) {
  ParameterSet set = with("x", "kdl");
  EXPECT_STREQ(set.declare(declaration("x", {GAITWAY_TEXT, 0, 0.0, 0, "auto"}, "")).text, "kdl");
  EXPECT_STREQ(set.declare(declaration("y", {GAITWAY_TEXT, 0, 0.0, 0, "auto"}, "")).text, "auto");
}

TEST(ParameterSet, TwoDeclarationsMustAgree) {
  ParameterSet set = with("x", "1");
  static_cast<void>(set.declare(declaration("x", number_value(0.0), "s")));
  EXPECT_EQ(set.declare(declaration("x", number_value(0.0), "s")).number, 1.0);
  EXPECT_THAT(refusal([&] { static_cast<void>(set.declare(declaration("x", number_value(0.0), "m"))); }),
              HasSubstr("once as number [s] and once as"));
}

TEST(ParameterSet, EntryThatNobodyAskedForIsRefused) {
  ParameterSet set = with("step_tim", "0.4");
  static_cast<void>(set.declare(declaration("step_time", number_value(0.4), "s")));
  EXPECT_THAT(
      refusal([&] { set.require_all_declared(); }),
      HasSubstr("walk.yaml:12: plug-in 'gait' has no parameter 'step_tim'. Did you mean 'step_time'?"));
  EXPECT_THAT(refusal([] { with("x", "1").require_all_declared(); }),
              HasSubstr("has no parameter 'x'. There is none."));
}

// What a program sets beside the file stands in no line of it.
TEST(ParameterSet, EntryBesideTheFileNamesNoLine) {
  ParameterSet set("walk.yaml", "gait", {{"step_time", "0.4 kg", 0}, {"x", "1", 0}}, {});
  EXPECT_THAT(
      refusal([&] { static_cast<void>(set.declare(declaration("step_time", number_value(0.4), "s"))); }),
      HasSubstr("walk.yaml: parameter 'step_time'"));
  EXPECT_THAT(refusal([&] { set.require_all_declared(); }),
              HasSubstr("walk.yaml: plug-in 'gait' has no parameter"));
}

}  // namespace
}  // namespace gaitway::core
