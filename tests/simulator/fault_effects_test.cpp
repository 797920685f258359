// What a scenario's faults do to a robot that walks: each does what its name says, and nothing else.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "gaitway/can/messages.hpp"
#include "gaitway/simulator/cosimulation.hpp"

namespace gaitway::simulator {
namespace {

class FaultEffects : public testing::Test, public CosimulationObserver {
 protected:
  FaultEffects() {
    run_.observe(this);
    run_.apply({0.0, WalkEvent{.velocity_m_per_s = {0.2, 0.0}}});
    advance(1.003);
    before_ = run_.message_controller().state();
  }

  void on_frame(const can::SimulatedBus::Delivery& delivery) override {
    const auto of = run_.message_controller().profile().identify(delivery.frame.id);
    if (delivery.lost && of) {
      (of->kind == can::MessageKind::trajectory && of->node == knee_node() ? batches_lost_ : others_lost_) +=
          1;
    }
    if (!delivery.lost && !delivery.received_by(1 + knee()) && !delivery.sent_by(1 + knee())) ++knee_missed_;
  }
  void on_millisecond(std::int64_t) override {}

  void inject(const std::string& fault) {
    run_.apply(parse_action("{fault: {" + fault + "}}", "test", run_.robot()));
  }
  void advance(double seconds) {
    const std::int64_t until_ns = run_.now_ns() + static_cast<std::int64_t>(seconds * 1e9);
    while (run_.now_ns() < until_ns) run_.advance_millisecond();
  }
  // Of batches, since the walk was under way.
  [[nodiscard]] std::uint64_t late() const { return run_.message_controller().state().late - before_.late; }
  [[nodiscard]] std::uint64_t refused() const {
    return run_.message_controller().state().refused - before_.refused;
  }
  [[nodiscard]] int knee() const { return run_.robot().joint_index("left_knee"); }
  [[nodiscard]] can::NodeId knee_node() const {
    return run_.robot().joints[static_cast<std::size_t>(knee())].node;
  }

  static CosimulationOptions options() {
    CosimulationOptions options;
    options.main_controller.configuration =
        std::filesystem::path(GAITWAY_SOURCE_DIR) / "core/config/walk.yaml";
    options.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
    return options;
  }
  Cosimulation run_{urdf::load_robot(GAITWAY_ROBOT), options()};
  NetworkState before_{};
  int batches_lost_ = 0, others_lost_ = 0, knee_missed_ = 0;
};

TEST_F(FaultEffects, WithoutAFaultNoBatchIsLateOrRefused) {
  advance(0.3);
  EXPECT_EQ(late() + refused(), 0U);
  EXPECT_EQ(knee_missed_, 0);
}

TEST_F(FaultEffects, ABatchThatIsLateByMoreThanThereIsTimeIsToldSo) {
  inject("kind: batch_fails, how: late, late_s: 0.06");
  advance(0.3);
  EXPECT_EQ(late(), 1U) << "the next one alone";
  EXPECT_GT(run_.message_controller().state().tail_played, before_.tail_played);
}

TEST_F(FaultEffects, ABatchThatIsLateByAMillisecondIsInTime) {
  inject("kind: batch_fails, how: late, late_s: 0.001");
  advance(0.3);
  EXPECT_EQ(late() + refused(), 0U);
}

TEST_F(FaultEffects, ABatchThatIsDamagedOnItsWayIsRefused) {
  inject("kind: batch_fails, how: damaged");
  advance(0.3);
  EXPECT_EQ(refused(), 1U);
}

TEST_F(FaultEffects, BatchesThatOughtNotToBeAreRefusedAndTheWalkGoesOn) {
  for (const char* const how : {"old", "early", "garbage"}) {
    SCOPED_TRACE(how);
    before_ = run_.message_controller().state();
    inject(std::string("kind: batch_fails, how: ") + how);
    advance(0.3);
    EXPECT_EQ(late() + refused(), 1U);
    EXPECT_EQ(run_.message_controller().state().tail_played, before_.tail_played);
  }
}

// One that begins where the joints are is as good as any: it is played, and the robot goes on from there.
TEST_F(FaultEffects, AStaleBatchIsRefusedOrPlayedAndTheRobotWalksInTheEnd) {
  const std::uint64_t handed_over = run_.message_controller().state().handed_over;
  inject("kind: batch_fails, how: stale");
  advance(0.001);
  EXPECT_EQ(run_.message_controller().state().handed_over, handed_over + 1) << "it came";
  advance(4.0);
  EXPECT_FALSE(run_.plant().fallen());
  EXPECT_EQ(run_.message_controller().mode(), msgcontroller::Mode::batches);
}

TEST_F(FaultEffects, AJointWithoutItsBatchLosesThatAloneAndIsRepaired) {
  inject("kind: lose_frames, probability: 1, duration_s: 0.1, batch_of: left_knee");
  advance(0.3);
  EXPECT_GT(batches_lost_, 0);
  EXPECT_EQ(others_lost_, 0);
  EXPECT_GT(run_.message_controller().state().resynchronised, before_.resynchronised);
}

TEST_F(FaultEffects, AJointThatHearsNothingIsTheOnlyOne) {
  inject("kind: misses_frames, node: left_knee, duration_s: 0.02");
  advance(0.3);
  EXPECT_GT(knee_missed_, 40) << "two slots' frames";
  const can::InjectedFaults& injected = run_.bus().statistics().injected;
  EXPECT_EQ(injected.omitted_receptions, injected.omissions) << "one receiver each";
}

TEST_F(FaultEffects, ABabblerKeepsTheBusFromAllOthers) {
  const std::uint64_t heard = run_.message_controller().health().feedback_lost;
  inject("kind: babbles, id: 0, data: [], duration_s: 0.03");
  advance(0.3);
  EXPECT_GT(run_.bus().statistics().injected.babbled_frames, 400U) << "some 47 us each";
  EXPECT_GE(run_.message_controller().health().feedback_lost - heard, 44U) << "two slots of 22 joints";
}

TEST_F(FaultEffects, AJointThatDiesGivesNoTorqueAndComesNeverBack) {
  inject("kind: joint_dies, joint: left_knee");
  advance(0.3);
  EXPECT_EQ(run_.joints().torque_Nm()[static_cast<std::size_t>(knee())], 0.0);
  EXPECT_EQ(run_.bus().state(1 + knee()), can::BusState::down);
  EXPECT_EQ(run_.bus().statistics().injected.power_ons, 0U);
}

}  // namespace
}  // namespace gaitway::simulator
