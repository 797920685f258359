// Numbers with and without units, and what is said about those that are none.
#include "gaitway/input/number.hpp"

#include <gmock/gmock.h>

#include <cstdint>
#include <limits>
#include <string>

namespace gaitway::input {
namespace {

using testing::HasSubstr;

template <class Function>
std::string refusal(const Function& function) {
  try {
    (void)function();
  } catch (const ValueError& error) {
    return error.what();
  }
  return "(accepted)";
}
std::string number_refusal(const std::string& text) {
  return refusal([&] { return plain_number<double>(text); });
}
std::string whole_refusal(const std::string& text) {
  return refusal([&] { return plain_number<std::int64_t>(text); });
}
std::string time_refusal(const std::string& text) {
  return refusal([&] { return number_with_unit(text, kTimeUnits_ns, 1000, 80'000'000); });
}

TEST(Number, IsReadInEveryUsualForm) {
  for (const char* const text : {"0.5", "+0.5", ".5", "5e-1", " 0.5\t", "5E-1"}) {
    EXPECT_EQ(plain_number<double>(text), 0.5) << text;
  }
  EXPECT_EQ(plain_number<std::int64_t>("-7"), -7);
  EXPECT_EQ(plain_number<std::int64_t>("0x1F"), 31);
  EXPECT_EQ(plain_number<std::int64_t>("010"), 10);
  EXPECT_EQ(plain_number<std::uint64_t>("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
}

TEST(Number, ThatIsNoneOrNotFiniteIsRefused) {
  for (const char* const text :
       {"", " ", "fast", "nan", "inf", "-inf", "1e999", "+-1", "1 m", "0x10", "1 2", "--1"}) {
    EXPECT_EQ(number_refusal(text), "must be a number") << text;
  }
  for (const char* const text :
       {"", "1.5", "1e3", "1e20", "99999999999999999999", "many", "0x", "0x-1", "5 ms"}) {
    EXPECT_EQ(whole_refusal(text), "must be a whole number") << text;
  }
  EXPECT_EQ(refusal([] { return plain_number<std::uint64_t>("-1"); }), "must be a whole number");
}

TEST(Number, WithADecimalCommaIsToldHowToWriteIt) {
  EXPECT_EQ(number_refusal("0,4"), "must be a number with a decimal point, not with a comma. Write '0.4'");
  EXPECT_EQ(number_refusal("-12,5e3"),
            "must be a number with a decimal point, not with a comma. Write '-12.5e3'");
  EXPECT_EQ(time_refusal("0,4 s"), "must be a number with a decimal point, not with a comma. Write '0.4 s'");
  EXPECT_EQ(number_refusal("1, 2"), "must be a number");
  EXPECT_EQ(number_refusal(",4"), "must be a number");
}

TEST(NumberWithUnit, IsGivenInTheBaseUnit) {
  EXPECT_EQ(number_with_unit("200 us", kTimeUnits_ns, 0, 1'000'000), 200'000);
  EXPECT_EQ(number_with_unit("0.25ms", kTimeUnits_ns, 0, 1'000'000), 250'000);
  EXPECT_EQ(number_with_unit("1.5 GiB", kSizeUnits_bytes, 0, std::int64_t{4} << 30U), std::int64_t{3} << 29U);
}

TEST(NumberWithUnit, OutOfRangeNamesTheLimits) {
  for (const char* const text : {"1 s", "999 ns", "-5 ms", "1e300 s"}) {
    EXPECT_THAT(time_refusal(text), HasSubstr("must lie between 1 us and 80 ms")) << text;
  }
  EXPECT_THAT(refusal([] { return number_with_unit("2 s", kTimeUnits_ns, 0, 1'000'000'000); }),
              HasSubstr("must lie between 0 and 1 s"));
}

TEST(NumberWithUnit, WithoutAKnownUnitNamesThem) {
  for (const char* const text : {"5", "5 min", "5 m s", "us", "", "nan s"}) {
    EXPECT_EQ(time_refusal(text), "must be a number with its unit: ns, us, ms or s. Write it like '200 ms'")
        << text;
  }
}

TEST(OptionFault, FiniteNumbersInRangeAlone) {
  EXPECT_EQ(option_fault("2.5", 0.0, 10.0), "");
  for (const char* const text : {"nan", "-nan", "inf", "11", "-0.1", "", "x", "1e999"}) {
    EXPECT_EQ(option_fault(text, 0.0, 10.0), "'" + std::string(text) + "' must be a number from 0 to 10");
  }
  EXPECT_EQ(option_fault("2,5", 0.0, 10.0),
            "'2,5' must be a number with a decimal point, not with a comma. Write '2.5'");
  const std::uint64_t highest = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(option_fault<std::uint64_t>("18446744073709551615", 0, highest), "");
  for (const char* const text : {"1e20", "18446744073709551616", "-1", "0.5"}) {
    EXPECT_THAT(option_fault<std::uint64_t>(text, 0, highest), HasSubstr("must be a whole number from 0 to"))
        << text;
  }
}

}  // namespace
}  // namespace gaitway::input
