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

}  // namespace
}  // namespace gaitway::stability
