// The process in real time: connects, hands over, ends as told or when the message controller goes.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/msgclient/memory_block_server.hpp"
#include "gaitway/plugin/cycle.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::core {
namespace {

std::int64_t monotonic_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

// A message controller's side of the memory block.
struct Served {
  explicit Served(const std::filesystem::path& socket) : server(block, socket) {}

  msgclient::MemoryBlock block;
  msgclient::Client client = block.local_client("message_controller");
  msgclient::EmiMessage emi{client};
  msgclient::Writer<JointStates> states_writer = client.write<JointStates>("joint_states");
  msgclient::Writer<NetworkState> network_writer = client.write<NetworkState>("network_state");
  msgclient::MemoryBlockServer server;
};

class MainControllerProcess : public testing::Test {
 protected:
  MainControllerProcess() {
    states.joint_count = static_cast<std::uint32_t>(robot.joints.size());
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      states.reference_position[joint] = robot.joints[joint].home_rad;
    }
    network.mode = network_state::mode::holding;
    configure("  - {name: planner, library: joint_planner.so}\n");
  }
  ~MainControllerProcess() override {
    if (process > 0) {
      kill(process, SIGKILL);
      waitpid(process, nullptr, 0);
    }
    std::filesystem::remove_all(folder);
  }
  static const std::filesystem::path& in_new_folder(const std::filesystem::path& file) {
    std::filesystem::create_directories(file.parent_path());
    return file;
  }
  void configure(const std::string& plugins) {
    std::ofstream(folder / "test.yaml") << "plugins:\n" << plugins;
  }

  void launch(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), GAITWAY_MAIN_CONTROLLER);
    std::vector<char*> argv;
    for (std::string& argument : arguments) {
      argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    const std::string output = (folder / "output.txt").string();
    posix_spawn_file_actions_addopen(&actions, 1, output.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
    posix_spawn_file_actions_adddup2(&actions, terminal >= 0 ? terminal : 1, 2);
    ASSERT_EQ(posix_spawn(&process, GAITWAY_MAIN_CONTROLLER, &actions, nullptr, argv.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
  }
  void launch_normally() { launch(normal_arguments()); }
  void launch_supervised() {
    std::vector<std::string> arguments = normal_arguments();
    arguments.emplace_back("--supervised");
    launch(std::move(arguments));
  }
  [[nodiscard]] std::vector<std::string> normal_arguments() const {
    return {"--socket",         socket.string(),     "--robot",
            GAITWAY_TEST_ROBOT, "--config",          (folder / "test.yaml").string(),
            "--plugin-path",    GAITWAY_TEST_PLUGINS};
  }
  void answer(std::int64_t now_ns) {
    served->server.step(0);
    if (beating) {
      served->block.beat(now_ns);
    }
    served->states_writer.publish(states, now_ns);
    served->network_writer.publish(network, now_ns);
    if (served->emi.take_hand_over(*batch, now_ns) == msgclient::TakeStatus::mail) {
      ++batches;
      lead_ns = std::int64_t{batch->sequence} * facts::kCycle_ns - now_ns;
      EXPECT_TRUE(served->emi.answer({.sequence = batch->sequence}));
    }
  }
  // Another message controller in the place of the one that went.
  void renew_block() {
    batches = 0;
    served.emplace(socket);
  }
  // The scheduling policy of the worker below the supervisor; -1: there is none.
  [[nodiscard]] int scheduling_of_worker() const {
    const std::string id = std::to_string(process);
    pid_t worker = 0;
    std::ifstream("/proc/" + id + "/task/" + id + "/children") >> worker;
    return worker == 0 ? -1 : sched_getscheduler(worker);
  }
  [[nodiscard]] int times_told(const std::string& text) const {
    int times = 0;
    const std::string told = output();
    for (std::size_t at = told.find(text); at != std::string::npos; at = told.find(text, at + 1)) {
      ++times;
    }
    return times;
  }
  // Plays the message controller, once a millisecond, until `done` or for `at_most_s`. The exit code; -1:
  // still running.
  template <class Done>
  int serve(double at_most_s, const Done& done) {
    const std::int64_t end_ns = monotonic_ns() + static_cast<std::int64_t>(at_most_s * 1e9);
    while (monotonic_ns() < end_ns && !done()) {
      const std::int64_t now_ns = monotonic_ns();
      if (served) {
        answer(now_ns);
      }
      int status = 0;
      if (waitpid(process, &status, WNOHANG) == process) {
        process = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
      }
      usleep(1000);
    }
    return -1;
  }
  int serve(double at_most_s) {
    return serve(at_most_s, [] { return false; });
  }
  std::string output() const {
    std::ostringstream text;
    text << std::ifstream(folder / "output.txt").rdbuf();
    return text.str();
  }

  std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("gaitway_main_controller_" + std::to_string(getpid()));
  std::filesystem::path socket = folder / "block.sock";
  urdf::RobotModel robot = urdf::load_robot(GAITWAY_TEST_ROBOT);
  JointStates states{};
  NetworkState network{};
  std::unique_ptr<msgclient::HandOver> batch = std::make_unique<msgclient::HandOver>();
  std::optional<Served> served{std::in_place, in_new_folder(socket)};
  pid_t process = 0;
  int batches = 0;
  std::int64_t lead_ns = 0;
  bool beating = true;
  int terminal = -1;  // what the process gets as stderr; negative: its output
};

TEST_F(MainControllerProcess, HandsOverInRealTimeAndStopsWhenTold) {
  launch_normally();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 5; }), -1) << output();
  ASSERT_GE(batches, 5) << output();
  EXPECT_LE(lead_ns, 16'000'000);
  kill(process, SIGTERM);
  EXPECT_EQ(serve(5.0), 0) << output();
  EXPECT_THAT(output(), testing::HasSubstr("batches"));
  EXPECT_THAT(output(), testing::HasSubstr("planner"));
}

TEST_F(MainControllerProcess, EndsWhenTheMessageControllerFallsSilent) {
  launch_normally();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  beating = false;
  EXPECT_EQ(serve(5.0), 3) << output();
  EXPECT_THAT(output(), testing::HasSubstr("no sign of life of the message controller"));
}

TEST_F(MainControllerProcess, ItsEventsSurviveItAndGoOn) {
  const std::string events = (folder / "events.jsonl").string();
  const auto lines_with = [&events](const std::string& text) {
    std::ifstream in(events);
    int lines = 0;
    for (std::string line; std::getline(in, line);) lines += line.find(text) != std::string::npos ? 1 : 0;
    return lines;
  };
  configure(
      "  - {name: planner, library: joint_planner.so}\n"
      "  - {name: teller, library: counter.so, parameters: {reports: true}}\n");
  std::vector<std::string> arguments = normal_arguments();
  arguments.insert(arguments.end(), {"--quiet", "--events", events});
  for (int life = 1; life <= 2; ++life) {
    launch(arguments);
    ASSERT_EQ(
        serve(20.0, [&] { return lines_with("begins as process") == life && lines_with("teller") >= life; }),
        -1)
        << output();
    kill(process, SIGKILL);
    EXPECT_EQ(serve(5.0), 1000 + SIGKILL);
    renew_block();
  }
  EXPECT_EQ(lines_with("begins as process"), 2);
}

// A terminal that was halted, or whose reader hangs, is no reason to lose a batch.
TEST_F(MainControllerProcess, ATerminalThatTakesNothingHoldsNoTick) {
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  const std::string of_the_pipe = "/proc/self/fd/" + std::to_string(ends[1]);
  const int filler = open(of_the_pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(filler, 0);
  configure(
      "  - {name: planner, library: joint_planner.so}\n"
      "  - {name: teller, library: counter.so, parameters: {reports: true}}\n");
  terminal = ends[1];
  launch_normally();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  const std::string line(64, 'x');
  while (write(filler, line.data(), line.size()) > 0) {
  }
  EXPECT_EQ(serve(20.0, [this] { return batches >= 21; }), -1);
  EXPECT_GE(batches, 21) << "1.6 s and 160 events later";
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0);
  for (const int end : {ends[0], ends[1], filler}) close(end);
}

// Whoever sends SIGKILL does so at any instant: that a plug-in is being stepped then is no fault of its, and
// no reason to give up. A second apart, so that it does not take the computer.
TEST_F(MainControllerProcess, KilledFromOutsideItIsStartedAgainWithEveryPluginHoweverOften) {
  configure("  - {name: stepped, library: crashes.so, parameters: {after_ticks: 20, signal: 9}}\n");
  launch_supervised();
  const std::int64_t begin_ns = monotonic_ns();
  ASSERT_EQ(serve(60.0, [this] { return times_told("started again\n") >= 5; }), -1) << output();
  EXPECT_GE(monotonic_ns() - begin_ns, 4'000'000'000);
  EXPECT_THAT(output(), testing::HasSubstr("from outside, the process was ended by signal 9"));
  EXPECT_THAT(output(), testing::Not(testing::HasSubstr("without 'stepped'")));
  kill(process, SIGTERM);
  EXPECT_NE(serve(10.0), -1) << output();
}

// As by a person with a debugger: the robot is on its safe tail and needs another one, and no plug-in did it.
TEST_F(MainControllerProcess, StoppedFromOutsideItIsReplacedWithEveryPlugin) {
  configure("  - {name: stepped, library: crashes.so, parameters: {after_ticks: 20, signal: 19}}\n");
  launch_supervised();
  ASSERT_EQ(serve(20.0, [this] { return times_told("started again\n") >= 1; }), -1) << output();
  EXPECT_THAT(output(),
              testing::HasSubstr("from outside, the process was stopped for 1000 ms and was ended"));
  EXPECT_THAT(output(), testing::Not(testing::HasSubstr("without 'stepped'")));
  kill(process, SIGTERM);
  EXPECT_NE(serve(10.0), -1) << output();
}

// However often it goes: that is nobody's fault in here.
TEST_F(MainControllerProcess, AMessageControllerThatComesBackFindsAnotherMainController) {
  launch_supervised();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  const int scheduling = scheduling_of_worker();
  for (int time = 1; time <= 5; ++time) {
    served.reset();  // every connection is hung up, as when the process has been killed
    ASSERT_EQ(serve(5.0, [&] { return times_told("waiting for the message controller") == time; }), -1)
        << output();
    EXPECT_EQ(times_told("the message controller on " + socket.string() + " has ended"), time) << output();
    renew_block();
    const std::int64_t back_ns = monotonic_ns();
    ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
    EXPECT_LT(monotonic_ns() - back_ns, 800'000'000);
    EXPECT_EQ(scheduling_of_worker(), scheduling) << "what is allowed once is allowed again";
  }
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << output();
}

TEST_F(MainControllerProcess, SupervisedItWaitsForAMessageControllerThatIsNotThereYet) {
  served.reset();
  launch_supervised();
  ASSERT_EQ(serve(20.0, [this] { return times_told("waiting for the message controller") == 1; }), -1)
      << output();
  serve(0.3);
  EXPECT_EQ(times_told("cannot connect to"), 1) << "said once " << output();
  renew_block();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  served.reset();
  ASSERT_EQ(serve(5.0, [this] { return times_told("waiting for the message") == 2; }), -1);
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << "also while it waits " << output();
}

TEST_F(MainControllerProcess, AMessageControllerThatEndsIsMissedAtOnce) {
  launch_normally();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  served.reset();
  const std::int64_t gone_ns = monotonic_ns();
  EXPECT_EQ(serve(5.0), 3) << output();
  EXPECT_LT(monotonic_ns() - gone_ns, 800'000'000) << "not by its silence";
  EXPECT_THAT(output(), testing::HasSubstr("has ended"));
}

TEST_F(MainControllerProcess, ASecondOneIsRefusedByName) {
  launch_normally();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  const pid_t first = std::exchange(process, 0);
  launch_supervised();
  EXPECT_EQ(serve(20.0), 1) << output();
  EXPECT_THAT(output(), testing::HasSubstr("another main controller"));
  process = first;
}

// By SIGABRT: a sanitizer would make an exit of its own of a SIGSEGV.
TEST_F(MainControllerProcess, AfterACrashItIsStartedAgainWithoutThePluginThatWasBeingStepped) {
  configure("  - {name: stepped, library: crashes.so, parameters: {after_ticks: 20, signal: 6}}\n");
  launch_supervised();
  const auto is_back = [this] { return output().find("back after") != std::string::npos; };
  ASSERT_EQ(serve(20.0, is_back), -1) << output();
  EXPECT_THAT(output(), testing::HasSubstr("in plug-in 'stepped', the process was ended by signal 6"));
  EXPECT_THAT(output(), testing::HasSubstr("started again, without 'stepped'"));
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << output();
}

// A plug-in that is being changed beside the ticks may take the process down, too: whoever is being stepped
// at that moment has no part in it.
TEST_F(MainControllerProcess, AfterACrashInAChangeItIsStartedAgainWithEveryPlugin) {
  const std::string meeting = "library: crashes_when_it_leaves.so, parameters: {meeting: " + folder.string();
  configure("  - {name: stepped, " + meeting + "}}\n  - {name: leaver, " + meeting + ", leaves: true}}\n");
  launch_supervised();
  msgclient::Client other = served->block.local_client("ctl");
  msgclient::Reader<PluginStatistics> statistics = other.read<PluginStatistics>("plugin_statistics");
  PluginStatistics seen{};
  ASSERT_EQ(serve(20.0, [&] { return statistics.read(seen) && seen.steps[1] > 0; }), -1) << output();
  PluginRequest unload{};
  unload.number = 1;
  unload.verb = 2;
  std::strcpy(reinterpret_cast<char*>(unload.plugin), "leaver");
  ASSERT_TRUE(other.write_queue<PluginRequest>("plugin_request").push(unload, 0));
  const auto is_back = [this] { return output().find("back after") != std::string::npos; };
  ASSERT_EQ(serve(20.0, is_back), -1) << output();
  EXPECT_THAT(output(), testing::HasSubstr("while plug-in 'leaver' was changed, the process was ended by "
                                           "signal 6"));
  EXPECT_THAT(output(), testing::HasSubstr("started again\n"));
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << output();
}

// Before the first tick, too, a plug-in that takes the process down is stopped at the next start.
TEST_F(MainControllerProcess, AfterACrashInActivateItIsStartedAgainWithoutThatPlugin) {
  configure("  - {name: active, library: crashes.so, parameters: {in_activate: true, signal: 6}}\n");
  launch_supervised();
  const auto is_back = [this] { return output().find("back after") != std::string::npos; };
  ASSERT_EQ(serve(60.0, is_back), -1) << output();
  EXPECT_THAT(output(), testing::HasSubstr("in plug-in 'active', the process was ended by signal 6"));
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << output();
}

TEST_F(MainControllerProcess, AfterAHangInActivateItIsStartedAgainWithoutThatPlugin) {
  configure("  - {name: active, library: crashes.so, parameters: {in_activate: true, hangs: true}}\n");
  launch_supervised();
  const auto is_back = [this] { return output().find("back after") != std::string::npos; };
  ASSERT_EQ(serve(60.0, is_back), -1) << output();
  EXPECT_THAT(output(), testing::HasSubstr("in plug-in 'active', the process made no tick for 5000 ms"));
  EXPECT_THAT(output(), testing::HasSubstr("started again, without 'active'"));
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << output();
}

TEST_F(MainControllerProcess, BadConfigurationIsNamedAndNothingMoves) {
  configure("  - {name: planner, library: nowhere.so}\n");
  launch_normally();
  EXPECT_EQ(serve(20.0), 1);
  EXPECT_THAT(output(), testing::HasSubstr("test.yaml:2): no library 'nowhere.so'"));
  EXPECT_EQ(batches, 0);
}

// A message controller that has hardware on its bus, or does not say, has a robot of metal.
TEST_F(MainControllerProcess, APluginInPythonIsForSimulatedRobotsAlone) {
  configure("  - {name: sway, library: ./nowhere.py}\n");
  launch_normally();
  EXPECT_EQ(serve(20.0), 1);
  EXPECT_THAT(output(), testing::HasSubstr("test.yaml:2: plug-in 'sway' is written in Python (./nowhere.py), "
                                           "which is for simulated robots alone"));
  {
    const msgclient::TopicGrant mark = msgclient::mark_simulated(served->client);
    launch_normally();
    EXPECT_EQ(serve(20.0), 1);
    EXPECT_THAT(output(), testing::Not(testing::HasSubstr("for simulated robots alone")));
    EXPECT_THAT(output(), testing::HasSubstr("plug-in 'sway'"));  // where it runs at all, its file is missing
  }
  launch_normally();
  EXPECT_EQ(serve(20.0), 1);
  EXPECT_THAT(output(), testing::HasSubstr("for simulated robots alone"));
  EXPECT_EQ(batches, 0);
}

TEST_F(MainControllerProcess, MissingSocketIsNamed) {
  launch({"--socket", "/nowhere/s.sock", "--robot", GAITWAY_TEST_ROBOT, "--config",
          (folder / "test.yaml").string()});
  EXPECT_EQ(serve(20.0), 1);
  EXPECT_THAT(output(), testing::HasSubstr("cannot connect to '/nowhere/s.sock'"));
}

TEST_F(MainControllerProcess, HelpShowsExamples) {
  launch({"--help"});
  EXPECT_EQ(serve(20.0), 0);
  EXPECT_THAT(output(), testing::HasSubstr("Examples:"));
}

}  // namespace
}  // namespace gaitway::core
