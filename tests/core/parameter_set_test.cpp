// Numbers with units, whole numbers, flags, texts.
#include "gaitway/core/parameter_set.hpp"

#include <gmock/gmock.h>

namespace gaitway::core {
namespace {

using testing::HasSubstr;

ParameterSet with(const std::string& name, const std::string& text) {
  return {"walk.yaml", "gait", {{name, text, 12}}};
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
std::string number_refusal(const std::string& text, std::string_view unit = "s") {
  return refusal([&] { static_cast<void>(with("x", text).number("x", 0.4, unit)); });
}
std::string integer_refusal(const std::string& text) {
  return refusal([&] { static_cast<void>(with("x", text).integer("x", 3, "1")); });
}

TEST(ParameterSet, NumberWithItsUnitWithoutItAndInManyForms) {
  for (const char* const text : {"0.5 s", "0.5s", "0.5", "5e-1 s", " +0.5  s ", "5e-1"}) {
    EXPECT_EQ(with("x", text).number("x", 0.4, "s"), 0.5) << text;
  }
  EXPECT_EQ(with("x", "-3 m/s^2").number("x", 0.0, "m/s^2"), -3.0);
  EXPECT_EQ(with("y", "1").number("x", 0.4, "s"), 0.4);  // not given: the default
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
  EXPECT_THAT(number_refusal("1,5"), HasSubstr("is in ',5'"));
}

TEST(ParameterSet, WholeNumbers) {
  EXPECT_EQ(with("x", "-7").integer("x", 3, "1"), -7);
  EXPECT_EQ(with("x", "4 ms").integer("x", 3, "ms"), 4);
  for (const char* const text : {"1.5", "1e3", "99999999999999999999", "many"}) {
    EXPECT_THAT(integer_refusal(text), HasSubstr("must be a whole number")) << text;
  }
}

TEST(ParameterSet, Flags) {
  EXPECT_FALSE(with("x", "false").flag("x", true));
  EXPECT_TRUE(with("y", "false").flag("x", true));
  EXPECT_THAT(refusal([] { static_cast<void>(with("x", "yes").flag("x", true)); }),
              HasSubstr("must be true or false"));
}

TEST(ParameterSet, Texts) {
  ParameterSet set = with("x", "kdl");
  EXPECT_EQ(set.text("x", "auto"), "kdl");
  EXPECT_EQ(set.text("y", "auto"), "auto");
}

TEST(ParameterSet, TwoDeclarationsMustAgree) {
  ParameterSet set = with("x", "1");
  static_cast<void>(set.number("x", 0.0, "s"));
  EXPECT_EQ(set.number("x", 0.0, "s"), 1.0);
  EXPECT_THAT(refusal([&] { static_cast<void>(set.number("x", 0.0, "m")); }),
              HasSubstr("once as number [s] and once as"));
}

TEST(ParameterSet, EntryThatNobodyAskedForIsRefused) {
  ParameterSet set = with("step_tim", "0.4");
  static_cast<void>(set.number("step_time", 0.4, "s"));
  EXPECT_THAT(
      refusal([&] { set.require_all_declared(); }),
      HasSubstr("walk.yaml:12: plug-in 'gait' has no parameter 'step_tim'. Did you mean 'step_time'?"));
  EXPECT_THAT(refusal([] { with("x", "1").require_all_declared(); }),
              HasSubstr("has no parameter 'x'. There is none."));
}

}  // namespace
}  // namespace gaitway::core
