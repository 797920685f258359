// The preview controller follows a known ZMP, wherever its origin lies, and rests on a constant one.
#include "gaitway/trajectory/preview_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace gaitway::trajectory {
namespace {

class Preview : public ::testing::Test {
 protected:
  PreviewController controller{PreviewParameters{}};
  std::unique_ptr<ZmpReference> reference = std::make_unique<ZmpReference>();
  Cart cart;
};

TEST_F(Preview, RestsExactlyOnAConstantReferenceFarFromTheOrigin) {
  reference->count = 2;
  reference->point.topRows(2).rowwise() = Eigen::RowVector2d(50.0, -30.0);
  cart.motion.row(0) << 50.0, -30.0;
  for (int i = 0; i < 1000; ++i) controller.step(cart, *reference, i);
  EXPECT_LT((cart.motion.row(0) - Eigen::RowVector2d(50.0, -30.0)).norm(), 1e-9);
}

TEST_F(Preview, MovesBeforeTheStepOfTheReferenceAndSettlesOnIt) {
  reference->count = 201;
  reference->point.topRows(201).setZero();
  reference->point.row(200) << 0.1, 0.0;
  for (int i = 0; i < 200; ++i) controller.step(cart, *reference, i);
  EXPECT_NEAR(cart.motion(0, 0), 0.05, 0.01);  // half-way when the ZMP jumps, as the ideal pendulum
  for (int i = 200; i < 500; ++i) controller.step(cart, *reference, i);
  EXPECT_NEAR(cart.motion(0, 0), 0.1, 1e-4);
  EXPECT_NEAR(cart.motion(0, 1), 0.0, 1e-12);
}

TEST_F(Preview, GainsMatchAClosedLoopThatIsStable) {
  cart.motion.row(0) << 0.01, -0.02;
  reference->count = 2;
  reference->point.topRows(2).setZero();
  for (int i = 0; i < 300; ++i) controller.step(cart, *reference, i);
  EXPECT_LT(cart.motion.norm(), 1e-4);
}

TEST_F(Preview, GainsFadeWithTheTimeConstantOfThePendulum) {
  const auto& gain = controller.preview_gain();
  const double omega = std::sqrt(9.81 / 0.378);
  EXPECT_NEAR(gain(120) / gain(80), std::exp(-0.4 * omega), 0.01);
  EXPECT_NEAR(gain.sum() + controller.state_gain()(0), 0.0, 1e-6);
}

TEST_F(Preview, RefusesAnEmptyPreview) {
  EXPECT_THROW(PreviewController({.points = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::trajectory
