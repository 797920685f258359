// Draws a robot, lets it take the poses, and asks it for its deviations in the end.
#include "tools/calibrate/simulated_calibration.hpp"

#include <cmath>
#include <random>

#include "tools/calibrate/pose_performer.hpp"

namespace gaitway::calibration {
namespace {

constexpr double kCellGainDeviation = 0.03;
constexpr int kFewestRounds = 2;

simulator::PlantOptions plant_options(const SimulatedCalibrationOptions& options) {
  simulator::PlantOptions result{.seed = options.seed, .mismatch = options.mismatch};
  result.conditions.body.cell_gain_deviation = options.mismatch * kCellGainDeviation;
  result.conditions.body.backlash_rad = options.play_rad;
  return result;
}

RobotDeviations truth_of(const urdf::RobotModel& robot, const simulator::Plant& plant) {
  const simulator::BodyTruth body = plant.body_truth();
  RobotDeviations truth{.zero_rad = body.encoder_zero_rad,
                        .trunk_com_offset_m = body.trunk_com_offset_m,
                        .mass_factor = {},
                        .cell_gain = body.cell_gain};
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    truth.mass_factor.push_back(body.link_mass_kg[link] / robot.links[link].mass_kg);
  }
  return truth;
}

}  // namespace

SimulatedCalibration calibrate_simulated(const urdf::RobotModel& robot, const motion::MotionPlan& poses,
                                         const SimulatedCalibrationOptions& options) {
  simulator::Plant plant(robot, plant_options(options));
  SimulatedCalibration result;
  result.truth = truth_of(robot, plant);
  if (options.play_rad > 0.0) allow_play(options.play_rad, result.settings.standing);
  if (options.weighing_deviation_kg) {
    std::mt19937_64 random(options.seed);
    std::normal_distribution<double> error(total_mass_kg(robot, result.truth),
                                           *options.weighing_deviation_kg);
    result.settings.weighing = Weighing{error(random), *options.weighing_deviation_kg};
  }
  PosePerformer performer(robot, plant, options.measured_s);
  std::vector<double> zero_rad(robot.joints.size(), 0.0);
  for (int round = 1; round <= options.rounds; ++round) {
    result.measurements = performer.perform(poses, zero_rad, [&](const std::string& pose) {
      if (options.progress) options.progress(round, pose);
    });
    result.calibration = calibrate(robot, result.measurements, result.settings);
    zero_rad = result.calibration.deviations.zero_rad;
    if (round >= kFewestRounds && result.calibration.feet_on_edge == 0) break;
  }
  return result;
}

}  // namespace gaitway::calibration
