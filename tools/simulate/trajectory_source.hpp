// What can be played without dynamics, and how it is read: prepared and unprepared motions, points as CSV,
// runs, bus logs, recordings of the robot API, and a walk that is planned on the spot.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "gaitway/kinematic/trajectory.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

// A file, the folder of a run, or the name of one of the robot's motions:
//   NAME, *.yaml      a key-frame motion, planned now
//   *.motion          a prepared one
//   *.csv             states.csv of a run, or the points of `gaitway motion plan`
//   *.log             a bus log: the batches as the joints' own controllers play them
//   *.mcap            a recording of the robot API
// Throws std::runtime_error or std::invalid_argument that names file, line, value and rule.
[[nodiscard]] kinematic::Trajectory read_trajectory(const urdf::RobotModel& robot, const std::string& given);

// Forward m/s, left m/s, turn rad/s: half a second of standing, then the walk, as pattern and kinematics plan
// it without feedback. Throws std::runtime_error where a foot is out of reach.
[[nodiscard]] kinematic::Trajectory plan_walk(const urdf::RobotModel& robot,
                                              const std::array<double, 3>& walk, double seconds);

// The single readers.
[[nodiscard]] kinematic::Trajectory read_csv_trajectory(const urdf::RobotModel& robot,
                                                        const std::filesystem::path& file);
[[nodiscard]] kinematic::Trajectory read_bus_log_trajectory(const urdf::RobotModel& robot,
                                                            const std::filesystem::path& file);
[[nodiscard]] kinematic::Trajectory read_recording(const urdf::RobotModel& robot,
                                                   const std::filesystem::path& file);

}  // namespace gaitway::tools
