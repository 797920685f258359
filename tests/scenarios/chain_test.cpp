// The whole chain: deterministic, without by-pass, in time, and honest about its ZMP.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/simulator/joint_network.hpp"
#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

const simulator::Scenario kShortWalk{.seconds = 8.0, .events = {walk_at(1.0, 0.15)}};

std::filesystem::path temporary_log(const std::string& name) {
  return std::filesystem::temp_directory_path() /
         ("gaitway_" + name + "_" + std::to_string(getpid()) + ".log");
}

std::uint64_t digest_of(std::uint64_t seed,
                        const std::filesystem::path& configuration = "core/config/walk.yaml") {
  SimulatedRun run(seed, {}, configuration);
  run.play(kShortWalk);
  return run.recorder.digest();
}

TEST(Chain, OneSeedGivesOneDigestAndAnotherAnother) {
  const std::uint64_t first = digest_of(1);
  EXPECT_EQ(first, digest_of(1));
  EXPECT_NE(first, digest_of(2));
}

// A served robot walks for days.
TEST(Chain, ARecorderThatKeepsNoSamplesDoesNotGrow) {
  SimulatedRun run(1);
  run.play({.seconds = 1.0, .events = {}});
  EXPECT_TRUE(run.recorder.samples().empty());
  EXPECT_TRUE(run.recorder.torques().empty());
}

#ifndef GAITWAY_SANITIZED  // its runtime does not end well in a bounded process
TEST(Chain, PluginsInProcessesOfTheirOwnChangeNothing) {
  EXPECT_EQ(digest_of(1), digest_of(1, "tests/scenarios/isolated.yaml"));
}
#endif

// Keeps every joint's reference count at the end of each time slot.
class ReferenceRecorder final : public simulator::CosimulationObserver {
 public:
  explicit ReferenceRecorder(simulator::Cosimulation& run, tools::RunRecorder& next)
      : run_(run), next_(next) {}
  void on_frame(const can::SimulatedBus::Delivery& delivery) override { next_.on_frame(delivery); }
  void on_millisecond(std::int64_t now_ns) override {
    next_.on_millisecond(now_ns);
    std::vector<std::int32_t>& row = counts[now_ns];
    for (int joint = 0; joint < run_.joints().size(); ++joint) {
      row.push_back(run_.joints().joint(joint).reference_count());
    }
  }
  std::map<std::int64_t, std::vector<std::int32_t>> counts;

 private:
  simulator::Cosimulation& run_;
  tools::RunRecorder& next_;
};

TEST(Chain, TheBusLogAloneExplainsEveryJointReferenceToTheCount) {
  const std::filesystem::path log = temporary_log("replay");
  SimulatedRun run(6, log);
  ReferenceRecorder references(run.cosimulation, run.recorder);
  run.cosimulation.observe(&references);
  run.play(kShortWalk);
  ASSERT_FALSE(run.metrics().fell);

  // The same local controllers, fed with nothing but the frames of the log.
  simulator::JointNetwork joints(humanoid22(), 6, 50.0);
  simulator::PlantSensors nothing;
  nothing.encoder_count.assign(humanoid22().joints.size(), 0);
  nothing.angular_velocity_rad_per_s.setZero();
  nothing.acceleration_m_per_s2.setZero();
  nothing.inclination_rad.setZero();
  nothing.force_N = {};
  nothing.foot_acceleration_m_per_s2 = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  const std::vector<can::LoggedFrame> frames = can::read_candump_log(log);
  auto frame = frames.begin();
  bool moved = false;
  for (const auto& [time_ns, counts] : references.counts) {
    joints.step(time_ns - 1'000'000, nothing);
    for (; frame != frames.end() && frame->time_ns <= time_ns; ++frame) {
      for (int joint = 0; joint < joints.size(); ++joint) {
        joints.on_frame(joint, frame->frame, frame->time_ns);
      }
    }
    for (int joint = 0; joint < joints.size(); ++joint) {
      ASSERT_EQ(joints.joint(joint).reference_count(), counts[static_cast<std::size_t>(joint)])
          << "joint " << joint << " at " << time_ns << " ns";
    }
    moved = moved || counts != references.counts.begin()->second;
  }
  EXPECT_TRUE(moved);
  std::filesystem::remove(log);
}

TEST(Chain, TwelveTrajectoryFramesOfWalkingTakeAsLongAsWasPublished) {
  const std::filesystem::path log = temporary_log("twelve");
  SimulatedRun run(7, log);
  run.play({.seconds = 21.0, .events = {walk_at(1.0, 0.15)}});
  // The twelve leg joints' frames of each batch that walked, each with its interframe space.
  double bits = 0.0;
  int frames = 0;
  for (const can::LoggedFrame& logged : can::read_candump_log(log)) {
    const auto trajectory = can::decode_trajectory(can::kFullProfile, logged.frame);
    if (!trajectory || logged.time_ns < 3'000'000'000) {
      continue;
    }
    for (const urdf::Leg& leg : humanoid22().legs) {
      for (const int joint : leg.joints) {
        if (humanoid22().joints[static_cast<std::size_t>(joint)].node == trajectory->node) {
          bits += can::frame_bits(logged.frame) + can::kInterframeBits;
          ++frames;
        }
      }
    }
  }
  ASSERT_GT(frames, 12 * 200);
  const double twelve_ms = bits / frames * 12.0 * 1e-3;
  RecordProperty("twelve_trajectory_frames_ms", std::to_string(twelve_ms));
  EXPECT_GE(twelve_ms, 1.38);
  EXPECT_LE(twelve_ms, 1.50);
  std::filesystem::remove(log);
}

TEST(Chain, TheCellsZmpIsTheCentreOfPressureWithinFiveMillimetres) {
  SimulatedRun run(8);
  run.play({.seconds = 21.0, .events = {walk_at(1.0, 0.15)}});
  ASSERT_FALSE(run.metrics().fell);
  ASSERT_GT(run.metrics().zmp_estimate_error_m.count(), 1000U);
  EXPECT_LT(run.metrics().zmp_estimate_error_m.value(), 0.005);
}

TEST(Chain, EverySlotHasOneSyncAndOneFeedbackFromEveryJoint) {
  const std::filesystem::path log = temporary_log("slots");
  SimulatedRun run(9, log);
  run.play({.seconds = 4.0, .events = {walk_at(1.0, 0.15)}});
  std::map<std::int64_t, std::map<can::MessageKind, int>> slots;
  for (const can::LoggedFrame& logged : can::read_candump_log(log)) {
    ++slots[logged.time_ns / 10'000'000][can::kFullProfile.identify(logged.frame.id)->kind];
  }
  ASSERT_EQ(slots.size(), 400U);
  for (const auto& [slot, counts] : slots) {
    EXPECT_EQ(counts.at(can::MessageKind::sync), 1) << "slot " << slot;
    EXPECT_EQ(counts.at(can::MessageKind::feedback), 22) << "slot " << slot;
  }
  std::filesystem::remove(log);
}

TEST(Readme, ShowsThePluginThatIsBuilt) {
  const auto content = [](const char* file) {
    std::ifstream in(std::filesystem::path(GAITWAY_SOURCE_DIR) / file);
    return std::string{std::istreambuf_iterator<char>(in), {}};
  };
  const std::string plugin = content("docs/examples/ankle_trim.cpp");
  ASSERT_FALSE(plugin.empty());
  EXPECT_NE(content("README.md").find(plugin), std::string::npos);
}

TEST(Readme, TheRobotWalksWithItsPlugin) {
  SimulatedRun run(10, {}, "docs/examples/ankle_trim.yaml");
  run.play({.seconds = 11.0, .events = {walk_at(1.0, 0.1)}});
  EXPECT_FALSE(run.metrics().fell);
  EXPECT_GT(run.metrics().distance_m(), 0.7);
}

}  // namespace
}  // namespace gaitway::scenarios
