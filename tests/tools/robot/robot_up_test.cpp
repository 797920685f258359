// A whole simulated robot under its supervisor, in real time: it comes up, is back after a death by itself,
// and is taken down.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <sys/socket.h>

#include <fstream>
#include <string>
#include <string_view>

#include "gaitway/process/file_descriptor.hpp"
#include "running_robot.hpp"

namespace gaitway::tools {
namespace {

using testing::HasSubstr;

TEST(RobotUp, IsBackByItselfAfterTheMessageControllerIsKilledAndIsTakenDownInOrder) {
  RunningRobot robot("--no-interface");
  ASSERT_EQ(robot.started.code, 0) << robot.started.all() << robot.everything();
  const test::CommandRun first = robot.run("status");
  EXPECT_EQ(first.code, 0) << first.all();
  EXPECT_THAT(first.said, HasSubstr("robot              may be commanded"));
  // The death of either controller, each by its own process.
  for (const char* const name : {"message_controller", "main_controller"}) {
    const PartStatus before = robot.status(name);
    ASSERT_GT(before.worker, 0) << robot.everything();
    const auto back_s = robot.seconds_to_command(before.worker);
    ASSERT_TRUE(back_s) << name << robot.everything();
    RecordProperty(name, std::to_string(*back_s));
    // The target is 1.0 and 0.5 s; what else this computer does must not decide here.
    EXPECT_LT(*back_s, 3.0) << name << robot.everything();
  }
  EXPECT_THAT(robot.log("events"),
              HasSubstr("message_controller: was ended by signal 9 (Killed). It is started again at once"));
  const test::CommandRun again = robot.run("up --simulate --no-interface");
  EXPECT_EQ(again.code, 1);
  EXPECT_THAT(again.complaint, HasSubstr("a robot is up in " + robot.folder.path().string() + " already"));
  const test::CommandRun down = robot.run("down");
  EXPECT_EQ(down.code, 0) << down.all();
  EXPECT_THAT(down.said,
              testing::ContainsRegex("main_controller: ended\nthe robot stands\nmessage_controller: "
                                     "ended\nvirtual_robot: ended\n"));
  EXPECT_EQ(robot.run("status").code, 3);
  EXPECT_THAT(robot.log("virtual_robot"), HasSubstr("\"fell\": false")) << robot.everything();
}

// The supervisor is nobody's life line: the robot walks on without it, and the next one finds its parts.
TEST(RobotUp, WalksOnWithoutItsSupervisorAndIsTakenOver) {
  const std::string options = "--no-interface --walk 0.12,0,0 --walk-after 0.5";
  RunningRobot robot(options);
  ASSERT_EQ(robot.started.code, 0) << robot.started.all() << robot.everything();
  const pid_t message_controller = robot.status("message_controller").process;
  const auto status = read_status(robot.folder.path() / "status.json");
  ASSERT_TRUE(status);
  usleep(1'500'000);  // it walks
  kill(status->supervisor, SIGKILL);
  const test::CommandRun orphaned = robot.run("status");
  EXPECT_EQ(orphaned.code, 2) << orphaned.all();
  EXPECT_THAT(orphaned.said, HasSubstr("GONE"));
  usleep(1'000'000);
  const test::CommandRun other = robot.run("up --simulate --no-interface --profile paper");
  EXPECT_EQ(other.code, 1) << "it is on another bus";
  EXPECT_THAT(other.complaint, HasSubstr("runs in this folder with another --profile"));
  const test::CommandRun next = robot.run("up --simulate --detach " + options);
  EXPECT_EQ(next.code, 0) << next.all() << robot.everything();
  EXPECT_EQ(robot.status("message_controller").process, message_controller);
  EXPECT_EQ(robot.run("down").code, 0);
  EXPECT_THAT(robot.log("virtual_robot"), HasSubstr("\"fell\": false")) << robot.everything();
}

// Also without a supervisor it is taken down in order.
TEST(RobotUp, IsTakenDownWithoutItsSupervisor) {
  RunningRobot robot("--no-interface");
  ASSERT_EQ(robot.started.code, 0) << robot.started.all() << robot.everything();
  const auto status = read_status(robot.folder.path() / "status.json");
  ASSERT_TRUE(status);
  kill(status->supervisor, SIGKILL);
  const test::CommandRun down = robot.run("down");
  EXPECT_EQ(down.code, 0) << down.all();
  EXPECT_THAT(down.said, testing::AllOf(HasSubstr("the supervisor is gone"), HasSubstr("the robot stands")));
  EXPECT_EQ(robot.run("down").code, 3);
}

TEST(RobotUp, RefusesWhatCannotBeBeforeAnythingMoves) {
  const process::PrivateFolder folder("gaitway_robot");
  const auto complaint_of = [&folder](const std::string& options) {
    const test::CommandRun run = test::run_command(GAITWAY_ROBOT_COMMAND " robot up --folder " +
                                                   folder.path().string() + " " + options);
    EXPECT_EQ(run.code, 1) << options << run.all();
    return run.complaint;
  };
  EXPECT_THAT(complaint_of("--can nowhere0"),
              HasSubstr("--can nowhere0: there is no such network interface"));
  EXPECT_THAT(complaint_of("--simulate --robot /nowhere"), HasSubstr("/nowhere"));
  EXPECT_THAT(complaint_of("--simulate --walk 3,0,0"), HasSubstr("--walk: at most 1 m/s"));
  EXPECT_THAT(complaint_of("--simulate --config " GAITWAY_SOURCE_DIR "/core/config/walk.yaml"),
              HasSubstr("has no plug-in 'api'"));
  EXPECT_THAT(complaint_of(""), HasSubstr("--can"));
  const process::FileDescriptor other(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof place;
  ASSERT_EQ(bind(other.get(), reinterpret_cast<const sockaddr*>(&place), size), 0);
  ASSERT_EQ(listen(other.get(), 1), 0);
  ASSERT_EQ(getsockname(other.get(), reinterpret_cast<sockaddr*>(&place), &size), 0);
  const std::string port = std::to_string(ntohs(place.sin_port));
  EXPECT_THAT(complaint_of("--simulate --port " + port),
              HasSubstr("--port " + port + ": another program listens there on 127.0.0.1: process " +
                        std::to_string(getpid()) + " (robot_up_tests)"));
  std::filesystem::permissions(folder.path(), std::filesystem::perms::all);
  EXPECT_THAT(complaint_of("--simulate"), HasSubstr("to which nobody else may write"));
}

// The unit of the package, with this build's program in the place of the installed one.
TEST(RobotService, ItsUnitIsWhatSystemdUnderstands) {
  if (test::run_command("systemd-analyze --version").code != 0) GTEST_SKIP() << "no systemd-analyze here";
  const process::PrivateFolder folder("gaitway_unit");
  std::string unit = test::text_of(GAITWAY_SOURCE_DIR "/tools/robot/systemd/gaitway-robot.service");
  constexpr std::string_view kInstalled = "ExecStart=/usr/bin/gaitway ";
  const std::size_t at = unit.find(kInstalled);
  ASSERT_NE(at, std::string::npos);
  unit.replace(at, kInstalled.size(), "ExecStart=" GAITWAY_ROBOT_COMMAND " ");
  const std::string file = (folder.path() / "gaitway-robot.service").string();
  std::ofstream(file) << unit;
  const test::CommandRun verified = test::run_command("systemd-analyze verify --man=no " + file);
  EXPECT_EQ(verified.code, 0) << verified.all();
  EXPECT_EQ(verified.all(), "") << "each line is something that systemd does not understand, and passes over";
}

}  // namespace
}  // namespace gaitway::tools
