// What happens in a scenario, as people and programs write it, and as logs do.
#include "gaitway/simulator/scenario_event.hpp"

#include <gmock/gmock.h>

#include <string>

#include "gaitway/input/complaint.hpp"

namespace gaitway::simulator {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const urdf::RobotModel& robot() {
  static const urdf::RobotModel model = urdf::load_robot(GAITWAY_ROBOT);
  return model;
}

std::string refusal_of(const std::string& text) {
  try {
    static_cast<void>(parse_action(text, "menu", robot()));
  } catch (const input::InputError& error) {
    return error.what();
  }
  return "not refused";
}

class ActionText : public testing::TestWithParam<const char*> {};

// Numbers come back to the bit, since the text of what came back is the same.
TEST_P(ActionText, ReadsBackTheSame) {
  const ScenarioEvent event = parse_action(std::string("{") + GetParam() + "}", "test", robot());
  EXPECT_EQ(action_text(event, robot()), GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    All, ActionText,
    testing::Values(
        "walk: [0.1, -0.030000000000000002, 0.333]", "stand: true", "motion: \"wave\"", "leave_motion: true",
        "walk_to: {x_m: 1.1, y_m: -2.3, yaw_rad: 0.1}", "leave_way: true", "stop: true",
        "emergency_stop: soft", "emergency_stop: hold", "release: true",
        "move_joint: {joint: neck_yaw, position_rad: 0.1, duration_slots: 20}",
        "push: {body: \"trunk\", direction: [0.1, 0.7, 0], impulse_Ns: 1.3, duration_s: 0.05}",
        "fault: {kind: main_controller_silent}", "fault: {kind: main_controller_silent, duration_s: 0.4}",
        "fault: {kind: message_controller_silent}",
        "fault: {kind: message_controller_silent, duration_s: 0.4, restarts: true}",
        "fault: {kind: lose_frames, probability: 0.02, duration_s: 3}",
        "fault: {kind: disturb_bus, corruption: 0.01, omission: 0.002, duplicate: 0, duration_s: 60}",
        "fault: {kind: jam, duration_s: 0.002}", "fault: {kind: jam, duration_s: 0.002, stuck: true}",
        "fault: {kind: bus_off, node: \"message_controller\"}",
        "fault: {kind: joint_restarts, joint: \"left_knee\", duration_s: 0.02}",
        "fault: {kind: foreign_frame, id: 1963, data: [1, 2, 255]}",
        "fault: {kind: foreign_frame, id: 536870911, data: [], extended: true, remote: true}",
        "fault: {kind: lose_frames, probability: 1, duration_s: 0.08, batch_of: \"left_knee\"}",
        "fault: {kind: misses_frames, node: \"left_knee\", duration_s: 0.013000000000000001}",
        "fault: {kind: babbles, id: 0, data: [], duration_s: 0.05}",
        "fault: {kind: babbles, node: \"left_knee\", id: 77, data: [1, 255], duration_s: 0.05}",
        "fault: {kind: batch_fails, how: late, late_s: 0.0123}", "fault: {kind: batch_fails, how: stale}",
        "fault: {kind: joint_dies, joint: \"left_knee\"}",
        "fault: {kind: supply_sags, torque_factor: 0.55, duration_s: 0.5}",
        "fault: {kind: sensor_fails, sensor: \"left_foot\", how: exchanged}",
        "fault: {kind: sensor_fails, sensor: \"imu\", how: biased, duration_s: 0.3}",
        "fault: {kind: plugin_fails, plugin: \"zmp\", how: throws}",
        "fault: {kind: plugin_fails, plugin: \"zmp\", how: overruns, duration_s: 1, cost_s: 0.007}",
        "fault: {kind: sensor_fails, sensor: \"imu\", how: freezes, duration_s: 0.5}",
        "fault: {kind: sensor_fails, sensor: \"left_knee\", how: reads_zero}",
        "fault: {kind: camera_fails, camera: left, how: dead, duration_s: 3}",
        "fault: {kind: camera_fails, camera: both, how: exchanged}",
        "fault: {kind: camera_fails, camera: right, how: turned, turn_deg: [0.7, 0.7, 0]}",
        "fault: {kind: camera_fails, camera: both, how: dropped, duration_s: 2, share: 0.3}",
        "fault: {kind: camera_fails, camera: both, how: late, later_s: 0.25}",
        "spawn: {name: \"a crate\", shape: box, size_m: [0.2, 0.1, 0.3], position_m: [1.1, 0, 0.15], "
        "yaw_rad: "
        "0.3, mass_kg: 0.7, colour: [0.1, 0.2, 1]}",
        "spawn: {name: \"pillar\", shape: cylinder, size_m: [0.2, 0.2, 1], position_m: [1.1, 0, 0.5], "
        "yaw_rad: "
        "0, colour: [0.1, 0.2, 1]}",
        "move: {name: \"a crate\", position_m: [1, 2, 0.1], yaw_rad: -1.5}", "remove: {name: \"a crate\"}"));

TEST(ScenarioAction, TakesDegreesAndJson) {
  const ScenarioEvent event = parse_action(
      R"({"spawn": {"name": "ball", "shape": "sphere", "size_m": [0.2, 0.2, 0.2], "position_m": [1, 0, 0.1],
          "yaw_deg": 90, "mass_kg": 0.4}})",
      "page", robot());
  EXPECT_NEAR(std::get<SpawnEvent>(event.action).yaw_rad, 1.5707963, 1e-6);
}

TEST(ScenarioAction, RefusalsNameFieldValueAndRule) {
  EXPECT_THAT(refusal_of("{}"), HasSubstr("exactly one of walk"));
  EXPECT_THAT(refusal_of("{stop: true, stand: true}"), HasSubstr("exactly one of walk"));
  EXPECT_THAT(refusal_of("{at_s: 1, stop: true}"), HasSubstr("at_s"));
  EXPECT_THAT(refusal_of("{spwan: {}}"), HasSubstr("Did you mean 'spawn'?"));
  const std::string spawn = "name: a, size_m: [0.1, 0.2, 0.1], position_m: [1, 0, 0.1]";
  EXPECT_THAT(refusal_of("{spawn: {shape: cone, " + spawn + "}}"),
              AllOf(HasSubstr("cone"), HasSubstr("box, cylinder or sphere")));
  EXPECT_THAT(refusal_of("{spawn: {shape: cylinder, " + spawn + "}}"), HasSubstr("as wide in x as in y"));
  EXPECT_THAT(refusal_of("{spawn: {shape: box, mass_kg: 0, " + spawn + "}}"), HasSubstr("mass_kg"));
  EXPECT_THAT(refusal_of("{spawn: {shape: box, yaw_deg: 1, yaw_rad: 1, " + spawn + "}}"),
              HasSubstr("beside yaw_deg"));
  EXPECT_THAT(refusal_of("{move: {name: a, position_m: [1000, 0, 0]}}"), HasSubstr("1000"));
  EXPECT_THAT(refusal_of("{remove: {name: \"\"}}"), HasSubstr("1 to 47"));
  EXPECT_THAT(refusal_of("{fault: {kind: sensor_fails, sensor: left_fot, how: noisy}}"),
              HasSubstr("Did you mean 'left_foot'?"));
  EXPECT_THAT(refusal_of("{fault: {kind: sensor_fails, sensor: imu, how: dies}}"), HasSubstr("freezes"));
  EXPECT_THAT(refusal_of("{fault: {kind: sensor_fails, sensor: neck_yaw, how: exchanged}}"),
              HasSubstr("no counterpart"));
  EXPECT_THAT(refusal_of("{fault: {kind: batch_fails, how: stale, late_s: 0.1}}"),
              HasSubstr("belongs to a batch that is late"));
  EXPECT_THAT(refusal_of("{fault: {kind: batch_fails, how: lat}}"), HasSubstr("Did you mean 'late'?"));
  EXPECT_THAT(refusal_of("{fault: {kind: supply_sags, torque_factor: 1.5, duration_s: 1}}"),
              HasSubstr("1.5"));
  EXPECT_THAT(refusal_of("{fault: {kind: babbles, id: 2048, data: [], duration_s: 1}}"), HasSubstr("2048"));
  EXPECT_THAT(refusal_of("{fault: {kind: joint_die, joint: left_knee}}"), HasSubstr("joint_dies"));
  EXPECT_THAT(refusal_of("{fault: {kind: camera_fails, how: froozen}}"),
              AllOf(HasSubstr("dead, dark, over_exposed"), HasSubstr("Did you mean 'frozen'?")));
  EXPECT_THAT(refusal_of("{fault: {kind: camera_fails, how: dead, camera: middle}}"),
              HasSubstr("left, right or both"));
  EXPECT_THAT(refusal_of("{fault: {kind: camera_fails, how: late, camera: left}}"),
              HasSubstr("both cameras"));
  EXPECT_THAT(refusal_of("{fault: {kind: camera_fails, how: dead, share: 0.5}}"),
              HasSubstr("belongs to a camera that is dropped"));
  EXPECT_THAT(refusal_of("{fault: {kind: camera_fails, how: turned, turn_deg: [1, 0]}}"),
              HasSubstr("turn_deg"));
  EXPECT_THAT(refusal_of("[1, 2"), HasSubstr("malformed"));
}

}  // namespace
}  // namespace gaitway::simulator
