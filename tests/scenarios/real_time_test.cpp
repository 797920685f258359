// The chain as three processes in real time: virtual_robot, message_controller and main_controller walk
// together, and each ends well whatever becomes of the others.
#include <gmock/gmock.h>
#include <signal.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "running_process.hpp"

namespace gaitway::scenarios {
namespace {

using testing::HasSubstr;

const std::string kRobot = std::string(GAITWAY_SOURCE_DIR) + "/urdf/humanoid22";
const std::string kConfig = std::string(GAITWAY_SOURCE_DIR) + "/core/config/walk.yaml";

class RealTime : public testing::Test {
 protected:
  RealTime() {
    std::string name = (std::filesystem::temp_directory_path() / "gaitway_rt_XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~RealTime() override { std::filesystem::remove_all(folder); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder / name).string(); }
  [[nodiscard]] nlohmann::json summary(const std::string& name) const {
    return nlohmann::json::parse(text_of(folder / name), nullptr, false);
  }
  std::unique_ptr<Process> start_robot() {
    auto process = std::make_unique<Process>(
        GAITWAY_VIRTUAL_ROBOT, folder / "robot.txt",
        std::vector<std::string>{"--robot", kRobot, "--bus", path("bus"), "--summary", path("robot.json")});
    EXPECT_TRUE(until(20s, [&] { return std::filesystem::exists(folder / "bus"); })) << process->output();
    return process;
  }
  std::unique_ptr<Process> start_message_controller(const std::string& walk) {
    auto process = std::make_unique<Process>(
        GAITWAY_MESSAGE_CONTROLLER, folder / "message.txt",
        std::vector<std::string>{"--robot", kRobot, "--bus", path("bus"), "--memory", path("memory"),
                                 "--walk", walk, "--walk-after", "2", "--summary", path("message.json")});
    EXPECT_TRUE(until(20s, [&] { return std::filesystem::exists(folder / "memory"); })) << process->output();
    return process;
  }
  std::unique_ptr<Process> start_main_controller(const std::string& config = kConfig,
                                                 const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"--socket", path("memory"), "--robot",       kRobot,
                                       "--config", config,         "--plugin-path", GAITWAY_PLUGIN_DIR};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return std::make_unique<Process>(GAITWAY_MAIN_CONTROLLER, folder / "main.txt", arguments);
  }
  // The shipped plug-ins, with one as balance feedback that takes the process down while the robot walks.
  [[nodiscard]] std::string crashing_config(const std::string& parameters) const {
    std::ofstream(folder / "crash.yaml")
        << "plugins:\n  - name: zmp\n  - name: trajectory\n  - name: kinematics\n"
           "  - {name: stability, library: " GAITWAY_TEST_PLUGINS "/crashes.so, parameters: {"
        << parameters << "}}\n";
    return path("crash.yaml");
  }
  // Walks until the plug-in 'stability' brings the process down, and some seconds on.
  void walk_through_a_death(const std::string& parameters, const std::string& how) {
    const auto robot = start_robot();
    const auto message_controller = start_message_controller("0.12,0,0");
    const auto main_controller = start_main_controller(crashing_config(parameters), {"--supervised"});
    EXPECT_TRUE(until(20s, [&] { return main_controller->output().find("back after") != std::string::npos; }))
        << everything();
    std::this_thread::sleep_for(4s);
    EXPECT_EQ(main_controller->stop(), 0) << main_controller->output();
    EXPECT_EQ(message_controller->stop(), 0) << message_controller->output();
    EXPECT_EQ(robot->stop(), 0) << robot->output();
    EXPECT_THAT(main_controller->output(), HasSubstr("in plug-in 'stability', the process " + how));
    EXPECT_THAT(main_controller->output(), HasSubstr("started again, without 'stability'"));
    const std::string text = main_controller->output();
    const int back_ms = std::atoi(text.c_str() + text.find("back after") + std::strlen("back after "));
    EXPECT_LE(back_ms, 1000) << text;
    RecordProperty("back_ms", back_ms);
    ASSERT_TRUE(summary("robot.json").is_object()) << everything();
    EXPECT_FALSE(summary("robot.json")["fell"].get<bool>()) << everything();
    EXPECT_GE(summary("message.json")["tails_played"].get<int>(), 1) << everything();
  }
  // The shipped balance feedback, in a process of its own, fails for a while four seconds into the walk.
  std::string walk_with_sabotage(const std::string& how) {
    const auto robot = start_robot();
    const auto message_controller = start_message_controller("0.12,0,0");
    const double now_s = std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    std::ofstream(folder / "sabotage.yaml")
        << "plugins:\n  - name: zmp\n  - name: trajectory\n  - name: kinematics\n"
           "  - {name: stability, library: " GAITWAY_SABOTEURS
           "/stability.so, isolation: process, parameters: "
           "{sabotage: "
        << how << ", sabotage_at: " << std::fixed << now_s + 6.0 << " s, sabotage_for: 0.1 s}}\n";
    const auto main_controller = start_main_controller(path("sabotage.yaml"));
    std::this_thread::sleep_for(10s);
    EXPECT_EQ(main_controller->stop(), 0) << main_controller->output();
    EXPECT_EQ(message_controller->stop(), 0) << message_controller->output();
    EXPECT_EQ(robot->stop(), 0) << robot->output();
    const nlohmann::json walked = summary("robot.json");
    EXPECT_TRUE(walked.is_object()) << everything();
    EXPECT_FALSE(walked.value("fell", true)) << everything();
    EXPECT_GT(walked.value("distance_m", 0.0), 0.5) << "it never stops " << everything();
    return main_controller->output();
  }
  static void expect_told(const Process& process, const std::string& text) {
    EXPECT_TRUE(until(5s, [&] { return process.output().find(text) != std::string::npos; }))
        << process.output();
  }
  // A robot is there again, and both end well.
  void expect_back_after_one_outage(Process& message_controller) {
    const auto robot = start_robot();
    expect_told(message_controller, "is back after");
    EXPECT_EQ(message_controller.stop(), 0) << message_controller.output();
    EXPECT_EQ(robot->stop(), 0) << robot->output();
    ASSERT_TRUE(summary("message.json").is_object()) << everything();
    EXPECT_EQ(summary("message.json")["bus_outages"].get<int>(), 1) << everything();
  }
  [[nodiscard]] std::string everything() const {
    std::string all;
    for (const char* file : {"robot.txt", "robot.json", "message.txt", "message.json", "main.txt"}) {
      all += std::string("\n--- ") + file + "\n" + text_of(folder / file);
    }
    return all;
  }

  std::filesystem::path folder;
};

TEST_F(RealTime, ThreeProcessesWalkTogether) {
  const auto robot = start_robot();
  const auto message_controller = start_message_controller("0.12,0,0");
  const auto main_controller = start_main_controller();
  std::this_thread::sleep_for(12s);  // two of them until the walk begins
  EXPECT_EQ(main_controller->stop(), 0) << main_controller->output();
  EXPECT_EQ(message_controller->stop(), 0) << message_controller->output();
  EXPECT_EQ(robot->stop(), 0) << robot->output();

  const nlohmann::json walked = summary("robot.json");
  ASSERT_TRUE(walked.is_object()) << everything();
  EXPECT_FALSE(walked["fell"].get<bool>()) << everything();
  EXPECT_GT(walked["distance_m"].get<double>(), 0.5) << everything();
  EXPECT_LT(walked["distance_m"].get<double>(), 1.5) << everything();
  const nlohmann::json handed = summary("message.json");
  ASSERT_TRUE(handed.is_object()) << everything();
  EXPECT_GT(handed["handed_over"].get<int>(), 100) << everything();
  EXPECT_EQ(handed["refused"].get<int>(), 0) << everything();
  for (const char* process : {"robot", "message"}) {
    RecordProperty(process, summary(std::string(process) + ".json").dump());
  }
}

TEST_F(RealTime, TheRobotStandsWhenTheMainControllerIsKilledWhileItWalks) {
  const auto robot = start_robot();
  const auto message_controller = start_message_controller("0.12,0,0");
  const auto main_controller = start_main_controller();
  std::this_thread::sleep_for(6s);
  main_controller->send(SIGKILL);
  EXPECT_EQ(main_controller->wait(), 1000 + SIGKILL);
  std::this_thread::sleep_for(4s);  // the tail lasts two at most
  EXPECT_EQ(message_controller->stop(), 0) << message_controller->output();
  EXPECT_EQ(robot->stop(), 0) << robot->output();
  ASSERT_TRUE(summary("robot.json").is_object()) << everything();
  EXPECT_FALSE(summary("robot.json")["fell"].get<bool>()) << everything();
  EXPECT_GT(summary("robot.json")["distance_m"].get<double>(), 0.15) << "it walked before " << everything();
  EXPECT_GE(summary("message.json")["tails_played"].get<int>(), 1) << everything();
}

TEST_F(RealTime, PlugInsAreReplacedFromTheCommandLineWhileTheRobotWalks) {
  const auto robot = start_robot();
  const auto message_controller = start_message_controller("0.15,0,0");
  const auto main_controller = start_main_controller();
  const auto ctl = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"ctl", "--socket", path("memory"), "plugin"});
    Process command(GAITWAY_COMMAND, folder / "ctl.txt", arguments);
    const int code = command.wait();
    return std::to_string(code) + " " + command.output();
  };
  std::this_thread::sleep_for(3s);  // it walks
  for (const char* const plugin : {"trajectory", "kinematics", "stability", "zmp"}) {
    EXPECT_THAT(ctl({"reload", plugin}),
                testing::AllOf(testing::StartsWith("0 "), HasSubstr("state handed on")))
        << everything();
  }
  EXPECT_THAT(ctl({"parameters", "stability"}),
              testing::AllOf(testing::StartsWith("0 "), HasSubstr("trim_limit")));
  EXPECT_THAT(ctl({"parameters", "stabilty"}),
              testing::AllOf(testing::StartsWith("2 "), HasSubstr("Did you mean 'stability'?")));
  EXPECT_THAT(ctl({"reload", "trajektory"}),
              testing::AllOf(testing::StartsWith("2 "), HasSubstr("Did you mean 'trajectory'?")));
  EXPECT_THAT(
      ctl({"load", "kinematics"}),
      testing::AllOf(testing::StartsWith("2 "), HasSubstr("there is a plug-in 'kinematics' already")));
  EXPECT_THAT(ctl({"unload", "kinematics"}), testing::StartsWith("0 ")) << everything();
  EXPECT_THAT(ctl({"load", "kinematics"}), testing::StartsWith("0 ")) << everything();
  EXPECT_THAT(ctl({"stop", "stability"}), testing::StartsWith("0 ")) << everything();
  EXPECT_THAT(ctl({"start", "stability"}), testing::StartsWith("0 ")) << everything();
  EXPECT_THAT(ctl({"start", "stability"}),
              testing::AllOf(testing::StartsWith("2 "), HasSubstr("is not stopped")));
  EXPECT_EQ(main_controller->stop(), 0);
  EXPECT_EQ(message_controller->stop(), 0);
  EXPECT_EQ(robot->stop(), 0);
  EXPECT_FALSE(summary("robot.json")["fell"].get<bool>()) << everything();
}

// At another instant of the walk each time; once in every run, fifty times in the long one.
class RealTimeCrash : public RealTime, public testing::WithParamInterface<int> {};

TEST_P(RealTimeCrash, InAPluginLeavesTheRobotUpAndTheMainControllerIsBackWithoutIt) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  walk_through_a_death("after_ticks: " + std::to_string(400 + random() % 200), "was ended by signal 11");
}
INSTANTIATE_TEST_SUITE_P(Instants, RealTimeCrash, testing::Range(0, GAITWAY_CRASHES));

TEST_F(RealTime, APluginThatHangsLeavesTheRobotUpAndTheMainControllerIsBackWithoutIt) {
  walk_through_a_death("after_ticks: 500, hangs: true", "made no tick for 1000 ms");
}

TEST_F(RealTime, ACrashInAnIsolatedPluginIsAFaultOfItsStepAndItIsReplaced) {
  EXPECT_THAT(
      walk_with_sabotage("segfault"),
      testing::AllOf(HasSubstr("was ended by SIGSEGV"), HasSubstr("fallback 'trims_from_gains' stands in"),
                     HasSubstr("runs in a new process"), HasSubstr("works again")));
}

TEST_F(RealTime, AnIsolatedPluginThatHangsIsEndedAndReplaced) {
  EXPECT_THAT(walk_with_sabotage("loop"),
              testing::AllOf(HasSubstr("did not answer within 2 ms"), HasSubstr("its process was ended"),
                             HasSubstr("runs in a new process"), HasSubstr("works again")));
}

TEST_F(RealTime, TheBusWaitsForAMessageControllerThatSleptForThirtyMilliseconds) {
  const auto robot = start_robot();
  const auto message_controller = start_message_controller("0.12,0,0");
  const auto main_controller = start_main_controller();
  std::this_thread::sleep_for(5s);
  for (int nap = 0; nap < 10; ++nap) {  // falls on another phase of the cycle each time
    message_controller->send(SIGSTOP);
    std::this_thread::sleep_for(30ms);
    message_controller->send(SIGCONT);
    std::this_thread::sleep_for(337ms);
  }
  EXPECT_EQ(main_controller->stop(), 0) << main_controller->output();
  EXPECT_EQ(message_controller->stop(), 0) << message_controller->output();
  EXPECT_EQ(robot->stop(), 0) << robot->output();
  ASSERT_TRUE(summary("robot.json").is_object()) << everything();
  EXPECT_FALSE(summary("robot.json")["fell"].get<bool>()) << everything();
  EXPECT_GE(summary("robot.json")["waits_for_the_message_controller"].get<int>(), 10) << everything();
  EXPECT_GE(summary("message.json")["missed_milliseconds"].get<int>(), 200) << everything();
}

TEST_F(RealTime, TheMessageControllerWaitsForARobotThatSleptForThirtyMilliseconds) {
  const auto robot = start_robot();
  const auto message_controller = start_message_controller("0.12,0,0");
  const auto main_controller = start_main_controller();
  std::this_thread::sleep_for(5s);
  for (int nap = 0; nap < 10; ++nap) {
    robot->send(SIGSTOP);
    std::this_thread::sleep_for(30ms);
    robot->send(SIGCONT);
    std::this_thread::sleep_for(337ms);
  }
  EXPECT_EQ(main_controller->stop(), 0) << main_controller->output();
  EXPECT_EQ(message_controller->stop(), 0) << message_controller->output();
  EXPECT_EQ(robot->stop(), 0) << robot->output();
  ASSERT_TRUE(summary("robot.json").is_object()) << everything();
  EXPECT_FALSE(summary("robot.json")["fell"].get<bool>()) << everything();
  EXPECT_GE(summary("robot.json")["overruns"].get<int>(), 200) << everything();
  EXPECT_EQ(summary("message.json")["resynchronised"].get<int>(), 0)
      << "every feedback was judged in its own time slot " << everything();
}

// The bus goes with its server. Who has a memory block keeps it.
TEST_F(RealTime, TheMessageControllerOutlastsItsBus) {
  auto robot = start_robot();
  const auto message_controller = start_message_controller("0,0,0");
  robot.reset();  // killed
  expect_told(*message_controller, "has gone: waiting for it");
  expect_back_after_one_outage(*message_controller);
  EXPECT_FALSE(summary("robot.json")["fell"].get<bool>()) << everything();
}

// Who stops a robot's process to look at it, and then ends it, is told of both.
TEST_F(RealTime, ABusThatStoodStillAndThenGoesIsToldToHaveGone) {
  auto robot = start_robot();
  const auto message_controller = start_message_controller("0,0,0");
  robot->send(SIGSTOP);
  expect_told(*message_controller, "stands still: waiting for it");
  robot.reset();  // killed
  expect_told(*message_controller, "has gone: waiting for it");
  expect_back_after_one_outage(*message_controller);
}

TEST_F(RealTime, ASecondCopyIsRefusedByName) {
  const auto robot = start_robot();
  const auto message_controller = start_message_controller("0,0,0");
  const std::vector<std::string> arguments{"--robot", kRobot, "--bus", path("bus"), "--memory"};
  for (const char* memory : {"memory", "another"}) {
    std::vector<std::string> second = arguments;
    second.push_back(path(memory));
    Process copy(GAITWAY_MESSAGE_CONTROLLER, folder / "copy.txt", second);
    EXPECT_EQ(copy.wait(), 1);
    EXPECT_THAT(copy.output(), HasSubstr("another message controller is on the bus " + path("bus")));
  }
  Process other(GAITWAY_VIRTUAL_ROBOT, folder / "copy.txt", {"--robot", kRobot, "--bus", path("bus")});
  EXPECT_EQ(other.wait(), 1);
  EXPECT_THAT(other.output(), HasSubstr("another bus serves it"));
}

TEST_F(RealTime, WhatCannotWorkIsSaidInOneLineAndNothingMoves) {
  Process no_bus(GAITWAY_MESSAGE_CONTROLLER, folder / "1.txt",
                 {"--robot", kRobot, "--bus", path("nobody"), "--memory", path("memory"), "--wait", "0.1"});
  EXPECT_EQ(no_bus.wait(), 1);
  EXPECT_THAT(no_bus.output(), HasSubstr(path("nobody")));
  EXPECT_THAT(no_bus.output(), HasSubstr("virtual_robot"));
  Process bad_walk(GAITWAY_MESSAGE_CONTROLLER, folder / "2.txt",
                   {"--robot", kRobot, "--bus", path("nobody"), "--memory", path("memory"), "--walk", "0.1"});
  EXPECT_EQ(bad_walk.wait(), 1);
  EXPECT_THAT(bad_walk.output(), HasSubstr("--walk"));
  Process no_robot(GAITWAY_VIRTUAL_ROBOT, folder / "3.txt", {"--robot", path("none"), "--bus", path("bus")});
  EXPECT_EQ(no_robot.wait(), 1);
  EXPECT_THAT(no_robot.output(), HasSubstr(path("none")));
  for (const char* program : {GAITWAY_MESSAGE_CONTROLLER, GAITWAY_VIRTUAL_ROBOT}) {
    const bool robot = program == std::string(GAITWAY_VIRTUAL_ROBOT);
    std::vector<std::string> arguments{"--robot", kRobot, "--can", "nobus7"};
    if (!robot) {
      arguments.insert(arguments.end(), {"--memory", path("memory"), "--wait", "0.1"});
    }
    Process no_interface(program, folder / "5.txt", arguments);
    EXPECT_EQ(no_interface.wait(), 1);
    EXPECT_THAT(no_interface.output(), HasSubstr("CAN interface 'nobus7'"));
    arguments.insert(arguments.end(), {"--bus", path("bus")});
    Process two_buses(program, folder / "6.txt", arguments);
    EXPECT_EQ(two_buses.wait(), 1);
    EXPECT_THAT(two_buses.output(), HasSubstr("--bus"));
  }
  Process waiting(GAITWAY_MESSAGE_CONTROLLER, folder / "4.txt",
                  {"--robot", kRobot, "--bus", path("nobody"), "--memory", path("memory"), "--wait", "60"});
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(waiting.stop(), 0) << waiting.output();
}

TEST_F(RealTime, HelpShowsExamples) {
  for (const char* program : {GAITWAY_MESSAGE_CONTROLLER, GAITWAY_VIRTUAL_ROBOT}) {
    Process help(program, folder / "help.txt", {"--help"});
    EXPECT_EQ(help.wait(), 0);
    EXPECT_THAT(help.output(), HasSubstr("Examples:"));
    EXPECT_THAT(help.output(), HasSubstr("urdf/humanoid22"));
  }
}

}  // namespace
}  // namespace gaitway::scenarios
