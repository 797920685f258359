// The trials of each kind of row, as data.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/measure/gait_trial.hpp"

namespace gaitway::tools {

// What is the same in all trials of a table.
struct TrialFrame {
  double gait_cycle_s = 0.8;
  bool quick = false;
};

// The floors of walking in each direction.
inline constexpr double kFloorForward_m_per_s = 0.35, kFloorBackward_m_per_s = 0.2,
                        kFloorSideways_m_per_s = 0.08, kFloorTurn_rad_per_s = 0.8;

inline constexpr double kCommand_s = 1.0;    // the first walk command of a trial comes then
inline constexpr double kStartUp_s = 3.0;    // from a command to steady walking
inline constexpr double kRise_s = 12.0;      // so long it may take from the command to stand
inline constexpr double kAfterPush_s = 4.0;  // the robot must still be up then

// A standing robot in the environment of all rows: sensor noise, gyro bias, play in the joints.
Trial plain_trial(const TrialFrame& frame, std::uint64_t seed, double seconds);

// Stands, and then walks `walked_s` with one command.
Trial walk(const TrialFrame& frame, std::uint64_t seed, const Eigen::Vector3d& velocity, double walked_s,
           double stand_s = kCommand_s);

// Velocities drawn anew every 1 to 4 s, each component within the floors of its direction.
Trial random_walk(const TrialFrame& frame, std::uint64_t seed, double walked_s);

// On the ellipse through the floors ahead, back and to both sides (ahead as far as back), and turning both
// ways.
std::vector<Trial> walks_in_all_directions(const TrialFrame& frame, std::uint64_t seed);

// Directions are evenly spread, 0 is ahead.
std::vector<Trial> pushes_while_standing(const TrialFrame& frame, std::uint64_t seed, double impulse_Ns,
                                         const std::vector<double>& directions_rad);
// Walking ahead at a speed, or on the spot; at instants spread evenly over one gait cycle.
std::vector<Trial> pushes_while_walking(const TrialFrame& frame, std::uint64_t seed, double impulse_Ns,
                                        double speed_m_per_s);

// The ground rises by `slope_deg` towards each direction: standing and walking ahead.
std::vector<Trial> slopes(const TrialFrame& frame, std::uint64_t seed, double slope_deg);

// The ground rises and falls by so much at a line ahead that the feet meet at several places of a step.
std::vector<Trial> steps_in_the_ground(const TrialFrame& frame, std::uint64_t seed, double height_m);

// Falls that nothing prevents: a violent push on the standing and on the walking robot from anywhere at any
// instant, a deep step down that nobody told of, and the stand on a steep slope.
std::vector<Trial> falls(const TrialFrame& frame, std::uint64_t seed);

// What a robot must walk through without taking it for a fall, some `minutes` of it: random commands and fast
// walking, pushes that it stands, tiles, slopes, slippery ground. The joints stay stiff whatever is told, so
// that one sees who would have fallen.
std::vector<Trial> hard_walking(const TrialFrame& frame, std::uint64_t seed, double minutes);

std::vector<double> evenly_spread_directions_rad(int count);

// Felled while it stands by a push into the direction, at any instant; lies, and is told to play the motion.
Trial get_up(const TrialFrame& frame, std::uint64_t seed, double direction_rad, const std::string& motion);

}  // namespace gaitway::tools
