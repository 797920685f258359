// The walk with revisions of each batch: none is late or lost on a sound bus, on a troubled one the joints
// are put right, and the same seed gives the same run.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/run/run_recorder.hpp"

namespace gaitway::scenarios {
namespace {

// The shipped robot with `revision_slot: 4` in its network file.
class RevisedRobot {
 public:
  RevisedRobot() {
    const std::filesystem::path shipped = std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22";
    std::filesystem::create_directories(folder_);
    std::filesystem::copy_file(shipped / "robot.urdf", folder_ / "robot.urdf",
                               std::filesystem::copy_options::overwrite_existing);
    std::ostringstream text;
    text << std::ifstream(shipped / "robot.yaml").rdbuf();
    std::string yaml = text.str();
    const std::string profile = "{profile: full}";
    yaml.replace(yaml.find(profile), profile.size(), "{profile: full, revision_slot: 4}");
    std::ofstream(folder_ / "robot.yaml") << yaml;
    model = urdf::load_robot(folder_);
  }
  RevisedRobot(const RevisedRobot&) = delete;
  RevisedRobot& operator=(const RevisedRobot&) = delete;
  ~RevisedRobot() { std::filesystem::remove_all(folder_); }

  urdf::RobotModel model;

 private:
  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("revised_robot_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

class Revisions : public testing::Test {
 protected:
  struct Run {
    Run(const urdf::RobotModel& robot, std::uint64_t seed)
        : cosimulation(robot, options(seed)), recorder(cosimulation, {}, false) {
      cosimulation.observe(&recorder);
      cosimulation.apply({1.0, simulator::WalkEvent{.velocity_m_per_s = {0.2, 0.0}}});
    }
    void play_until(double time_s) {
      while (static_cast<double>(cosimulation.now_ns()) * 1e-9 < time_s && !recorder.metrics().fell) {
        cosimulation.advance_millisecond();
      }
    }
    static simulator::CosimulationOptions options(std::uint64_t seed) {
      simulator::CosimulationOptions result;
      result.plant.seed = seed;
      result.main_controller.configuration =
          std::filesystem::path(GAITWAY_SOURCE_DIR) / "core/config/walk.yaml";
      result.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
      return result;
    }
    simulator::Cosimulation cosimulation;
    tools::RunRecorder recorder;
  };
  RevisedRobot robot_;
};

TEST_F(Revisions, EveryBatchOfAWalkIsRevisedInTime) {
  Run run(robot_.model, 3);
  run.play_until(8.0);
  EXPECT_FALSE(run.recorder.metrics().fell);
  const core::MainControllerStatistics statistics = run.cosimulation.main_controller().statistics();
  EXPECT_GE(statistics.revisions + 2, statistics.handed_over) << statistics.last_refusal;
  const NetworkState& state = run.cosimulation.message_controller().state();
  EXPECT_EQ(state.late, 0U);
  EXPECT_EQ(state.refused, 0U) << statistics.last_refusal;
  EXPECT_EQ(state.resynchronised, 0U);
  EXPECT_EQ(state.tail_played, 0U);
  EXPECT_EQ(run.cosimulation.message_controller().health().counts_differed, 0U);
}

TEST_F(Revisions, TheRobotWalksOnOverABusThatLosesFrames) {
  Run run(robot_.model, 4);
  run.play_until(3.0);
  run.cosimulation.apply({3.0, simulator::LoseFramesFault{.probability = 0.01, .duration_s = 5.0}});
  run.play_until(8.0);
  EXPECT_GT(run.cosimulation.message_controller().state().repaired, 0U);
  run.play_until(10.0);
  EXPECT_FALSE(run.recorder.metrics().fell);
  const std::uint64_t differed = run.cosimulation.message_controller().health().counts_differed;
  run.play_until(12.0);
  EXPECT_EQ(run.cosimulation.message_controller().health().counts_differed, differed)
      << "every joint was put right";
  EXPECT_FALSE(run.recorder.metrics().fell);
}

TEST_F(Revisions, OneSeedGivesOneRun) {
  const auto digest = [&](std::uint64_t seed) {
    Run run(robot_.model, seed);
    run.play_until(4.0);
    run.recorder.finish();
    return run.recorder.digest();
  };
  EXPECT_EQ(digest(5), digest(5));
}

}  // namespace
}  // namespace gaitway::scenarios
