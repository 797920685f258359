// What is learned of a CoM that is not where it is planned, and what is not.
#include "gaitway/stability/batch_feedback.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace gaitway::stability {
namespace {

class ComCentringTest : public ::testing::Test {
 protected:
  // A body at rest whose CoM is `off_m` from the one that is planned for it.
  void stand(const Eigen::Vector2d& off_m, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      const Eigen::Vector2d error_m = off_m + centring_.offset_m();
      centring_.learn(error_m, error_m);
    }
  }

  BalanceParameters parameters_;
  ComCentring centring_{parameters_};
};

TEST_F(ComCentringTest, BringsTheComToItsPlaceWithinSomeSeconds) {
  stand({0.008, -0.004}, 400);
  EXPECT_NEAR(centring_.offset_m().x(), -0.008, 5e-5);
  EXPECT_NEAR(centring_.offset_m().y(), 0.004, 5e-5);
}

TEST_F(ComCentringTest, StaysWithinItsLimit) {
  for (int i = 0; i < 3000; ++i) centring_.learn({0.01, 0.0}, {0.01, 0.0});
  EXPECT_DOUBLE_EQ(centring_.offset_m().x(), -parameters_.centring_limit_m);
}

TEST_F(ComCentringTest, LearnsNothingFromABodyThatIsBeingCaught) {
  for (int i = 0; i < 50; ++i) centring_.learn({0.02, 0.0}, {0.06, 0.0});
  EXPECT_EQ(centring_.offset_m(), Eigen::Vector2d::Zero());
}

TEST_F(ComCentringTest, LearnsNothingFromWhatIsNotFinite) {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  centring_.learn({nothing, 0.0}, {0.0, 0.0});
  centring_.learn({0.001, 0.0}, {nothing, 0.0});
  EXPECT_EQ(centring_.offset_m(), Eigen::Vector2d::Zero());
}

// A DCM that is 30 mm off is a small body's that is being caught, and a large one's that stands calmly.
TEST(ComCentringOfALargerBody, LearnsFromWhatWouldBeAPushOfASmallOne) {
  BalanceParameters small, large;
  scale_to_body(large.numbers(), facts::BodyScale(0.72, 54.72));
  ComCentring of_small(small), of_large(large);
  for (int tick = 0; tick < 100; ++tick) {
    of_small.learn({0.008, 0.0}, {0.03, 0.0});
    of_large.learn({0.008, 0.0}, {0.03, 0.0});
  }
  EXPECT_EQ(of_small.offset_m().x(), 0.0);
  EXPECT_LT(of_large.offset_m().x(), -0.005);
}

}  // namespace
}  // namespace gaitway::stability
