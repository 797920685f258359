// Noise has the size that photons and read-out give it; exposure follows the light as far as it can.
#include "eyes/image_sensor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gaitway::simulator {
namespace {

struct Statistics {
  double mean = 0.0, variance = 0.0;
};

std::vector<std::uint8_t> exposed(float light, const Exposure& exposure, std::uint64_t seed) {
  const std::vector<float> all(100'000, light);
  std::vector<std::uint8_t> grey(all.size());
  facts::RandomStream noise(seed, 1);
  expose(all, exposure, 0.004, noise, grey);
  return grey;
}

Statistics of(const std::vector<std::uint8_t>& grey) {
  Statistics result;
  for (const std::uint8_t pixel : grey) result.mean += pixel;
  result.mean /= static_cast<double>(grey.size());
  for (const std::uint8_t pixel : grey) result.variance += (pixel - result.mean) * (pixel - result.mean);
  result.variance /= static_cast<double>(grey.size());
  return result;
}

TEST(ImageSensor, NoiseIsThatOfPhotonsAndReadOut) {
  constexpr double kFull = 9000.0, kRead = 6.0;
  for (const float light : {0.1F, 0.3F, 0.7F}) {
    const Statistics seen = of(exposed(light, {.time_s = 0.004, .gain = 1.0}, 1));
    const double electrons = kFull * static_cast<double>(light), grey_of_electron = 255.0 / kFull;
    EXPECT_NEAR(seen.mean, electrons * grey_of_electron, 0.3);
    const double variance = (electrons + kRead * kRead) * grey_of_electron * grey_of_electron + 1.0 / 12.0;
    EXPECT_NEAR(seen.variance, variance, 0.05 * variance) << light;
  }
}

TEST(ImageSensor, GainMakesLightAndNoiseLarger) {
  const Statistics plain = of(exposed(0.1F, {.time_s = 0.004, .gain = 1.0}, 1));
  const Statistics high = of(exposed(0.1F, {.time_s = 0.004, .gain = 6.0}, 1));
  EXPECT_NEAR(high.mean, 6.0 * plain.mean, 1.0);
  EXPECT_NEAR(high.variance, 36.0 * plain.variance, 4.0 * plain.variance);
  const Statistics shorter = of(exposed(0.6F, {.time_s = 0.001, .gain = 1.0}, 1));
  EXPECT_NEAR(shorter.mean, 0.25 * 0.6 * 255.0, 0.3);
}

TEST(ImageSensor, TooMuchLightIsWhiteAndNoneIsBlack) {
  EXPECT_GT(of(exposed(3.0F, {.time_s = 0.004, .gain = 1.0}, 1)).mean, 254.0);
  EXPECT_LT(of(exposed(0.0F, {.time_s = 0.004, .gain = 1.0}, 1)).mean, 1.0);
}

TEST(ImageSensor, OneSeedGivesOnePicture) {
  EXPECT_EQ(exposed(0.4F, {}, 5), exposed(0.4F, {}, 5));
  EXPECT_NE(exposed(0.4F, {}, 5), exposed(0.4F, {}, 6));
}

TEST(ExposureControl, FollowsTheLightWithinItsLimits) {
  const auto mean_after = [](float light, int pictures) {
    ExposureControl control({}, 0.004);
    Statistics seen;
    for (int i = 0; i < pictures; ++i) {
      const std::vector<std::uint8_t> grey = exposed(light, control.exposure(), 3);
      seen = of(grey);
      control.look(grey);
    }
    return seen.mean;
  };
  EXPECT_NEAR(mean_after(0.9F, 12), 105.0, 3.0);
  EXPECT_NEAR(mean_after(0.15F, 12), 105.0, 3.0);
  EXPECT_GT(mean_after(0.15F, 2), 38.0);
  EXPECT_LT(mean_after(0.15F, 2), 90.0) << "it takes some pictures";
  EXPECT_GT(mean_after(30.0F, 12), 254.0) << "a tenth of the exposure is the shortest";
  EXPECT_LT(mean_after(0.004F, 12), 12.0) << "and eight times the gain the most";
  ExposureControl fixed({.auto_exposure = false, .fixed_exposure = 2.0}, 0.004);
  fixed.look(std::vector<std::uint8_t>(100, 3));
  EXPECT_EQ(fixed.exposure().gain, 2.0);
  EXPECT_EQ(fixed.exposure().time_s, 0.004);
}

}  // namespace
}  // namespace gaitway::simulator
