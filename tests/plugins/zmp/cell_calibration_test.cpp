// Gains of the force cells, and cells that are dead.
#include "gaitway/zmp/cell_calibration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "gaitway/facts/facts.hpp"
#include "gaitway/zmp/foot_contact.hpp"
#include "synthetic_robot.hpp"

namespace gaitway::zmp {
namespace {

using test::humanoid;
using test::weight_N;
using urdf::Side;

using facts::kSlot_s;
constexpr double kNoise_N = 0.2 / 3.16;

// A walk on the spot: the load goes from foot to foot, the ZMP wanders over the loaded one.
class Walk {
 public:
  Walk(unsigned seed, double gain_deviation) : random_(seed) {
    for (auto& foot : gain) {
      for (double& value : foot) value = 1.0 + gain_deviation * normal_(random_);
    }
  }
  void tick() {
    const double t = kSlot_s * tick_++;
    const double left = 0.5 + 0.5 * std::clamp(3.0 * std::sin(2.0 * M_PI * t / 0.8), -1.0, 1.0);
    apparent_weight = 1.0 + 0.1 * std::sin(2.0 * M_PI * t / 0.4);
    for (std::size_t side = 0; side < 2; ++side) {
      zmp_m[side] = {0.01 + 0.03 * std::sin(2.0 * M_PI * t / 0.4),
                     0.012 * std::sin(2.0 * M_PI * t / 0.8 + 0.5)};
      force_N[side] = apparent_weight * weight_N() * (side == 0 ? left : 1.0 - left);
      const auto cells = test::cell_forces(humanoid().feet[side], force_N[side], zmp_m[side]);
      for (std::size_t cell = 0; cell < 4; ++cell) {
        measured_N[side][cell] = gain[side][cell] * cells[cell] + kNoise_N * normal_(random_);
      }
    }
    apparent_weight += 0.02 * normal_(random_);
  }

  CellForces measured_N{};
  CellForces gain{};
  std::array<double, 2> force_N{};
  std::array<Eigen::Vector2d, 2> zmp_m{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  double apparent_weight = 1.0;

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_{0.0, 1.0};
  int tick_ = 0;
};

struct ZmpErrors {
  double raw_m = 0.0, calibrated_m = 0.0, normalised = 0.0;  // RMS, both axes, of single feet under load
};

ZmpErrors walk(Walk& walk, CellCalibration& cells, int ticks) {
  ZmpErrors errors;
  int samples = 0;
  for (int i = 0; i < ticks; ++i) {
    walk.tick();
    cells.update(walk.measured_N, walk.apparent_weight, kSlot_s);
    for (std::size_t side = 0; side < 2; ++side) {
      if (walk.force_N[side] < 0.3 * weight_N()) continue;
      const urdf::Foot& foot = humanoid().feet[side];
      const FootPressure raw = foot_pressure(foot, walk.measured_N[side], 1.0);
      const FootPressure calibrated = foot_pressure(foot, cells.force_N()[side], 1.0);
      CellCalibration::PerCell lever = CellCalibration::PerCell::Zero();
      for (std::size_t cell = 0; cell < 4; ++cell) {
        lever[static_cast<Eigen::Index>(4 * side + cell)] =
            (foot.cell_m[cell].x() - calibrated.zmp_m.x()) / calibrated.force_N;
      }
      const double error = calibrated.zmp_m.x() - walk.zmp_m[side].x();
      errors.raw_m += (raw.zmp_m - walk.zmp_m[side]).squaredNorm();
      errors.calibrated_m += (calibrated.zmp_m - walk.zmp_m[side]).squaredNorm();
      errors.normalised += error * error / cells.variance_of_sum(lever);
      ++samples;
    }
  }
  return {std::sqrt(errors.raw_m / samples), std::sqrt(errors.calibrated_m / samples),
          std::sqrt(errors.normalised / samples)};
}

TEST(CellCalibration, GainsAreLearnedWhileTheZmpWanders) {
  double raw = 0.0, calibrated = 0.0;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    Walk robot(seed, 0.03);
    CellCalibration cells(EstimatorParameters{}, weight_N());
    walk(robot, cells, 500);
    const ZmpErrors errors = walk(robot, cells, 500);
    raw += errors.raw_m / 8;
    calibrated += errors.calibrated_m / 8;
  }
  EXPECT_GT(raw, 0.0008);  // else there was nothing to learn
  EXPECT_LT(calibrated, 0.0005);
}

TEST(CellCalibration, NoiseDoesNotShrinkTheScale) {
  Walk robot(3, 0.0);
  CellCalibration cells(EstimatorParameters{}, weight_N());
  walk(robot, cells, 20000);
  for (const Side side : urdf::kSides) {
    for (std::size_t cell = 0; cell < 4; ++cell) EXPECT_NEAR(cells.gain(side, cell), 1.0, 0.02);
  }
}

TEST(CellCalibration, FeetAreToldAgainstEachOtherByTheWeight) {
  Walk robot(5, 0.0);
  for (double& gain : robot.gain[0]) gain = 1.03;
  for (double& gain : robot.gain[1]) gain = 0.97;
  CellCalibration cells(EstimatorParameters{}, weight_N());
  walk(robot, cells, 6000);
  EXPECT_NEAR(cells.gain(Side::left, 0) / cells.gain(Side::right, 0), 1.03 / 0.97, 0.01);
}

TEST(CellCalibration, UncertaintyOfTheZmpIsHonestFromTheStart) {
  double squares = 0.0;
  for (unsigned seed = 11; seed <= 30; ++seed) {
    Walk robot(seed, 0.03);
    CellCalibration cells(EstimatorParameters{}, weight_N());
    squares += std::pow(walk(robot, cells, 100).normalised, 2) / 20.0;
  }
  EXPECT_GT(std::sqrt(squares), 0.5);
  EXPECT_LT(std::sqrt(squares), 2.0);
}

TEST(CellCalibration, DeadCellIsFoundAndTheOthersStandInForIt) {
  for (std::size_t dead = 0; dead < 8; ++dead) {
    Walk robot(40 + static_cast<unsigned>(dead), 0.01);
    robot.gain[dead / 4][dead % 4] = 0.0;
    CellCalibration cells(EstimatorParameters{}, weight_N());
    walk(robot, cells, 100);
    for (std::size_t cell = 0; cell < 8; ++cell) {
      EXPECT_EQ(cells.is_dead(urdf::kSides[cell / 4], cell % 4), cell == dead) << cell;
    }
    const ZmpErrors errors = walk(robot, cells, 400);
    EXPECT_GT(errors.raw_m, 0.008);
    EXPECT_LT(errors.calibrated_m, 0.0015);
    EXPECT_LT(errors.normalised, 2.0);
  }
}

TEST(CellCalibration, CellThatComesBackIsHeardAgain) {
  Walk robot(7, 0.0);
  robot.gain[1][2] = 0.0;
  CellCalibration cells(EstimatorParameters{}, weight_N());
  walk(robot, cells, 100);
  ASSERT_TRUE(cells.is_dead(Side::right, 2));
  robot.gain[1][2] = 1.0;
  walk(robot, cells, 100);
  EXPECT_FALSE(cells.any_dead());
}

TEST(CellCalibration, UnloadedCellIsNotDead) {
  CellCalibration cells(EstimatorParameters{}, weight_N());
  const urdf::Foot& foot = humanoid().feet[0];
  // The foot on its outer front corner: the rear inner cell bears nothing, as a plate has it.
  const Eigen::Vector2d half = 0.5 * (foot.cell_m[0] - foot.cell_m[3]);
  const Eigen::Vector2d corner = 0.5 * (foot.cell_m[0] + foot.cell_m[3]) + 0.5 * half;
  CellForces measured{};
  measured[0] = test::cell_forces(foot, weight_N(), corner);
  ASSERT_NEAR(measured[0][3], 0.0, 1e-9);
  for (int i = 0; i < 200; ++i) cells.update(measured, 1.0, kSlot_s);
  EXPECT_FALSE(cells.any_dead());
}

}  // namespace
}  // namespace gaitway::zmp
