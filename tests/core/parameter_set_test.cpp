// Numbers with units, whole numbers, flags, texts.
#include "gaitway/instance/parameter_set.hpp"

#include <gmock/gmock.h>

#include <limits>

namespace gaitway::core {
namespace {

using testing::HasSubstr;

ParameterSet with(const std::string& name, const std::string& text) {
  return {"walk.yaml", "gait", {{name, text, 12}}};
}

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
  EXPECT_THAT(number_refusal("500 ms"),
              HasSubstr("walk.yaml:12: parameter 'x' of 'gait' = '500 ms': is in 'ms', but must be in 's'"));
  EXPECT_THAT(number_refusal("0.1 m", "1"), HasSubstr("is in 'm', but must be a plain number"));
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

}  // namespace
}  // namespace gaitway::core
