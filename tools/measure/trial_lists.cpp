// Which trials each row of the gait table consists of, level by level.
#include "tools/measure/trial_lists.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace gaitway::tools {
namespace {

constexpr double kDeg = std::numbers::pi / 180.0;
constexpr double kGyroBias_rad_per_s = 0.2 * kDeg;
constexpr double kBacklash_rad = 0.2 * kDeg;

constexpr double kRoughGroundSpeed_m_per_s = 0.15;
constexpr double kStandFirst_s = 1.5;   // before a push on the standing robot
constexpr double kWalkFirst_s = 3.0;    // and on the walking one
constexpr double kPushCommand_s = 0.5;  // when that one begins to walk
constexpr double kStepAhead_m = 0.6;  // where the ground changes its height: the robot walks steadily by then
constexpr double kAcrossStep_m = 1.0;  // how far it walks on

// Uniform in [0, 1): the standard's distributions differ between libraries, its generators do not.
double unit_of(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1.0p-53;
}
double between(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * unit_of(random);
}

Eigen::Vector2d slope_rad(double rise, double direction_rad) {
  return {std::atan(rise * std::cos(direction_rad)), std::atan(rise * std::sin(direction_rad))};
}

Trial pushed(Trial trial, double at_s, double direction_rad, double impulse_Ns) {
  // Physics steps are milliseconds: an instant between two would not be what the description says.
  const double instant_s = std::round(at_s * 1e3) * 1e-3;
  trial.push = TrialPush{instant_s, direction_rad, impulse_Ns};
  trial.seconds = instant_s + kTrialPush_s + kAfterPush_s;
  return trial;
}

}  // namespace

std::vector<double> evenly_spread_directions_rad(int count) {
  std::vector<double> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    directions.push_back(2.0 * std::numbers::pi * i / count);
  }
  return directions;
}

Trial plain_trial(const TrialFrame& frame, std::uint64_t seed, double seconds) {
  Trial trial;
  trial.seed = seed;
  trial.seconds = seconds;
  trial.gait_cycle_s = frame.gait_cycle_s;
  trial.conditions.body.gyro_bias_deviation_rad_per_s = kGyroBias_rad_per_s;
  trial.conditions.body.backlash_rad = kBacklash_rad;
  return trial;
}

Trial walk(const TrialFrame& frame, std::uint64_t seed, const Eigen::Vector3d& velocity, double walked_s,
           double stand_s) {
  Trial trial = plain_trial(frame, seed, stand_s + walked_s);
  trial.commands.push_back({stand_s, velocity});
  trial.steady_from_s = stand_s + kStartUp_s;
  return trial;
}

Trial random_walk(const TrialFrame& frame, std::uint64_t seed, double walked_s) {
  constexpr std::uint64_t kStream = 0x7261'6E64'6F6D'7761ULL;  // apart from the plant's own random numbers
  std::mt19937_64 random(seed ^ kStream);
  Trial trial = plain_trial(frame, seed, kCommand_s + walked_s);
  double at_s = kCommand_s;
  while (at_s < trial.seconds) {
    const double forward = between(random, -kFloorBackward_m_per_s, kFloorForward_m_per_s);
    const double left = between(random, -kFloorSideways_m_per_s, kFloorSideways_m_per_s);
    const double turn = between(random, -kFloorTurn_rad_per_s, kFloorTurn_rad_per_s);
    trial.commands.push_back({at_s, {forward, left, turn}});
    at_s += between(random, 1.0, 4.0);
  }
  trial.steady_from_s = kCommand_s + kStartUp_s;
  return trial;
}

std::vector<Trial> walks_in_all_directions(const TrialFrame& frame, std::uint64_t seed) {
  const double walked_s = kStartUp_s + (frame.quick ? 4.0 : 10.0);
  std::vector<Trial> trials;
  for (const double direction : evenly_spread_directions_rad(frame.quick ? 4 : 8)) {
    trials.push_back(walk(
        frame, seed,
        {kFloorBackward_m_per_s * std::cos(direction), kFloorSideways_m_per_s * std::sin(direction), 0.0},
        walked_s));
  }
  for (const double sense : {1.0, -1.0}) {
    trials.push_back(walk(frame, seed, {0.0, 0.0, sense * kFloorTurn_rad_per_s}, walked_s));
  }
  return trials;
}

std::vector<Trial> pushes_while_standing(const TrialFrame& frame, std::uint64_t seed, double impulse_Ns,
                                         const std::vector<double>& directions_rad) {
  // At another instant of the 80 ms cycle for each seed.
  std::mt19937_64 random(seed);
  const double at_s = kStandFirst_s + 0.08 * unit_of(random);
  std::vector<Trial> trials;
  trials.reserve(directions_rad.size());
  for (const double direction : directions_rad) {
    trials.push_back(pushed(plain_trial(frame, seed, 0.0), at_s, direction, impulse_Ns));
  }
  return trials;
}

std::vector<Trial> pushes_while_walking(const TrialFrame& frame, std::uint64_t seed, double impulse_Ns,
                                        double speed_m_per_s) {
  const int directions = frame.quick ? 4 : 8, phases = frame.quick ? 4 : 16;
  std::vector<Trial> trials;
  for (int phase = 0; phase < phases; ++phase) {
    for (const double direction : evenly_spread_directions_rad(directions)) {
      Trial trial = plain_trial(frame, seed, 0.0);
      trial.commands.push_back({kPushCommand_s, {speed_m_per_s, 0.0, 0.0}});
      trial.steady_from_s = kPushCommand_s + kStartUp_s;
      trials.push_back(pushed(trial, kPushCommand_s + kWalkFirst_s + frame.gait_cycle_s * phase / phases,
                              direction, impulse_Ns));
    }
  }
  // A seed ends at its first fall: each seed begins elsewhere, so that all directions and phases are seen.
  const auto first = static_cast<std::ptrdiff_t>((seed * 7) % trials.size());
  std::rotate(trials.begin(), trials.begin() + first, trials.end());
  return trials;
}

std::vector<Trial> slopes(const TrialFrame& frame, std::uint64_t seed, double slope_deg) {
  const double stand_s = frame.quick ? 5.0 : 10.0, walked_s = frame.quick ? 8.0 : 20.0;
  const double rise = std::tan(slope_deg * kDeg);
  std::vector<Trial> trials;
  for (const bool walks : {false, true}) {
    for (const double direction : evenly_spread_directions_rad(frame.quick ? 4 : 8)) {
      Trial trial = walks ? walk(frame, seed, {kRoughGroundSpeed_m_per_s, 0.0, 0.0}, walked_s)
                          : plain_trial(frame, seed, stand_s);
      trial.conditions.ground.slope_rad = slope_rad(rise, direction);
      trials.push_back(trial);
    }
  }
  return trials;
}

std::vector<Trial> steps_in_the_ground(const TrialFrame& frame, std::uint64_t seed, double height_m) {
  const int places = frame.quick ? 2 : 4;
  const double stride_m = kRoughGroundSpeed_m_per_s * frame.gait_cycle_s;
  std::vector<Trial> trials;
  for (const double sense : {-1.0, 1.0}) {
    for (int place = 0; place < places; ++place) {
      const double at_m = kStepAhead_m + stride_m * place / places;
      Trial trial = walk(frame, seed, {kRoughGroundSpeed_m_per_s, 0.0, 0.0},
                         kStartUp_s + (at_m + kAcrossStep_m) / kRoughGroundSpeed_m_per_s);
      trial.conditions.ground.step = simulator::GroundStep{at_m, sense * height_m};
      trials.push_back(trial);
    }
  }
  return trials;
}

std::vector<Trial> falls(const TrialFrame& frame, std::uint64_t seed) {
  constexpr double kPi = std::numbers::pi;
  constexpr double kAfterFall_s = 3.0;
  std::mt19937_64 random(seed ^ 0x6661'6C6C'7300'0000ULL);
  const auto anywhere = [&random] { return between(random, -kPi, kPi); };
  std::vector<Trial> trials;
  trials.push_back(pushed(plain_trial(frame, seed, 0.0), kStandFirst_s + 0.08 * unit_of(random), anywhere(),
                          between(random, 4.5, 8.0)));
  Trial walking = plain_trial(frame, seed, 0.0);
  walking.commands.push_back({kPushCommand_s, {between(random, 0.0, kFloorForward_m_per_s), 0.0, 0.0}});
  trials.push_back(pushed(walking, kPushCommand_s + kWalkFirst_s + frame.gait_cycle_s * unit_of(random),
                          anywhere(), between(random, 4.0, 7.0)));
  Trial step = walk(frame, seed, {between(random, 0.15, kFloorForward_m_per_s), 0.0, 0.0}, 8.0);
  step.conditions.ground.step =
      simulator::GroundStep{between(random, 0.5, 0.8), between(random, -0.06, -0.04)};
  trials.push_back(step);
  Trial slope = plain_trial(frame, seed, 4.0);
  const double direction_rad = anywhere(), rise = std::tan(between(random, 13.0, 17.0) * kDeg);
  slope.conditions.ground.slope_rad = slope_rad(rise, direction_rad);
  trials.push_back(slope);
  for (Trial& trial : trials) {
    trial.seconds = std::max(trial.seconds, trial.push ? trial.push->at_s + kAfterFall_s : 0.0);
    trial.watches_fall = true;
  }
  return trials;
}

std::vector<Trial> hard_walking(const TrialFrame& frame, std::uint64_t seed, double minutes) {
  constexpr double kPi = std::numbers::pi;
  constexpr int kPushes = 3;
  constexpr double kPlainWalk_s = 10.0;
  std::vector<Trial> trials;
  for (int minute = 0; minute < std::lround(minutes); ++minute) {
    // Another robot, ground and commands in each minute.
    const std::uint64_t own = seed + 1'000'000 * static_cast<std::uint64_t>(minute);
    std::mt19937_64 random(own ^ 0x6861'7264'0000'0000ULL);
    trials.push_back(random_walk(frame, own, 14.0));
    trials.push_back(
        walk(frame, own, {between(random, kFloorForward_m_per_s, 0.45), 0.0, 0.0}, kPlainWalk_s));
    Trial tiles = walk(frame, own, {between(random, 0.1, 0.2), 0.0, 0.0}, kPlainWalk_s);
    tiles.conditions.ground.tile_height_m = between(random, 0.003, 0.006);
    trials.push_back(tiles);
    Trial slippery = walk(frame, own, {between(random, 0.1, 0.25), 0.0, 0.0}, kPlainWalk_s);
    slippery.conditions.ground.friction = between(random, 0.25, 0.5);
    const double direction_rad = between(random, -kPi, kPi),
                 rise = std::tan(between(random, 0.0, 4.0) * kDeg);
    slippery.conditions.ground.slope_rad = slope_rad(rise, direction_rad);
    trials.push_back(slippery);
    for (int push = 0; push < kPushes; ++push) {
      Trial trial = plain_trial(frame, own, 0.0);
      trial.commands.push_back({kPushCommand_s,
                                {between(random, -kFloorBackward_m_per_s, kFloorForward_m_per_s),
                                 between(random, -kFloorSideways_m_per_s, kFloorSideways_m_per_s), 0.0}});
      trials.push_back(pushed(trial, kPushCommand_s + kWalkFirst_s + frame.gait_cycle_s * unit_of(random),
                              between(random, -kPi, kPi), between(random, 0.6, 1.8)));
    }
  }
  for (Trial& trial : trials) {
    trial.watches_fall = trial.stiff_in_fall = true;
  }
  return trials;
}

Trial get_up(const TrialFrame& frame, std::uint64_t seed, double direction_rad, const std::string& motion) {
  constexpr double kFallAndLie_s = 3.0, kStandOn_s = 3.0, kAnyInstant_s = 1.0, kAskew_rad = 20.0 * kDeg;
  std::mt19937_64 random(seed ^ 0x6765'7420'7570'0000ULL);
  const double at_s = kStandFirst_s + kAnyInstant_s * unit_of(random);
  const double towards_rad = direction_rad + between(random, -kAskew_rad, kAskew_rad);
  Trial trial = pushed(plain_trial(frame, seed, 0.0), at_s, towards_rad, between(random, 7.0, 9.0));
  trial.rise = TrialRise{trial.push->at_s + kFallAndLie_s, motion};
  trial.seconds = trial.rise->at_s + kRise_s + kStandOn_s;
  return trial;
}

}  // namespace gaitway::tools
