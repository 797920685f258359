// The process in real time: connects, hands over, ends as told or when the message controller goes.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <sstream>

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
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
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
  // Plays the message controller, once a millisecond, until `done` or for `at_most_s`. The exit code; -1:
  // still running.
  template <class Done>
  int serve(double at_most_s, const Done& done) {
    const std::int64_t end_ns = monotonic_ns() + static_cast<std::int64_t>(at_most_s * 1e9);
    while (monotonic_ns() < end_ns && !done()) {
      const std::int64_t now_ns = monotonic_ns();
      server.step(0);
      if (beating) {
        block.beat(now_ns);
      }
      states_writer.publish(states, now_ns);
      network_writer.publish(network, now_ns);
      if (emi.take_hand_over(*batch, now_ns) == msgclient::TakeStatus::mail) {
        ++batches;
        lead_ns = std::int64_t{batch->sequence} * facts::kCycle_ns - now_ns;
        EXPECT_TRUE(emi.answer({.sequence = batch->sequence}));
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
  msgclient::MemoryBlock block;
  msgclient::Client client = block.local_client("message_controller");
  msgclient::EmiMessage emi{client};
  msgclient::Writer<JointStates> states_writer = client.write<JointStates>("joint_states");
  msgclient::Writer<NetworkState> network_writer = client.write<NetworkState>("network_state");
  JointStates states{};
  NetworkState network{};
  std::unique_ptr<msgclient::HandOver> batch = std::make_unique<msgclient::HandOver>();
  msgclient::MemoryBlockServer server{block, in_new_folder(socket)};
  pid_t process = 0;
  int batches = 0;
  std::int64_t lead_ns = 0;
  bool beating = true;
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

// Whoever sends SIGKILL does so at any instant: that a plug-in is being stepped then is no fault of its.
TEST_F(MainControllerProcess, KilledFromOutsideItIsStartedAgainWithEveryPlugin) {
  configure("  - {name: stepped, library: crashes.so, parameters: {after_ticks: 20, signal: 9}}\n");
  launch_supervised();
  EXPECT_EQ(serve(30.0), 4) << output();
  EXPECT_THAT(output(), testing::HasSubstr("from outside, the process was ended by signal 9"));
  EXPECT_THAT(output(), testing::HasSubstr("started again\n"));
  EXPECT_THAT(output(), testing::Not(testing::HasSubstr("without 'stepped'")));
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
  msgclient::Client other = block.local_client("ctl");
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
