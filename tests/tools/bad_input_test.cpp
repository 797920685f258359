// Bad input as a user meets it: `gaitway run` says file, line, field, value and rule, ends with exit code 1,
// and nothing has moved: no result is written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "broken_robot.hpp"

namespace gaitway::tools {
namespace {

using Parts = std::vector<std::string>;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string quoted(const std::filesystem::path& path) {
  return "'" + path.string() + "'";
}

class BadInput : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path file(const std::string& name) const { return robot_.folder() / name; }

  // Runs the command and returns its exit code; what it says on stderr is in `complaint_`.
  int run(const std::string& arguments) {
    std::filesystem::remove_all(file("out"));
    const std::string line = std::string(GAITWAY_COMMAND) + " " + arguments + " >" + quoted(file("said")) +
                             " 2>" + quoted(file("complaint"));
    const int status = std::system(line.c_str());
    complaint_ = text_of(file("complaint"));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  void expect_refused_line(const std::string& arguments, const Parts& parts) {
    EXPECT_EQ(run(arguments), 1) << arguments << "\n" << complaint_;
    for (const std::string& part : parts) {
      EXPECT_THAT(complaint_, testing::HasSubstr(part));
    }
    EXPECT_EQ(text_of(file("said")), "");
    for (const char* const result : {"summary.json", "bus.log", "states.csv", "report.html"}) {
      EXPECT_FALSE(std::filesystem::exists(file("out") / result)) << result << " after: " << complaint_;
    }
  }
  void expect_refused(const std::string& options, const Parts& parts) {
    expect_refused_line("run --no-pictures --out " + quoted(file("out")) + " " + options, parts);
  }

  // One damage of the robot's description; the complaint must name the file.
  void expect_robot_refused(const std::string& name, const std::string& before, const std::string& after,
                            Parts parts) {
    urdf::test::BrokenRobot robot;
    robot.replace(name, before, after);
    parts.push_back(robot.folder().string() + "/robot.");
    expect_refused("--robot " + quoted(robot.folder()), parts);
  }
  // The complaint must name the damaged line, too.
  void expect_robot_line_refused(const std::string& name, const std::string& before, const std::string& after,
                                 Parts parts) {
    urdf::test::BrokenRobot robot;
    robot.replace(name, before, after);
    parts.push_back(robot.line_of(name, after));
    expect_refused("--robot " + quoted(robot.folder()), parts);
  }
  void expect_config_refused(const std::string& text, Parts parts) {
    robot_.write("walk.yaml", text);
    parts.push_back(file("walk.yaml").string());
    expect_refused("--config " + quoted(file("walk.yaml")), parts);
  }
  // The shipped plug-ins, and one more entry.
  void expect_plugin_refused(const std::string& entry, const Parts& parts) {
    expect_config_refused(text_of(GAITWAY_DEFAULT_CONFIGURATION) + "  - " + entry + "\n", parts);
  }
  void expect_trajectory_refused(const std::string& parameters, const Parts& parts) {
    expect_config_refused("plugins:\n  - name: zmp\n  - name: trajectory\n    parameters: {" + parameters +
                              "}\n  - name: stability\n  - name: kinematics\n",
                          parts);
  }
  void expect_scenario_refused(const std::string& event, Parts parts) {
    robot_.write("scenario.yaml",
                 "seconds: 3\nevents:\n  - {at_s: 1.0, walk: [0.1, 0, 0]}\n  - " + event + "\n");
    parts.push_back(file("scenario.yaml").string() + ":4: events[1]");
    expect_refused("--scenario " + quoted(file("scenario.yaml")), parts);
  }

  urdf::test::BrokenRobot robot_;  // undamaged: its folder takes all that a test writes
  std::string complaint_;
};

std::string test_plugin(const std::string& name) {
  return std::string(GAITWAY_TEST_PLUGINS) + "/" + name + ".so";
}

// Shows that the checks below could fail: undamaged copies of everything walk and leave results.
TEST_F(BadInput, GoodInputOfTheSameKindRuns) {
  robot_.write("walk.yaml", text_of(GAITWAY_DEFAULT_CONFIGURATION));
  robot_.write("scenario.yaml",
               "seconds: 0.3\nevents:\n  - {at_s: 0.1, walk: [0.1, 0, 0]}\n"
               "  - {at_s: 0.2, push: {body: trunk, direction: [1, 0, 0], impulse_Ns: 0.1}}\n");
  EXPECT_EQ(
      run("run --no-pictures --robot " + quoted(robot_.folder()) + " --config " + quoted(file("walk.yaml")) +
          " --scenario " + quoted(file("scenario.yaml")) + " --out " + quoted(file("out"))),
      0)
      << complaint_;
  for (const char* const result : {"summary.json", "bus.log", "states.csv", "report.html"}) {
    EXPECT_TRUE(std::filesystem::exists(file("out") / result)) << result;
  }
}

TEST_F(BadInput, ARobotWithoutACameraHasNoEyesAndABrokenOneIsNamed) {
  const std::string robot = "--robot " + quoted(robot_.folder());
  expect_refused(robot + " --eyes " + quoted(file("eyes")), {"--eyes", "has no camera", "camera.yaml"});
  EXPECT_FALSE(std::filesystem::exists(file("eyes")));
  robot_.write("camera.yaml", "link: head\nposition: [0, 0, 0]\n");
  expect_refused(robot, {"camera.yaml:2", "Did you mean 'position_m'?"});
}

TEST_F(BadInput, AWrongLineReachesTheTerminalWithoutEscapeSequences) {
  const std::string clear = "\"$(printf '\\033[2J')\"";
  for (const std::string& line :
       {clear, "run " + clear, "run --seed " + clear, "run --" + clear + "=3", "run --quiet=" + clear}) {
    expect_refused_line(line, {"\\x1B[2J"});
    EXPECT_THAT(complaint_, testing::Not(testing::HasSubstr("\x1B"))) << line;
  }
}

TEST_F(BadInput, MissingRobotFiles) {
  expect_refused("--robot /nowhere", {"/nowhere/robot.urdf", "missing"});
  robot_.remove("robot.yaml");
  expect_refused("--robot " + quoted(robot_.folder()), {file("robot.yaml").string(), "missing"});
  robot_.remove("robot.urdf");
  expect_refused("--robot " + quoted(robot_.folder()), {file("robot.urdf").string(), "missing"});
}

TEST_F(BadInput, MalformedRobotFiles) {
  expect_robot_line_refused("robot.yaml", "node: 3, ", "node: 3]", {"column", "malformed YAML"});
  expect_robot_refused("robot.urdf", "</link>", "</lonk>", {"robot.urdf:", "column", "malformed XML"});
  robot_.write("robot.urdf", "no XML at all");
  expect_refused("--robot " + quoted(robot_.folder()), {file("robot.urdf").string(), "malformed XML"});
}

TEST_F(BadInput, UnknownKeysOfTheRobotNameTheNearest) {
  expect_robot_line_refused("robot.yaml", "node: 4, ", "nod: 4, ",
                            {"joints[3] key = 'nod': there is no such key", "Did you mean 'node'?"});
  expect_robot_line_refused("robot.urdf", "<mass value", "<mas value",
                            {"link 'pelvis' inertial = <mas>", "Did you mean 'mass'?"});
  expect_robot_line_refused("robot.urdf", "effort=", "efort=",
                            {"joint 'left_hip_yaw' limit efort = '8'", "Did you mean 'effort'?"});
}

TEST_F(BadInput, WrongUnitsOfTheRobot) {
  expect_robot_refused("robot.urdf", "xyz=\"0 0.05 0\"", "xyz=\"0 50 0\"",
                       {"robot.urdf:", "joint 'left_hip_yaw' origin = 50", "in metres"});
  expect_robot_refused(
      "robot.urdf", "lower=\"-0.8\" upper=\"1\"", "lower=\"-46\" upper=\"57\"",
      {"robot.urdf:", "joint 'left_hip_yaw' limit lower = -46", "Write radians, not degrees"});
  expect_robot_line_refused("robot.yaml", "hip_height_m: 0.36", "hip_height_m: 360",
                            {"standing.hip_height_m = '360'", "Check the unit"});
  expect_robot_line_refused("robot.yaml", "count_deg: 0.05  ", "count_deg: 50  ",
                            {"defaults.count_deg = '50'", "must be 0.001..0.5 deg", "Check the unit"});
}

TEST_F(BadInput, AJointWithTwoControllers) {
  expect_robot_line_refused(
      "robot.yaml", "{name: waist_pitch,          node: 14", "{name: waist_yaw,            node: 14",
      {"joints[13].name = 'waist_yaw'", "List each joint once: it has one local controller"});
  expect_robot_line_refused(
      "robot.yaml", "node: 14", "node:  13",
      {"joints[13].node = '13'", "controller 13 is taken by joint 'waist_yaw' already"});
}

TEST_F(BadInput, UrdfAndYamlThatContradictEachOther) {
  expect_robot_refused("robot.yaml", "  - {name: right_elbow,          node: 22, home_deg: -30}\n", "",
                       {"robot.urdf:", "'right_elbow'", "no local controller in robot.yaml"});
  expect_robot_line_refused(
      "robot.yaml", "left_elbow, ", "left_ellbow, ",
      {"joint name = 'left_ellbow'", "there is no such joint in robot.urdf", "Did you mean 'left_elbow'?"});
  expect_robot_line_refused("robot.yaml", "left_foot_acceleration_y], home_deg: 39.5",
                            "left_foot_acceleration_y], home_deg: -39.5", {"'left_knee'", "-39.5"});
  expect_robot_line_refused("robot.yaml", "hip_height_m: 0.36", "hip_height_m: 0.30",
                            {"standing.hip_height_m = 0.3", "in the home posture the left hip is 0.3600 m"});
  expect_robot_refused("robot.urdf", "effort=\"8\"", "effort=\"2\"",
                       {"robot.yaml:", "'left_hip_yaw' torque_limit_Nm = 8", "the URDF's effort limit is 2"});
}

TEST_F(BadInput, MissingAndMalformedConfiguration) {
  expect_refused("--config /nowhere/walk.yaml",
                 {"/nowhere/walk.yaml: the file is missing or cannot be read"});
  expect_config_refused("plugins:\n  - {name: zmp\n", {"walk.yaml:", "malformed YAML"});
  expect_config_refused("", {"must be a map"});
}

TEST_F(BadInput, UnknownKeysOfTheConfigurationNameTheNearest) {
  expect_config_refused("plugins:\n  - name: zmp\n    libary: x.so\n",
                        {"walk.yaml:3: plugins[0] key = 'libary'", "Did you mean 'library'?"});
  expect_trajectory_refused("step_tme: 0.4 s", {"walk.yaml:4", "'trajectory' has no parameter 'step_tme'",
                                                "Did you mean 'step_time'?"});
}

TEST_F(BadInput, ParametersInWrongUnitsOrOutOfRange) {
  expect_trajectory_refused(
      "step_time: 400 mm",
      {"walk.yaml:4: parameter 'step_time' of 'trajectory' = '400 mm'", "must be in 's'"});
  expect_trajectory_refused(
      "step_time: 400", {"walk.yaml:4: parameter 'step_time' of 'trajectory' = '400'", "from 0.2 to 1 s"});
  expect_trajectory_refused("step_time: fast", {"walk.yaml:4", "'fast'", "must be a finite number in s"});
}

TEST_F(BadInput, PluginsThatCannotBeLoaded) {
  expect_plugin_refused("{name: other, library: " + test_plugin("other_abi") + "}",
                        {"plug-in 'other' (", "walk.yaml:12)", "built for plug-in ABI 6", "speaks ABI 5.0"});
  expect_plugin_refused("{name: other, library: " + test_plugin("wrong_size") + "}",
                        {"plug-in 'other' (", "its gaitway_tick has"});
  expect_plugin_refused("{name: other, library: " + test_plugin("missing_symbol") + "}",
                        {"plug-in 'other' (", "has no symbol 'gaitway_plugin_entry'"});
  expect_plugin_refused("{name: other, library: " + test_plugin("throws_in_constructor") + "}",
                        {"plug-in 'other' (", "its constructor failed: no calibration file"});
  expect_plugin_refused("{name: other, library: " + quoted(file("robot.urdf")) + "}",
                        {"plug-in 'other' (", "is no shared library"});
  expect_plugin_refused("{name: other, library: libother.so}",
                        {"plug-in 'other' (", "no library 'libother.so'"});
}

TEST_F(BadInput, TopicsWithTwoWritersOrNone) {
  expect_plugin_refused("{name: second, library: " + test_plugin("relay") + ", parameters: {to: correction}}",
                        {"topic 'correction' has two writers", "'stability'", "'second'"});
  expect_plugin_refused(
      "{name: second, library: " + test_plugin("relay") + ", parameters: {to: walk_command}}",
      {"topic 'walk_command' has two writers", "'second'", "'arbiter'"});
  expect_config_refused("plugins:\n  - name: kinematics\n",
                        {"plug-in 'kinematics' reads topic 'motion_plan', but nobody writes it"});
}

TEST_F(BadInput, PluginsOfWhichNoneMovesAJoint) {
  expect_config_refused("plugins:\n  - name: zmp\n",
                        {"no plug-in writes the topic 'joint_plan'", "'kinematics'"});
}

TEST_F(BadInput, ConfigurationsThatAreTooLargeOrTwo) {
  const std::string text = text_of(GAITWAY_DEFAULT_CONFIGURATION);
  expect_config_refused(text + "---\nplugins: []\n", {"a second document begins here"});
  expect_config_refused(text + "# " + std::string(5'000'000, 'x') + "\n", {"the file is larger than 4 MiB"});
  std::string many = text;
  for (int i = 0; i < 10'000; ++i)
    many += "  - {name: zmp" + std::to_string(i) + ", library: libgaitway_plugin_zmp.so}\n";
  expect_config_refused(many, {"must be a list of at most 64 plug-ins"});
}

TEST_F(BadInput, EscapeSequencesDoNotReachTheTerminal) {
  expect_config_refused("plugins:\n  - name: \"zmp\\e[2J\"\n    library: x\n", {"\\x1B[2J"});
  EXPECT_EQ(complaint_.find('\x1B'), std::string::npos) << complaint_;
}

TEST_F(BadInput, UnreachableFootsteps) {
  expect_trajectory_refused(
      "max_step_forward: 0.3 m",
      {"walk.yaml:3", "max_step_forward = 0.3 m", "footstep unreachable", "but the leg reaches 0.338 m"});
  expect_trajectory_refused("hip_height: 0.39", {"hip_height = 0.39 m", "footstep unreachable"});
}

TEST_F(BadInput, MissingAndMalformedScenario) {
  expect_refused("--scenario /nowhere/push.yaml",
                 {"/nowhere/push.yaml: the file is missing or cannot be read"});
  expect_refused("--scenario push_of_its_feet",
                 {"--scenario", "'push_of_its_feet'", "none of that name is shipped", "'push_off_its_feet'"});
  robot_.write("scenario.yaml", "seconds: 3\nevents: [\n");
  expect_refused("--scenario " + quoted(file("scenario.yaml")), {"scenario.yaml:", "malformed YAML"});
  robot_.write("scenario.yaml", "second: 3\n");
  expect_refused("--scenario " + quoted(file("scenario.yaml")),
                 {"scenario.yaml:1: key = 'second'", "Did you mean 'seconds'?"});
  robot_.write("scenario.yaml", "seconds: -3\n");
  expect_refused("--scenario " + quoted(file("scenario.yaml")), {"scenario.yaml:1: seconds = '-3': must be"});
}

TEST_F(BadInput, ScenarioEventsThatCannotBe) {
  expect_scenario_refused("{at_s: 2, wlak: [0.1, 0, 0]}", {"key = 'wlak'", "Did you mean 'walk'?"});
  expect_scenario_refused("{at_s: -2, walk: [0.1, 0, 0]}", {".at_s = '-2': must be 0.."});
  expect_scenario_refused("{at_s: 3, stop: true}", {".at_s = '3': must be before the end of the run at 3 s"});
  expect_scenario_refused("{at_s: soon, walk: [0.1, 0, 0]}", {".at_s = 'soon': must be a number"});
  expect_scenario_refused("{at_s: 2, walk: [0.1, x, 0]}", {".walk[1] = 'x': must be a number"});
  expect_scenario_refused("{at_s: 2, walk: [0.1, .nan, 0]}", {".walk[1] = '.nan': must be a number"});
  expect_scenario_refused("{at_s: 2, walk: [1.5, 0, 0]}", {".walk", "at most 1 m/s"});
  expect_scenario_refused("{at_s: 2, walk: [0.1, 0]}", {".walk = a list of 2: must be a list of 3"});
  expect_scenario_refused("{at_s: 2, walk: [0.1, 0, 0], stand: true}", {"exactly one of"});
  expect_scenario_refused("{at_s: 2, stop: false}", {".stop = 'false': must be true"});
  expect_scenario_refused("{at_s: 2, emergency_stop: firm}",
                          {".emergency_stop = 'firm': must be hold or soft"});
}

TEST_F(BadInput, ScenarioMotionsThatDoNotExist) {
  robot_.write("scenario.yaml", "seconds: 3\nevents:\n  - {at_s: 1, motion: dnace}\n");
  expect_refused("--scenario " + quoted(file("scenario.yaml")),
                 {"scenario.yaml: the event at 1 s: there is no motion 'dnace'."});
}

TEST_F(BadInput, ScenarioPushesAndFaultsThatCannotBe) {
  expect_scenario_refused(
      "{at_s: 2, push: {body: tunk, direction: [1, 0, 0], impulse_Ns: 1}}",
      {".push.body = 'tunk': the robot 'humanoid22' has no such link", "Did you mean 'trunk'?"});
  expect_scenario_refused("{at_s: 2, push: {body: trunk, direction: [0, 0, 0], impulse_Ns: 1}}",
                          {".push.direction", "must not be zero"});
  expect_scenario_refused("{at_s: 2, push: {body: trunk, direction: [1, 0, 0], impulse_Ns: 1000}}",
                          {".push.impulse_Ns = '1000': must be 0..400 N*s"});
  expect_scenario_refused("{at_s: 2, push: {body: trunk, direction: [1, 0, 0], impulse: 1}}",
                          {"key = 'impulse'", "Did you mean 'impulse_Ns'?"});
  expect_scenario_refused(
      "{at_s: 2, fault: {kind: lose_frame, probability: 0.1, duration_s: 1}}",
      {".fault.kind = 'lose_frame': must be main_controller_silent, message_controller_silent, batch_fails"});
  expect_scenario_refused("{at_s: 2, fault: {kind: plugin_fails, plugin: zmp, how: sulks}}",
                          {".fault.how = 'sulks': must be throws, not_a_number, jumps or overruns"});
  expect_scenario_refused("{at_s: 2, fault: {kind: lose_frames, probability: 2, duration_s: 1}}",
                          {".fault.probability = '2': must be 0..1"});
  expect_scenario_refused("{at_s: 2, fault: {kind: main_controller_silent, probability: 0.5}}",
                          {".fault key = 'probability': there is no such key. Known here: kind, duration_s"});
}

TEST_F(BadInput, OptionsThatCannotBe) {
  expect_refused("--walk 5", {"walk command 5", "at most 1 m/s"});
  expect_refused("--walk nan", {"--walk nan: must be a number"});
  expect_refused("--walk 0.1,0,0,0", {"--walk", "VX[,VY[,WZ]]"});
  expect_refused("--walk fast", {"--walk", "fast"});
  expect_refused("--seconds 0", {"--seconds 0"});
  expect_refused("--seconds -5", {"--seconds -5"});
  expect_refused("--seconds nan", {"--seconds nan"});
  expect_refused("--seconds long", {"--seconds", "long"});
  expect_refused("--film 3", {"--film", "FROM,TO"});
  expect_refused("--film 3,2", {"--film", "FROM,TO"});
  expect_refused("--film 0,nan", {"--film nan: must be a number"});
  expect_refused("--seed -1", {"--seed -1: must be a whole number from 0 to 18446744073709551615"});
  expect_refused("--seed 1e20", {"--seed 1e20: must be a whole number"});
  expect_refused("--seed 100000000000000000000", {"--seed 100000000000000000000: must be a whole number"});
  expect_refused("--mismatch nan", {"--mismatch nan: must be a number"});
  expect_refused("--mismatch 0,5", {"with a decimal point, not with a comma", "'0.5'"});
  expect_refused("--mismatch -1", {"--mismatch -1", "between 0 and 10"});
  expect_refused("--mission patrol --to 1,1,0", {"--mission", "--to"});
  expect_refused("--mission ''", {"--mission", "is empty"});
  expect_refused("--config eye", {"--config", "'eye'", "'eyes'"});
  expect_refused("--wlak 0.1", {"'--wlak': there is no such command or option", "Did you mean '--walk'?"});
  robot_.write("scenario.yaml", "seconds: 1\n");
  expect_refused("--walk 0.1 --scenario " + quoted(file("scenario.yaml")), {"--walk", "--scenario"});
}

TEST_F(BadInput, ServersThatMayNotBe) {
  const std::string serve = "serve --out " + quoted(file("out")) + " ";
  expect_refused_line(serve + "--speed 0", {"--speed 0", "between 0.01 and 100"});
  expect_refused_line(serve + "--port 70000", {"--port 70000", "65535"});
  expect_refused_line(serve + "--seconds -1", {"--seconds -1"});
  expect_refused_line(serve + "--address 0.0.0.0 --port 0",
                      {"address", "0.0.0.0", "token_file", "certificate_file"});
  expect_refused_line(serve + "--address nowhere --port 0", {"address", "nowhere"});
  expect_refused_line(serve + "--port 0 --token-file /no/such/token", {"token_file", "/no/such/token"});
}

TEST_F(BadInput, CommandsThatDoNotExist) {
  expect_refused_line("", {"subcommand is required"});
  expect_refused_line("rnu", {"Did you mean 'run'?"});
  expect_refused_line("rum", {"'rum': there is no such command or option", "Did you mean 'run'?"});
  EXPECT_EQ(std::count(complaint_.begin(), complaint_.end(), '\n'), 1) << complaint_;
  expect_refused_line("ctl reload sway", {"'gaitway ctl reload' is called 'gaitway ctl plugin reload'"});
  expect_refused_line("ctl --port 9390 stop stability", {"'gaitway ctl plugin stop stability'"});
  expect_refused_line("ctl --socket /no/such/socket stop", {"--socket reaches the plug-in manager alone"});
}

// Each command's program is found beside this one, and says what it does and shows how.
TEST_F(BadInput, EveryCommandExplainsItself) {
  for (const char* const command :
       {"run", "api", "serve", "stop", "dev", "ctl", "new-plugin", "plugins", "check-plugin", "bus",
        "measure", "motion", "calibrate", "world", "ctl walk", "ctl stop", "ctl release", "ctl plugin set",
        "ctl recording start"}) {
    EXPECT_EQ(run(std::string(command) + " --help"), 0) << complaint_;
    const std::string said = text_of(file("said"));
    EXPECT_THAT(said, testing::HasSubstr("Example")) << command;
    EXPECT_THAT(said, testing::HasSubstr("  gaitway " + std::string(command))) << command;
  }
}

TEST_F(BadInput, ACommandWhoseProgramIsMissingSaysHowToBuildIt) {
  std::filesystem::copy_file(GAITWAY_COMMAND, file("gaitway"));
  EXPECT_NE(std::system((quoted(file("gaitway")) + " bus --help 2>" + quoted(file("complaint"))).c_str()), 0);
  EXPECT_THAT(text_of(file("complaint")), testing::HasSubstr("./dev gaitway bus"));
}

TEST_F(BadInput, AFolderForResultsThatCannotBeWritten) {
  robot_.write("taken", "");
  expect_refused_line("run --out " + quoted(file("taken")),
                      {"--out", file("taken").string(), "must be a folder"});
  expect_refused_line("run --out " + quoted(file("taken") / "below"), {"--out", "must be a folder"});
  expect_refused_line("run --out /proc/gaitway", {"--out /proc/gaitway", "must be a folder"});
}

}  // namespace
}  // namespace gaitway::tools
