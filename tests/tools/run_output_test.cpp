// `gaitway run` as a user meets it: exit codes, and every file that it promises with what it promises in it.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "gaitway/can/candump_log.hpp"

namespace gaitway::tools {
namespace {

class RunOutput : public ::testing::Test {
 protected:
  RunOutput()
      : folder_(std::filesystem::temp_directory_path() / ("gaitway_run_output_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~RunOutput() override { std::filesystem::remove_all(folder_); }

  // Runs the command with results in folder_/<name>; returns its exit code.
  int run(const std::string& arguments, const std::string& name = "out") const {
    const std::string line = std::string(GAITWAY_COMMAND) + " run --quiet --out '" +
                             (folder_ / name).string() + "' " + arguments + " >/dev/null 2>&1";
    return WEXITSTATUS(std::system(line.c_str()));
  }
  [[nodiscard]] std::string text(const std::string& file, const std::string& name = "out") const {
    std::ifstream in(folder_ / name / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  [[nodiscard]] nlohmann::json summary(const std::string& name = "out") const {
    return nlohmann::json::parse(text("summary.json", name));
  }

  std::filesystem::path folder_;
};

// Up, but not where it should be: the plug-in that plans the steps fails from the start.
TEST_F(RunOutput, StayingUpIsNotEnough) {
  std::ofstream(folder_ / "fails.yaml")
      << "seconds: 8\nevents:\n  - {at_s: 0.9, fault: {kind: plugin_fails, plugin: "
         "trajectory, how: throws, duration_s: 20}}\n"
         "  - {at_s: 1.0, walk: [0.15, 0, 0]}\n";
  EXPECT_EQ(run("--no-pictures --scenario '" + (folder_ / "fails.yaml").string() + "'"), 3)
      << text("summary.json");
  EXPECT_EQ(summary().at("outcome"), "not done");
  EXPECT_NE(text("report.html").find("DID NOT DO WHAT WAS ASKED"), std::string::npos);
}

// What is told again and again has one line, so that the end of it is seen, too.
TEST_F(RunOutput, TheTableFoldsWhatIsToldAgainAndAgain) {
  std::ofstream(folder_ / "fails.yaml")
      << "seconds: 3\nevents:\n  - {at_s: 0.9, fault: {kind: plugin_fails, plugin: "
         "trajectory, how: throws, duration_s: 20}}\n";
  const std::string line = std::string(GAITWAY_COMMAND) + " run --no-pictures --out '" +
                           (folder_ / "out").string() + "' --scenario '" + (folder_ / "fails.yaml").string() +
                           "' > '" + (folder_ / "table.txt").string() + "'";
  ASSERT_EQ(WEXITSTATUS(std::system(line.c_str())), 0);
  const std::string table = text("table.txt", ".");
  EXPECT_NE(table.find("step() threw (8 times, last at 1.504 s)"), std::string::npos) << table;
  EXPECT_NE(table.find("out of service after 8 faults"), std::string::npos) << table;
  std::size_t told = 0;
  for (std::size_t at = table.find("trajectory fault:"); at != std::string::npos;
       at = table.find("trajectory fault:", at + 1))
    ++told;
  EXPECT_EQ(told, 1) << table;
}

TEST_F(RunOutput, EyesLeaveEachPairOfPictures) {
  ASSERT_EQ(
      run("--seconds 1 --walk 0 --world course --no-pictures --eyes '" + (folder_ / "eyes").string() + "'"),
      0);
  int pairs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "eyes")) {
    pairs += entry.path().extension() == ".png" && entry.file_size() > 10'000 ? 1 : 0;
  }
  EXPECT_GE(pairs, 10) << "12 or 13 in a second, of which one may be lost";
  EXPECT_LE(pairs, 13);
}

TEST_F(RunOutput, TheSummaryHasEveryFigure) {
  ASSERT_EQ(run("--seconds 4 --seed 11 --no-pictures"), 0);
  const nlohmann::json figures = summary();
  for (const char* const pointer : {"/robot",
                                    "/profile",
                                    "/seed",
                                    "/virtual_seconds",
                                    "/wall_seconds",
                                    "/real_time_factor",
                                    "/physics_only_real_time_factor",
                                    "/fell",
                                    "/distance_m",
                                    "/mean_speed_m_s",
                                    "/lateral_drift_m",
                                    "/heading_drift_rad",
                                    "/batches/handed_over",
                                    "/batches/late",
                                    "/batches/refused",
                                    "/batches/tail_played",
                                    "/batches/compute_us/p50",
                                    "/batches/compute_us/p99",
                                    "/batches/compute_us/max",
                                    "/bus/frames",
                                    "/bus/load",
                                    "/bus/frame_us/min",
                                    "/bus/frame_us/mean",
                                    "/bus/frame_us/max",
                                    "/joints/tracking_rms_rad",
                                    "/joints/refused_points",
                                    "/joints/resynchronised",
                                    "/zmp/reference_error_rms_m",
                                    "/zmp/estimate_error_rms_m",
                                    "/zmp/margin_min_m",
                                    "/digest"}) {
    EXPECT_TRUE(figures.contains(nlohmann::json::json_pointer(pointer))) << pointer;
  }
  EXPECT_EQ(figures["robot"], "humanoid22");
  EXPECT_EQ(figures["seed"], 11);
  EXPECT_EQ(figures["virtual_seconds"], 4.0);
  EXPECT_EQ(figures["fell"], false);
  EXPECT_EQ(figures["batches"]["handed_over"], 50);
  EXPECT_GE(figures["bus"]["frame_us"]["min"], 111.0);
  EXPECT_LE(figures["bus"]["frame_us"]["max"], 135.0);
}

TEST_F(RunOutput, TheLogsHoldTheWholeRun) {
  ASSERT_EQ(run("--seconds 3 --no-pictures"), 0);
  const auto frames = can::read_candump_log(folder_ / "out" / "bus.log");
  EXPECT_EQ(frames.size(), summary()["bus"]["frames"].get<std::size_t>());
  const std::string states = text("states.csv");
  EXPECT_EQ(std::count(states.begin(), states.end(), '\n'), 1 + 300);
  const auto columns = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  const std::size_t end_of_header = states.find('\n');
  const std::string first_row =
      states.substr(end_of_header + 1, states.find('\n', end_of_header + 1) - end_of_header);
  EXPECT_EQ(columns(states.substr(0, end_of_header)), columns(first_row));
}

TEST_F(RunOutput, TheReportCarriesEverythingInItself) {
  ASSERT_EQ(run("--seconds 3"), 0);
  const std::string page = text("report.html");
  for (const char* const part : {"The walk from above", "Joint tracking", "One 80 ms cycle of the bus",
                                 "Compute times", "data:image/png;base64,", "kinematics"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / "walk.png"));
}

TEST_F(RunOutput, OneSeedGivesOneDigest) {
  ASSERT_EQ(run("--seconds 3 --seed 4 --no-pictures", "a"), 0);
  ASSERT_EQ(run("--seconds 3 --seed 4 --no-pictures", "b"), 0);
  ASSERT_EQ(run("--seconds 3 --seed 5 --no-pictures", "c"), 0);
  EXPECT_EQ(summary("a")["digest"], summary("b")["digest"]);
  EXPECT_NE(summary("a")["digest"], summary("c")["digest"]);
}

TEST_F(RunOutput, AFallIsToldByTheExitCodeAndTheSummary) {
  const std::filesystem::path scenario = folder_ / "let_go.yaml";
  std::ofstream(scenario) << "seconds: 10\nevents:\n  - {at_s: 1.0, emergency_stop: soft}\n";
  EXPECT_EQ(run("--no-pictures --scenario '" + scenario.string() + "'"), 2);
  EXPECT_EQ(summary()["fell"], true);
  EXPECT_GT(summary()["fell_at_s"], 1.0);
}

TEST_F(RunOutput, EndsASecondAfterAFallUnlessAMotionIsToLiftTheRobot) {
  const std::filesystem::path scenario = folder_ / "fall.yaml";
  const std::string fall =
      "seconds: 5\nevents:\n"
      "  - {at_s: 0.5, push: {body: trunk, direction: [1, 0, 0], impulse_Ns: 8.0, duration_s: 0.1}}\n";
  std::ofstream(scenario) << fall;
  EXPECT_EQ(run("--no-pictures --scenario '" + scenario.string() + "'"), 2);
  EXPECT_LT(summary()["virtual_seconds"], 3.0);
  std::ofstream(scenario) << fall << "  - {at_s: 3.0, motion: get_up_front}\n";
  EXPECT_EQ(run("--no-pictures --scenario '" + scenario.string() + "'"), 2);
  EXPECT_EQ(summary()["virtual_seconds"], 5.0);
}

}  // namespace
}  // namespace gaitway::tools
