// What the processes of a robot leave behind when they are killed, and what becomes of them while their disk
// is full: they go on, and say so.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "running_process.hpp"

namespace gaitway::scenarios {
namespace {

using testing::HasSubstr;

class ProcessLogs : public testing::Test {
 protected:
  ProcessLogs() {
    std::string name = (std::filesystem::temp_directory_path() / "gaitway_logs_XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~ProcessLogs() override { std::filesystem::remove_all(folder); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder / name).string(); }
  [[nodiscard]] nlohmann::json json(const std::string& name) const {
    return nlohmann::json::parse(text_of(folder / name), nullptr, false);
  }
  [[nodiscard]] auto start_robot(const std::string& walk_log) const {
    auto process = std::make_unique<Process>(
        GAITWAY_VIRTUAL_ROBOT, folder / "robot.txt",
        std::vector<std::string>{"--robot", kRobot, "--bus", path("bus"), "--summary", path("robot.json"),
                                 "--walk-log", walk_log});
    EXPECT_TRUE(until(20s, [&] { return std::filesystem::exists(folder / "bus"); })) << process->output();
    return process;
  }
  [[nodiscard]] auto start_message_controller() const {
    return std::make_unique<Process>(
        GAITWAY_MESSAGE_CONTROLLER, folder / "message.txt",
        std::vector<std::string>{"--robot", kRobot, "--bus", path("bus"), "--memory", path("memory"),
                                 "--summary", path("message.json")});
  }

  const std::string kRobot = std::string(GAITWAY_SOURCE_DIR) + "/urdf/humanoid22";
  std::filesystem::path folder;
};

TEST_F(ProcessLogs, SurviveAKill) {
  const auto robot = start_robot(path("walk.csv"));
  const auto message_controller = start_message_controller();
  ASSERT_TRUE(until(20s,
                    [this] {
                      return json("robot.json").is_object() && json("message.json").is_object() &&
                             text_of(folder / "walk.csv").size() > 2'000;
                    }))
      << robot->output() << message_controller->output();
  message_controller->send(SIGKILL);
  robot->send(SIGKILL);
  EXPECT_EQ(message_controller->wait(), 1000 + SIGKILL);
  EXPECT_EQ(robot->wait(), 1000 + SIGKILL);
  EXPECT_EQ(json("message.json").at("ended"), false);
  EXPECT_EQ(json("robot.json").at("ended"), false);
  EXPECT_EQ(json("robot.json").at("fell"), false);
  std::istringstream rows(text_of(folder / "walk.csv"));
  int number = 0;
  for (std::string row; std::getline(rows, row) && !rows.eof(); ++number) {
    ASSERT_EQ(std::ranges::count(row, ','), 4) << row;
    if (number > 0) {
      ASSERT_NEAR(std::stod(row), 0.01 * number, 1e-9) << "none is missing";
    }
  }
  EXPECT_GT(number, 40);
}

TEST_F(ProcessLogs, AFullDiskEndsNoProcessAndIsTold) {
  const auto robot = start_robot("/dev/full");
  const auto message_controller = start_message_controller();
  ASSERT_TRUE(until(20s, [&] {
    return json("message.json").is_object() &&
           robot->output().find("lines are being lost") != std::string::npos;
  })) << robot->output();
  EXPECT_EQ(message_controller->stop(), 0) << message_controller->output();
  EXPECT_EQ(robot->stop(), 0) << robot->output();
  EXPECT_THAT(robot->output(), HasSubstr("/dev/full: lines are being lost: No space left on device"));
  const nlohmann::json summary = json("robot.json");
  EXPECT_EQ(summary.at("ended"), true);
  EXPECT_EQ(summary.at("walk_log").at("lines"), 0);
  EXPECT_GT(summary.at("walk_log").at("lost").get<int>(), 10);
  EXPECT_EQ(json("message.json").at("ended"), true);
}

}  // namespace
}  // namespace gaitway::scenarios
