// Rows without a break are one finding, told at its worst.
#include "gaitway/kinematic/findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gaitway::kinematic {
namespace {

TEST(FindingList, RowsWithoutABreakAreOneFindingToldAtItsWorst) {
  FindingList list;
  for (const auto& [row, value] : {std::pair{4, 5.0}, {5, 7.0}, {6, 6.0}})
    list.note(Rule::speed, "knee", static_cast<std::size_t>(row), 0.01 * row, value, 4.0, value - 4.0,
              "rad/s");
  const auto findings = list.take();
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_DOUBLE_EQ(findings[0].from_s, 0.04);
  EXPECT_DOUBLE_EQ(findings[0].to_s, 0.06);
  EXPECT_DOUBLE_EQ(findings[0].at_s, 0.05);
  EXPECT_DOUBLE_EQ(findings[0].value, 7.0);
  EXPECT_EQ(
      describe(findings[0]),
      "knee: speed 7 rad/s at 0.050 s, must not be more than motor and reference may have (limit 4 rad/s); "
      "0.040 to 0.060 s");
}

TEST(FindingList, ABreakAnotherThingOrAnotherRuleIsAnotherFinding) {
  FindingList list;
  list.note(Rule::speed, "knee", 0, 0.0, 5.0, 4.0, 1.0, "rad/s");
  list.note(Rule::torque, "knee", 0, 0.0, 9.0, 8.0, 1.0, "N·m");
  list.note(Rule::speed, "hip", 1, 0.01, 5.0, 4.0, 1.0, "rad/s");
  list.note(Rule::speed, "knee", 2, 0.02, 5.0, 4.0, 1.0, "rad/s");
  const auto findings = list.take();
  ASSERT_EQ(findings.size(), 4U);
  EXPECT_EQ(findings[0].rule, Rule::speed);
  EXPECT_EQ(findings[1].rule, Rule::torque);
  EXPECT_EQ(findings[2].what, "hip");
  EXPECT_DOUBLE_EQ(findings[3].at_s, 0.02);
}

}  // namespace
}  // namespace gaitway::kinematic
