// The slow correction of a lasting lean.
#include "gaitway/stability/lean_integrator.hpp"

#include <gtest/gtest.h>

namespace gaitway::stability {
namespace {

BalanceParameters with_gain(double gain_per_s) {
  BalanceParameters parameters;
  parameters.lean_gain_per_s = gain_per_s;
  return parameters;
}

TEST(LeanIntegrator, IsOffByDefault) {
  LeanIntegrator lean{BalanceParameters{}};
  for (int i = 0; i < 100; ++i) lean.update(0.1, -0.1);
  EXPECT_EQ(lean.offset_rad()[0], 0.0);
  EXPECT_EQ(lean.offset_rad()[1], 0.0);
}

TEST(LeanIntegrator, TakesOutALeanThatTheGroundCauses) {
  LeanIntegrator lean(with_gain(0.5));
  const double slope = 0.07;
  for (int i = 0; i < 1000; ++i) lean.update(0.0, slope + lean.offset_rad()[1]);
  EXPECT_NEAR(lean.offset_rad()[1], -slope, 0.001);
  EXPECT_EQ(lean.offset_rad()[0], 0.0);
}

TEST(LeanIntegrator, IsLimitedAndFades) {
  LeanIntegrator lean(with_gain(0.5));
  for (int i = 0; i < 2000; ++i) lean.update(-0.3, 0.3);
  EXPECT_DOUBLE_EQ(lean.offset_rad()[0], BalanceParameters{}.lean_limit_rad);
  EXPECT_DOUBLE_EQ(lean.offset_rad()[1], -BalanceParameters{}.lean_limit_rad);
  for (int i = 0; i < 1000; ++i) lean.fade();
  EXPECT_NEAR(lean.offset_rad()[0], 0.0, 0.001);
}

}  // namespace
}  // namespace gaitway::stability
