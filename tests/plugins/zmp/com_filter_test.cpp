// The filter against a simulated linear inverted pendulum.
#include "gaitway/zmp/com_filter.hpp"
#include "gaitway/facts/facts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gaitway::zmp {
namespace {

using facts::kSlot_s;
constexpr double kOmega = 5.1;

// A pendulum that is kept upright by feedback of its DCM to the ZMP while the wanted DCM sways like in
// walking on the spot.
struct Pendulum {
  double position = 0.0, velocity = 0.0, zmp = 0.0, push = 0.0;

  [[nodiscard]] double dcm() const { return position + velocity / kOmega; }
  void advance(double wanted_dcm) {
    zmp = dcm() + 1.5 * (dcm() - wanted_dcm);
    constexpr int kSubsteps = 100;
    for (int i = 0; i < kSubsteps; ++i) {
      const double dt = kSlot_s / kSubsteps;
      const double acceleration = kOmega * kOmega * (position - zmp) + push;
      position += dt * velocity + 0.5 * dt * dt * acceleration;
      velocity += dt * acceleration;
    }
  }
};

struct Errors {
  double dcm_rms = 0.0, dcm_worst = 0.0, velocity_rms = 0.0;
};

// Sensors: CoM with an offset and noise, ZMP with noise.
Errors follow(double com_offset, double com_noise, double zmp_noise) {
  std::mt19937 random(29);
  std::normal_distribution<double> noise(0.0, 1.0);
  ComFilter filter(EstimatorParameters{}, kOmega, kSlot_s);
  Pendulum pendulum;
  filter.start(com_offset);
  Errors errors;
  constexpr int kTicks = 3000, kSettle = 100;
  for (int i = 0; i < kTicks; ++i) {
    pendulum.advance(0.03 * std::sin(2.0 * M_PI * 1.25 * i * kSlot_s));
    const double measured_zmp = pendulum.zmp + zmp_noise * noise(random);
    filter.predict(kOmega * kOmega * (filter.position_m() - measured_zmp));
    filter.correct(pendulum.position + com_offset + com_noise * noise(random));
    if (i < kSettle) continue;
    const double error =
        filter.position_m() + filter.velocity_m_per_s() / kOmega - pendulum.dcm() - com_offset;
    errors.dcm_rms += error * error / (kTicks - kSettle);
    errors.dcm_worst = std::max(errors.dcm_worst, std::abs(error));
    errors.velocity_rms += std::pow(filter.velocity_m_per_s() - pendulum.velocity, 2) / (kTicks - kSettle);
  }
  errors.dcm_rms = std::sqrt(errors.dcm_rms);
  errors.velocity_rms = std::sqrt(errors.velocity_rms);
  return errors;
}

TEST(ComFilter, FollowsAPendulumWithoutNoise) {
  EXPECT_LT(follow(0.0, 0.0, 0.0).dcm_worst, 0.0005);
}

TEST(ComFilter, DcmOfANoisyPendulumIsWithinFourMillimetres) {
  const Errors errors = follow(0.0, 0.0005, 0.001);
  EXPECT_LT(errors.dcm_rms, 0.004);
  EXPECT_LT(errors.dcm_worst, 0.016);
  EXPECT_LT(errors.velocity_rms, 0.02);
}

TEST(ComFilter, AnErrorOfTheModelsComShiftsTheDcmByItselfAndNoMore) {
  EXPECT_LT(follow(0.006, 0.0, 0.0).dcm_rms, 0.0005);
}

TEST(ComFilter, BeatsDifferencesOfThePosition) {
  // The difference of two positions with 0.5 mm of noise has 71 mm/s of noise.
  EXPECT_LT(follow(0.0, 0.0005, 0.001).velocity_rms, 0.3 * std::sqrt(2.0) * 0.0005 / kSlot_s);
}

TEST(ComFilter, FindsAPushAsUnexplainedAcceleration) {
  ComFilter filter(EstimatorParameters{}, kOmega, kSlot_s);
  Pendulum pendulum;
  pendulum.push = 0.8;
  for (int i = 0; i < 200; ++i) {
    pendulum.advance(0.0);
    filter.predict(kOmega * kOmega * (filter.position_m() - pendulum.zmp));
    filter.correct(pendulum.position);
  }
  EXPECT_NEAR(filter.unexplained_m_per_s2(), 0.8, 0.05);
  EXPECT_NEAR(filter.velocity_m_per_s(), pendulum.velocity, 0.005);
}

TEST(ComFilter, GainIsTheSameForEveryFilterAndSmallerForWorseKinematics) {
  EstimatorParameters noisy;
  noisy.com_noise_m = 0.01;
  const ComFilter good(EstimatorParameters{}, kOmega, kSlot_s), bad(noisy, kOmega, kSlot_s);
  EXPECT_EQ(good.gain(), ComFilter(EstimatorParameters{}, kOmega, kSlot_s).gain());
  EXPECT_GT(good.gain()[0], bad.gain()[0]);
  EXPECT_GT(bad.gain()[0], 0.0);
}

}  // namespace
}  // namespace gaitway::zmp
