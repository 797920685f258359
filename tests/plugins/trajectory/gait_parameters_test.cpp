// Bad parameters are refused with name, value, rule and remedy.
#include "gaitway/trajectory/gait_parameters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace gaitway::trajectory {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(GaitParameters, DefaultsAreValid) {
  EXPECT_NO_THROW(GaitParameters{}.validate());
}

TEST(GaitParameters, DefaultTailsKeepWithinOneHundredAndFortyPoints) {
  EXPECT_LE(GaitParameters{}.longest_tail_points(), 136);
}

TEST(GaitParameters, RefusalNamesParameterValueRuleAndRemedy) {
  GaitParameters p;
  p.step_time_s = 0.05;
  EXPECT_THAT([&] { p.validate(); },
              ThrowsMessage<std::invalid_argument>(AllOf(
                  HasSubstr("step_time is 0.05 s"), HasSubstr("from 0.2 to 1 s"), HasSubstr("parameters"))));
}

TEST(GaitParameters, RefusesNotANumber) {
  GaitParameters p;
  p.lift_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(p.validate(), std::invalid_argument);
}

TEST(GaitParameters, RefusesFeetThatTouch) {
  GaitParameters p;
  p.foot_spacing_m = 0.085;
  EXPECT_THAT([&] { p.validate(); }, ThrowsMessage<std::invalid_argument>(HasSubstr("foot_spacing")));
}

TEST(GaitParameters, RefusesTailsThatAPlanCannotCarry) {
  GaitParameters p;
  p.step_time_s = 0.8;
  EXPECT_THAT([&] { p.validate(); }, ThrowsMessage<std::invalid_argument>(HasSubstr("settle")));
}

}  // namespace
}  // namespace gaitway::trajectory
