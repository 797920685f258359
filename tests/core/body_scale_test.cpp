// What numbers become on another body.
#include "gaitway/facts/body_scale.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "gaitway/plugin/number_parameter.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway {
namespace {

using facts::BodyScale;

TEST(BodyScale, FollowsFroudeAndTheWeight) {
  const BodyScale four_times_as_high(4.0 * 0.36, 64.0 * 6.84);
  const auto expect = [&](const char* unit, double factor) {
    EXPECT_NEAR(four_times_as_high.factor(unit), factor, 1e-9 * factor) << unit;
  };
  expect("m", 4.0);
  expect("s", 2.0);
  expect("m/s", 2.0);
  expect("m/s^2", 1.0);
  expect("1/s", 0.5);
  expect("rad/s^2", 0.25);
  expect("rad/m", 0.25);
  expect("rad/(m*s)", 1.0 / 8.0);
  expect("m/s^2/s^0.5", 1.0 / std::sqrt(2.0));
  expect("m*s^0.5", 4.0 * std::sqrt(2.0));
  expect("s^6", 64.0);
  expect("N", 64.0);
  expect("N*m", 256.0);
  for (const char* unit : {"1", "", "rad", "rad/rad"}) expect(unit, 1.0);
}

TEST(BodyScale, RefusesAUnitThatItDoesNotKnow) {
  EXPECT_THROW(static_cast<void>(BodyScale().factor("inch")), std::invalid_argument);
}

TEST(BodyScale, TheBodyOfTheDefaultsKeepsThemToTheBit) {
  const urdf::RobotModel robot = urdf::load_robot(GAITWAY_TEST_ROBOT);
  for (const char* unit : {"m", "s", "m/s", "N", "rad/(m*s)", "m*s^0.5"}) {
    EXPECT_EQ(robot.body_scale().factor(unit), 1.0) << unit;
  }
}

TEST(BodyScale, ScalesDefaultsWithinTheirRangesAndLeavesWhatIsNotOfTheBody) {
  double length_m = 0.1, time_s = 0.3, delay_s = 0.02;
  scale_to_body(std::array{NumberParameter{length_m, "length", "m", 0.0, 0.25},
                           NumberParameter{time_s, "time", "s", 0.0, 10.0},
                           NumberParameter{delay_s, "delay", "s", 0.0, 1.0, "", false, Scaling::none}},
                BodyScale(4.0 * 0.36, 6.84));
  EXPECT_EQ(length_m, 0.25);
  EXPECT_NEAR(time_s, 0.6, 1e-12);
  EXPECT_EQ(delay_s, 0.02);
}

}  // namespace
}  // namespace gaitway
