// Parabolas have their own derivatives, through however many samples; three samples give differences.
#include "gaitway/kinematic/derivatives.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace gaitway::kinematic {
namespace {

TEST(FitParabola, GivesAParabolaItsOwnValueSlopeAndBend) {
  constexpr double kInterval = 0.01;
  for (const int half : {1, 2, 5, 20}) {
    const auto fit = fit_parabola<double>(half, kInterval, [](int k) {
      const double t = k * kInterval;
      return 0.7 - 1.3 * t + 4.5 * t * t;
    });
    EXPECT_NEAR(fit.value, 0.7, 1e-12) << half;
    EXPECT_NEAR(fit.first, -1.3, 1e-10) << half;
    EXPECT_NEAR(fit.second, 9.0, 1e-8) << half;
  }
}

TEST(FitParabola, GivesTheSameAwayFromTheMiddle) {
  for (const int at : {-4, -1, 3, 4}) {
    const auto fit = fit_parabola<double>(
        4, 0.5, [](int k) { return 2.0 + 0.5 * k - 0.25 * k * k; }, at);
    EXPECT_NEAR(fit.value, 2.0 + 0.5 * at - 0.25 * at * at, 1e-12) << at;
    EXPECT_NEAR(fit.first, (0.5 - 0.5 * at) / 0.5, 1e-12) << at;
    EXPECT_NEAR(fit.second, -0.5 / 0.25, 1e-12) << at;
  }
}

TEST(FitParabola, OfThreeSamplesIsTheirDifferences) {
  const auto sample = [](int k) { return std::exp(0.3 * k); };
  const auto fit = fit_parabola<double>(1, 1.0, sample);
  EXPECT_NEAR(fit.value, 1.0, 1e-15);
  EXPECT_NEAR(fit.first, 0.5 * (sample(1) - sample(-1)), 1e-15);
  EXPECT_NEAR(fit.second, sample(1) - 2.0 + sample(-1), 1e-15);
}

TEST(FitParabola, TakesLessOfANoiseTheMoreSamplesThereAre) {
  const auto noise = [](int k) { return (k * 7 % 5 - 2) * 1e-3; };
  const auto few = fit_parabola<double>(1, 0.01, noise), many = fit_parabola<double>(8, 0.01, noise);
  EXPECT_LT(std::abs(many.second), 0.05 * std::abs(few.second));
}

}  // namespace
}  // namespace gaitway::kinematic
