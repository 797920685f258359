// Contacts and support foot under noisy loads.
#include "gaitway/zmp/foot_contact.hpp"

#include <gtest/gtest.h>

#include <random>

namespace gaitway::zmp {
namespace {

using urdf::Side;

constexpr ContactThresholds kThresholds{6.7, 2.7, 0.1};

TEST(ContactDetector, ComesOnAtTheUpperAndGoesOffAtTheLowerThreshold) {
  ContactDetector detector(kThresholds);
  detector.update({6.6, 0.0});
  EXPECT_FALSE(detector.in_contact(Side::left));
  detector.update({6.8, 0.0});
  EXPECT_TRUE(detector.in_contact(Side::left));
  detector.update({2.8, 0.0});
  EXPECT_TRUE(detector.in_contact(Side::left));
  detector.update({2.6, 0.0});
  EXPECT_FALSE(detector.in_contact(Side::left));
  EXPECT_FALSE(detector.in_contact(Side::right));
}

TEST(ContactDetector, NoiseAtAThresholdDoesNotChatter) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise_N(0.0, 0.4);
  ContactDetector detector(kThresholds);
  int changes = 0;
  bool last = false;
  for (int i = 0; i < 4000; ++i) {  // the load rises slowly through both thresholds and falls again
    const double load_N = i < 2000 ? 0.005 * i : 0.005 * (4000 - i);
    detector.update({load_N + noise_N(random), 60.0});
    changes += detector.in_contact(Side::left) != last ? 1 : 0;
    last = detector.in_contact(Side::left);
  }
  EXPECT_EQ(changes, 2);
}

TEST(ContactDetector, SupportChangesOnlyWithTheMargin) {
  ContactDetector detector(kThresholds);
  detector.update({40.0, 27.0});
  EXPECT_EQ(detector.support(), Side::left);
  detector.update({28.0, 39.0});  // 58 % on the right
  EXPECT_EQ(detector.support(), Side::left);
  detector.update({26.0, 41.0});  // 61 %
  EXPECT_EQ(detector.support(), Side::right);
  detector.update({39.0, 28.0});
  EXPECT_EQ(detector.support(), Side::right);
  detector.update({41.0, 26.0});
  EXPECT_EQ(detector.support(), Side::left);
}

TEST(ContactDetector, TheOnlyFootInContactIsTheSupport) {
  ContactDetector detector(kThresholds);
  detector.update({1.0, 8.0});
  EXPECT_EQ(detector.support(), Side::right);
}

TEST(ContactDetector, InTheAirTheLastSupportStays) {
  ContactDetector detector(kThresholds);
  detector.update({1.0, 60.0});
  detector.update({0.5, 0.3});
  EXPECT_FALSE(detector.in_contact(Side::right));
  EXPECT_EQ(detector.support(), Side::right);
}

}  // namespace
}  // namespace gaitway::zmp
