// The process of a main controller, and a message controller that is played by the test.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
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

inline std::int64_t monotonic_ns() {
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

}  // namespace gaitway::core
