// Values of ports as they are written in XML.
#include "gaitway/behaviour/value.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "gaitway/input/number.hpp"

namespace gaitway::behaviour::test {
namespace {

constexpr double kPi = std::numbers::pi;

double number(const char* text, const char* unit) {
  return std::get<double>(parse_value(text, {.kind = ValueKind::number, .unit = unit}));
}

TEST(Values, NumbersAreConvertedToThePortsUnit) {
  EXPECT_DOUBLE_EQ(number("0.5 m", "m"), 0.5);
  EXPECT_DOUBLE_EQ(number("-25cm", "m"), -0.25);
  EXPECT_DOUBLE_EQ(number("12 mm", "m"), 0.012);
  EXPECT_DOUBLE_EQ(number("30 deg", "rad"), kPi / 6.0);
  EXPECT_DOUBLE_EQ(number("1 rad", "rad"), 1.0);
  EXPECT_DOUBLE_EQ(number("250 ms", "s"), 0.25);
  EXPECT_DOUBLE_EQ(number("90 deg/s", "rad/s"), kPi / 2.0);
  EXPECT_DOUBLE_EQ(number("300 mm/s", "m/s"), 0.3);
  EXPECT_DOUBLE_EQ(number("40 %", "%"), 40.0);
  EXPECT_DOUBLE_EQ(number("1.5e-3", ""), 0.0015);
}

TEST(Values, DurationsAreNanosecondsAndBareNumbersMilliseconds) {
  const ValueType duration{.kind = ValueKind::duration};
  EXPECT_EQ(std::get<std::int64_t>(parse_value("250", duration)), 250'000'000);
  EXPECT_EQ(std::get<std::int64_t>(parse_value("0.25 s", duration)), 250'000'000);
  EXPECT_EQ(std::get<std::int64_t>(parse_value("40 us", duration)), 40'000);
  EXPECT_THROW((void)parse_value("2.5", duration), input::ValueError);
  EXPECT_THROW((void)parse_value("400 000 000 s", duration), input::ValueError);
  EXPECT_THROW((void)parse_value("-1 s", duration), input::ValueError);
}

TEST(Values, BooleansAreWrittenInFourWays) {
  const ValueType boolean{.kind = ValueKind::boolean};
  for (const char* const yes : {"true", "True", "TRUE", "1"})
    EXPECT_TRUE(std::get<bool>(parse_value(yes, boolean)));
  for (const char* const no : {"false", "False", "FALSE", "0"})
    EXPECT_FALSE(std::get<bool>(parse_value(no, boolean)));
}

TEST(Values, AreReadAgainAsTheyAreWritten) {
  const ValueType metres{.kind = ValueKind::number, .unit = "m"},
      gait{.kind = ValueKind::choice, .choices = {"slow", "fast"}};
  const ValueType duration{.kind = ValueKind::duration}, text{.kind = ValueKind::text},
      yes{.kind = ValueKind::boolean};
  for (const auto& [value, type] :
       std::initializer_list<std::pair<Value, ValueType>>{{0.1, metres},
                                                          {std::int64_t{1}, gait},
                                                          {std::int64_t{1'234'567}, duration},
                                                          {Text("a b"), text},
                                                          {true, yes}}) {
    EXPECT_EQ(parse_value(written(value, type), type), value) << written(value, type);
  }
}

TEST(Values, OnlyThoseOfATypeFitIt) {
  const ValueType metres{.kind = ValueKind::number, .unit = "m", .lowest = 0.0, .highest = 2.0};
  EXPECT_TRUE(fits(Value(2.0), metres));
  EXPECT_FALSE(fits(Value(2.1), metres));
  EXPECT_FALSE(fits(Value(std::numeric_limits<double>::quiet_NaN()), metres));
  EXPECT_FALSE(fits(Value(std::int64_t{1}), metres));
  EXPECT_FALSE(fits(Value(), metres));
  const ValueType gait{.kind = ValueKind::choice, .choices = {"slow", "fast"}};
  EXPECT_TRUE(fits(Value(std::int64_t{1}), gait));
  EXPECT_FALSE(fits(Value(std::int64_t{2}), gait));
  EXPECT_FALSE(fits(Value(std::int64_t{-1}), gait));
}

TEST(Values, TextsKeepTheirFirstBytes) {
  EXPECT_EQ(Text(std::string(200, 'x')).view().size(), Text::kMost);
  EXPECT_EQ(Text("abc"), Text("abc"));
  EXPECT_FALSE(Text("abc") == Text("abd"));
}

}  // namespace
}  // namespace gaitway::behaviour::test
