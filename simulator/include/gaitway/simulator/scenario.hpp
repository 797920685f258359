// A scenario: what is asked of the robot, and what is done to it, at which time. Read from YAML:
//
//   seconds: 20
//   to_the_end: true                           # without it a run ends a second after a fall that no motion
//   follows world: boxes                               # a file beside this one, or a shipped one;
//   world_choice.hpp world_seed: 7                              # of its random courses; without it the
//   world's own conditions: {slope_deg: [5, 0]}              # of the ground and the body; see conditions.hpp
//   events:
//     - {at_s: 1.0, walk: [0.15, 0.0, 0.0]}        # forward m/s, left m/s, turn rad/s
//     - {at_s: 8.0, stand: true}                   # stop walking: finish the step and stand
//     - {at_s: 8.5, motion: wave}                  # a key-frame motion; leave_motion: true ends it early
//     - {at_s: 1.0, walk_to: {x_m: 2.3, y_m: 2.3, yaw_deg: 90}}   # on its own; leave_way: true ends that
//     - {at_s: 2.0, head: {look: direction, yaw_deg: 30, pitch_deg: 10}}   # or point_m: [1, 0, 0.2] with
//     look: point;
//                                  # look: scan, extent_deg: 60, period_s: 4; look: ahead; look: hold
//     - {at_s: 8.7, command: let_go}               # the behaviour may command again; or take
//     - {at_s: 9.0, stop: true}                    # user command: the message controller plays the safe tail
//     - {at_s: 9.5, emergency_stop: hold}          # or: soft
//     - {at_s: 9.8, release: true}                 # of the emergency stop: the joints hold where they are
//     - {at_s: 10.0, push: {direction: [0, 1, 0], impulse_Ns: 1.0, duration_s: 0.1}}  # of the link with the
//     IMU;
//                                                                                     # body: another link
//     - {at_s: 12.0, fault: {kind: main_controller_silent, duration_s: 3.0}}
//     - {at_s: 12.0, fault: {kind: message_controller_silent, duration_s: 1.0}}   # or also: restarts: true
//     - {at_s: 15.0, fault: {kind: lose_frames, probability: 0.02, duration_s: 2.0}}
//     - {at_s: 16.0, fault: {kind: disturb_bus, corruption: 0.01, omission: 0.001, duplicate: 0.001,
//     duration_s: 60}}
//     - {at_s: 16.1, fault: {kind: jam, duration_s: 0.002}}                       # or also: stuck: true
//     - {at_s: 16.2, fault: {kind: bus_off, node: message_controller}}            # or a joint's name
//     - {at_s: 16.3, fault: {kind: joint_restarts, joint: left_knee, duration_s: 0.02}}
//     - {at_s: 16.3, fault: {kind: joint_dies, joint: left_knee}}                # without power for good
//     - {at_s: 16.3, fault: {kind: misses_frames, node: left_knee, duration_s: 0.01}}   # it alone hears
//     nothing
//     - {at_s: 16.3, fault: {kind: lose_frames, probability: 1, duration_s: 0.08, batch_of: left_knee}}
//     - {at_s: 16.3, fault: {kind: babbles, id: 0, data: [], duration_s: 0.05}}   # node: a joint's station
//     - {at_s: 16.3, fault: {kind: batch_fails, how: late, late_s: 0.03}}
//                                  # or damaged, old, early, stale, garbage
//     - {at_s: 16.3, fault: {kind: supply_sags, torque_factor: 0.5, duration_s: 0.5}}
//     - {at_s: 16.4, fault: {kind: foreign_frame, id: 0x7AB, data: [1, 2, 3]}}    # or also: extended: true,
//     remote: true
//     - {at_s: 17.0, fault: {kind: plugin_fails, plugin: zmp, how: throws, duration_s: 1.0}}
//     - {at_s: 17.5, fault: {kind: sensor_fails, sensor: imu, how: freezes, duration_s: 0.5}}
//                                  # or left_foot, right_foot, a joint; reads_zero, noisy, biased, exchanged
//     - {at_s: 18.0, spawn: {name: crate, shape: box, size_m: [0.2, 0.2, 0.1], position_m: [1, 0, 0.05]}}
//                                  # or cylinder, sphere; with mass_kg it can be pushed; yaw_deg, colour
//     - {at_s: 19.0, move: {name: crate, position_m: [1, 0.5, 0.05], yaw_deg: 30}}
//     - {at_s: 20.0, remove: {name: crate}}          # what was spawned
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "gaitway/simulator/conditions.hpp"
#include "gaitway/simulator/scenario_event.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/world/world_choice.hpp"

namespace gaitway::simulator {

struct Scenario {
  double seconds = 20.0;
  Conditions conditions = {};
  std::optional<world::WorldChoice> world = std::nullopt;  // none: an endless floor
  std::vector<ScenarioEvent> events;                       // in order of time
  bool to_the_end = false;                                 // goes on after a fall
};

// Throws input::InputError with file, line, field, value and rule. Pushes must name a link of `robot`, and
// every event must come before the end.
Scenario load_scenario(const std::filesystem::path& file, const urdf::RobotModel& robot);

// Stands for one second, then walks.
Scenario walk_scenario(double forward_m_per_s, double left_m_per_s, double turn_rate_rad_per_s,
                       double seconds);

}  // namespace gaitway::simulator
