// What goes out is the mean of the last ten samples, rounded, within 16 bits.
#include "gaitway/localcontroller/joint_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <random>

namespace gaitway::localcontroller {
namespace {

TEST(SensorFilter, SendsTheMeanOfTheLastTenSamples) {
  SensorFilter filter;
  std::deque<double> last;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> force(-50.0F, 200.0F);
  for (int i = 0; i < 5000; ++i) {
    const float sample = force(random);
    filter.add(sample);
    last.push_back(static_cast<double>(sample));
    if (last.size() > 10) {
      last.pop_front();
    }
    const double mean = std::accumulate(last.begin(), last.end(), 0.0) / static_cast<double>(last.size());
    ASSERT_NEAR(filter.counts(0.01F), mean / 0.01, 0.6);
  }
}

TEST(SensorFilter, RoundsAndSaturates) {
  SensorFilter filter;
  EXPECT_EQ(filter.counts(1.0F), 0);
  for (int i = 0; i < 10; ++i) {
    filter.add(-2.6F);
  }
  EXPECT_EQ(filter.counts(1.0F), -3);
  EXPECT_EQ(filter.counts(1e-6F), -32767);
  EXPECT_EQ(filter.counts(-1e-6F), 32767);
}

TEST(SensorFilter, ASampleThatIsNoNumberIsForgottenAfterTenOthers) {
  SensorFilter filter;
  filter.add(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(filter.counts(1.0F), -32767);
  for (int i = 0; i < 20; ++i) {
    filter.add(5.0F);
  }
  EXPECT_EQ(filter.counts(1.0F), 5);
}

}  // namespace
}  // namespace gaitway::localcontroller
