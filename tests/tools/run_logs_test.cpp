// `gaitway run` that is killed half-way, or whose disk is full: what it leaves behind can be read, says how
// far it went, and what is missing.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "command_run.hpp"
#include "gaitway/can/candump_log.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::tools {
namespace {

class RunLogsTest : public testing::Test {
 protected:
  // `gaitway run` with results in folder/<name>, and what it says in folder/<name>.txt.
  pid_t start(const std::string& name, const std::string& seconds) const {
    const std::string out = (folder.path() / name).string(), said = out + ".txt";
    const pid_t child = fork();
    if (child == 0) {
      const int file = open(said.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
      dup2(file, STDOUT_FILENO);
      dup2(file, STDERR_FILENO);
      execl(GAITWAY_COMMAND, GAITWAY_COMMAND, "run", "--quiet", "--no-pictures", "--seed", "3", "--seconds",
            seconds.c_str(), "--out", out.c_str(), nullptr);
      _exit(127);
    }
    return child;
  }
  static int end_of(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  [[nodiscard]] std::string text(const std::string& file) const {
    std::ifstream in(folder.path() / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  [[nodiscard]] nlohmann::json json(const std::string& file) const {
    return nlohmann::json::parse(text(file));
  }
  // Those with their end.
  [[nodiscard]] std::vector<std::string> whole_lines(const std::string& file) const {
    std::string all = text(file);
    all.resize(all.rfind('\n') + 1);
    std::istringstream in(all);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
  }
  void expect_whole_states(const std::string& file, std::size_t at_least) const {
    const std::vector<std::string> lines = whole_lines(file);
    ASSERT_GE(lines.size(), at_least);
    const auto columns = [](const std::string& line) { return std::ranges::count(line, ','); };
    for (std::size_t i = 1; i < lines.size(); ++i) {
      ASSERT_EQ(columns(lines[i]), columns(lines[0])) << file << ": line " << i + 1;
    }
  }

  process::PrivateFolder folder{"gaitway_run_logs"};
};

TEST_F(RunLogsTest, AKillLeavesWholeLinesAndASummaryThatSaysThatItIsNotTheLast) {
  std::filesystem::create_directories(folder.path() / "run");
  std::ofstream(folder.path() / "run/report.html") << "of a run before";
  const pid_t run = start("run", "3600");
  const std::int64_t until_ns = process::monotonic_ns() + 20'000'000'000;
  while (text("run/bus.log").size() < 200'000 && process::monotonic_ns() < until_ns) {
    process::wait_until(process::monotonic_ns() + 5'000'000, {});
  }
  kill(run, SIGKILL);
  ASSERT_EQ(end_of(run), 128 + SIGKILL) << text("run.txt");

  const nlohmann::json summary = json("run/summary.json");
  EXPECT_EQ(summary.at("ended"), false);
  EXPECT_EQ(summary.at("outcome"), "not ended");
  EXPECT_EQ(summary.at("logs").at("complete"), true);
  EXPECT_GT(summary.at("wall_seconds"), 0.0) << "it ran for so long until then";
  EXPECT_GT(summary.at("real_time_factor"), 0.0);
  EXPECT_GE(can::read_candump_log(folder.path() / "run/bus.log").size(), 2'000U);
  expect_whole_states("run/states.csv", 50);
  for (const std::string& line : whole_lines("run/events.jsonl")) {
    EXPECT_TRUE(nlohmann::json::parse(line).contains("text")) << line;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "run/report.html")) << "it is of another run";
}

TEST_F(RunLogsTest, AFullDiskCostsLinesAndNeverTheRun) {
  std::filesystem::create_directories(folder.path() / "full");
  for (const char* const log : {"full/bus.log", "full/states.csv"}) {
    std::filesystem::create_symlink("/dev/full", folder.path() / log);
  }
  const pid_t whole = start("whole", "2"), full = start("full", "2");
  ASSERT_EQ(end_of(whole), 0) << text("whole.txt");
  EXPECT_EQ(end_of(full), 4) << text("full.txt");

  const nlohmann::json expected = json("whole/summary.json"), summary = json("full/summary.json");
  EXPECT_EQ(expected.at("logs").at("complete"), true);
  EXPECT_EQ(summary.at("digest"), expected.at("digest")) << "the same run";
  EXPECT_EQ(summary.at("ended"), true);
  EXPECT_EQ(summary.at("outcome"), "done");
  EXPECT_EQ(summary.at("logs").at("complete"), false);
  for (const char* const log : {"bus.log", "states.csv"}) {
    const nlohmann::json& count = summary["logs"][log];
    EXPECT_EQ(count.at("lines"), 0) << log;
    EXPECT_EQ(count.at("lost"), expected["logs"][log]["lines"]) << log;
    EXPECT_GT(count["lost"].get<int>(), 0) << log;
    EXPECT_EQ(count["reason"], "No space left on device");
    const std::string said = text("full.txt"),
                      news = std::string(log) + ": lines are being lost: No space left on device";
    EXPECT_NE(said.find(news), std::string::npos) << said;
    EXPECT_EQ(said.find(news), said.rfind(news)) << "it is told once: " << said;
  }
  EXPECT_EQ(text("full/events.jsonl"), text("whole/events.jsonl"));
  expect_whole_states("whole/states.csv", 200);
}

// Also where its new process, and that of the main controller, begin logs of their own.
TEST_F(RunLogsTest, AMessageControllerThatIsAwayAndItsReturnAreEvents) {
  for (const char* const restarts : {"", ", restarts: true"}) {
    const std::string scenario = (folder.path() / "away.yaml").string(),
                      out = (folder.path() / "away").string();
    std::ofstream(scenario) << "seconds: 5\nevents:\n  - {at_s: 0.5, walk: [0.15, 0, 0]}\n"
                               "  - {at_s: 3.0, fault: {kind: message_controller_silent, duration_s: 0.5"
                            << restarts << "}}\n";
    const test::CommandRun run = test::run_command(
        GAITWAY_COMMAND " run --quiet --no-pictures --seed 3 --scenario " + scenario + " --out " + out);
    ASSERT_EQ(run.code, 0) << run.all();
    const std::string events = text("away/events.jsonl");
    const std::size_t silent = events.find("message controller silent for 54 ms: the joints ");
    const std::size_t back = events.find("message controller is back after 0.5");
    EXPECT_NE(silent, std::string::npos) << events;
    EXPECT_NE(back, std::string::npos) << events;
    EXPECT_LT(silent, back) << events;
    EXPECT_EQ(events.find("joint -1"), std::string::npos) << events;
  }
}

TEST_F(RunLogsTest, TwoRunsDoNotMixTheirLogs) {
  const pid_t first = start("run", "3600");
  const std::int64_t until_ns = process::monotonic_ns() + 20'000'000'000;
  while (text("run/states.csv").empty() && process::monotonic_ns() < until_ns) {
    process::wait_until(process::monotonic_ns() + 5'000'000, {});
  }
  EXPECT_EQ(end_of(start("run", "1")), 1);
  EXPECT_NE(text("run.txt").find("bus.log: is being written by another process"), std::string::npos)
      << text("run.txt");
  kill(first, SIGKILL);
  end_of(first);
}

}  // namespace
}  // namespace gaitway::tools
