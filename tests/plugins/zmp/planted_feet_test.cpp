// When feet stand, and how firmly.
#include "gaitway/facts/facts.hpp"
#include "gaitway/zmp/foot_contact.hpp"

#include <gtest/gtest.h>

namespace gaitway::zmp {
namespace {

using facts::kSlot_s;
constexpr double kWeight_N = 67.0;

class PlantedFeetTest : public ::testing::Test {
 protected:
  void stand(int ticks, double left_N = 33.0, double angle_rad = 0.0, double leg_rate = 0.0) {
    for (int i = 0; i < ticks; ++i) feet_.update({left_N, kWeight_N - left_N}, angle_rad, leg_rate, kSlot_s);
  }
  PlantedFeet feet_{EstimatorParameters{}, kWeight_N};
};

TEST_F(PlantedFeetTest, StandAfterAWhileUnderLoadAndNoLongerWhenOneLifts) {
  stand(5);
  EXPECT_FALSE(feet_.planted());
  stand(20);
  EXPECT_TRUE(feet_.planted());
  stand(1, 5.0);
  EXPECT_FALSE(feet_.planted());
  stand(10);
  EXPECT_FALSE(feet_.planted());
}

TEST_F(PlantedFeetTest, DoNotStandWhenTheyTurnAgainstEachOther) {
  stand(100);
  stand(1, 33.0, 0.02);
  EXPECT_FALSE(feet_.planted());
  stand(30, 33.0, 0.02);  // and then they stand anew
  EXPECT_TRUE(feet_.planted());
}

TEST_F(PlantedFeetTest, CreepLessAndLessWhenNothingMoves) {
  stand(30);
  const double fresh = feet_.creep_rad_rts();
  stand(1000);
  EXPECT_LT(feet_.creep_rad_rts(), 0.2 * fresh);
  EXPECT_GE(feet_.creep_rad_rts(), EstimatorParameters{}.creep_rad_rts);
}

TEST_F(PlantedFeetTest, CreepMoreUnderALoadThatRattlesOrLegsThatMove) {
  stand(1000);
  const double still = feet_.creep_rad_rts();
  for (int i = 0; i < 200; ++i) stand(1, i % 2 == 0 ? 32.0 : 34.0);
  EXPECT_TRUE(feet_.planted());
  EXPECT_GT(feet_.creep_rad_rts(), 5.0 * still);
  stand(1000);
  EXPECT_NEAR(feet_.creep_rad_rts(), still, 0.1 * still);
  stand(1, 33.0, 0.0, 0.2);
  EXPECT_GT(feet_.creep_rad_rts(), 10.0 * still);
}

}  // namespace
}  // namespace gaitway::zmp
