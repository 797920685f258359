// The robot plays key-frame motions through the whole chain: one-byte points, batches, trims, safe tails.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/scenario.hpp"

namespace gaitway::scenarios {
namespace {

using msgcontroller::Mode;

const urdf::RobotModel& humanoid22() {
  static const urdf::RobotModel robot = urdf::load_robot(GAITWAY_ROBOT);
  return robot;
}

simulator::ScenarioEvent motion_at(double at_s, const std::string& name) {
  return {at_s, simulator::MotionEvent{name}};
}
simulator::ScenarioEvent walk_at(double at_s, double forward, double turn = 0.0) {
  return {at_s, simulator::WalkEvent{.velocity_m_per_s = {forward, 0.0}, .turn_rate_rad_per_s = turn}};
}
simulator::ScenarioEvent stand_at(double at_s) {
  return {at_s, simulator::WalkEvent{.walk = false}};
}

simulator::CosimulationOptions options(std::uint64_t seed) {
  simulator::CosimulationOptions result;
  result.plant.seed = seed;
  result.main_controller.configuration = GAITWAY_CONFIGURATION;
  result.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
  return result;
}

// A run, and what topics and physics say of it.
class Show {
 public:
  explicit Show(std::uint64_t seed)
      : run(humanoid22(), options(seed)), states(run.client().read<MotionState>("motion_state")) {}

  // Until `seconds` of the run, or a fall.
  void play(double seconds, const std::vector<simulator::ScenarioEvent>& events = {}) {
    auto event = events.begin();
    while (time_s() < seconds && (!fell || may_fall)) {
      for (; event != events.end() && event->at_s <= time_s() + 1e-9; ++event) run.apply(*event);
      run.advance_millisecond();
      fell = run.plant().fallen();
    }
  }
  [[nodiscard]] double time_s() const { return static_cast<double>(run.now_ns()) * 1e-9; }
  MotionState state() {
    MotionState state{};
    static_cast<void>(states.read(state));
    return state;
  }
  std::string text() {
    const MotionState now = state();
    const auto* const text = reinterpret_cast<const char*>(now.text);
    return {text, strnlen(text, sizeof now.text)};
  }
  double joint_rad(std::string_view name) const {
    const auto j = static_cast<std::size_t>(humanoid22().joint_index(name));
    return run.plant().sensors().encoder_count[j] * humanoid22().joints[j].encoder_count_rad;
  }
  // Upright, at rest, every joint near its place in the stand.
  void expect_standing(const char* what = "") const {
    constexpr double kWithin_rad = 0.06;
    EXPECT_TRUE(!fell || may_fall) << what << " fell at " << time_s() << " s";
    EXPECT_LT(run.plant().truth().trunk_tilt_rad, 0.05) << what;
    const auto velocities = run.plant().velocities();
    EXPECT_LT(std::hypot(velocities[0], velocities[1]), 0.03) << what;
    for (const urdf::Joint& joint : humanoid22().joints) {
      EXPECT_NEAR(joint_rad(joint.name), joint.home_rad, kWithin_rad) << what << ' ' << joint.name;
    }
  }
  [[nodiscard]] double distance_m() const { return run.plant().truth().base.translation().head<2>().norm(); }

  simulator::Cosimulation run;
  msgclient::Reader<MotionState> states;
  bool fell = false, may_fall = false;
};

constexpr std::uint32_t kFinished = 1, kLeft = 2, kBrokenOff = 3;

struct Played {
  const char* name;
  double seconds;
  const char* joint;
  double way_rad;  // at least this far from the stand, some time
};

class PlayedMotion : public ::testing::TestWithParam<Played> {};

// Mismatch 1, noise and backlash as ever; the network notices nothing.
TEST_P(PlayedMotion, EndsInTheStand) {
  const Played& played = GetParam();
  const auto joint = static_cast<std::size_t>(humanoid22().joint_index(played.joint));
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    Show show(seed);
    show.play(1.0, {motion_at(0.9, played.name)});
    double farthest_rad = 0.0;
    for (double time_s = 1.05; time_s < played.seconds + 2.0; time_s += 0.05) {
      show.play(time_s);
      farthest_rad = std::max(farthest_rad,
                              std::abs(show.joint_rad(played.joint) - humanoid22().joints[joint].home_rad));
    }
    show.expect_standing();
    EXPECT_GT(farthest_rad, played.way_rad) << "seed " << seed;
    EXPECT_EQ(show.state().result, kFinished) << show.text();
    EXPECT_EQ(show.state().ended, 1U);
    const NetworkState& network = show.run.message_controller().state();
    EXPECT_EQ(network.refused + network.late + network.tail_played, 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Motions, PlayedMotion,
                         ::testing::Values(Played{"wave", 1.97, "left_shoulder_roll", 1.8},
                                           Played{"bow", 2.2, "waist_pitch", 0.25},
                                           Played{"squat", 1.23, "left_knee", 0.6},
                                           Played{"kick", 2.75, "right_hip_pitch", 0.4}),
                         [](const auto& chosen) { return chosen.param.name; });

TEST(Motion, ComesBetweenTwoWalks) {
  Show show(2);
  show.play(17.0, {walk_at(1.0, 0.15), stand_at(4.0), motion_at(7.0, "kick"), walk_at(11.0, 0.15, 0.2),
                   stand_at(14.0)});
  show.expect_standing();
  EXPECT_EQ(show.state().result, kFinished) << show.text();
  EXPECT_GT(show.distance_m(), 0.6);
}

TEST(Motion, IsRefusedWithItsReason) {
  Show show(1);
  show.play(0.5, {motion_at(0.3, "jump")});
  EXPECT_EQ(show.text(),
            "there is no motion 'jump'; there is: bow, get_up_back, get_up_front, kick, squat, wave");
  show.play(0.9, {motion_at(0.6, "get_up_front")});
  EXPECT_EQ(show.text(),
            "'get_up_front' cannot begin: it begins on the ground, and the robot does not lie there");
  show.play(1.5, {motion_at(1.0, "wave"), motion_at(1.3, "bow")});
  EXPECT_EQ(show.text(), "'bow' cannot begin: another motion plays. Wait for its end, or have it left");
  show.play(5.0, {walk_at(3.5, 0.1), motion_at(4.7, "wave")});
  EXPECT_EQ(show.text(), "'wave' cannot begin: the robot walks. Let it stand first");
  EXPECT_EQ(show.state().ended, 1U);
  EXPECT_FALSE(show.fell);
}

// From any instant: two feet go home at once, one foot first comes down.
TEST(Motion, IsLeftByItsWayOutAtAnyInstant) {
  int earlier = 0;
  for (const auto& [name, seconds] :
       {std::pair{"squat", 1.23}, {"bow", 2.2}, {"kick", 2.75}, {"wave", 1.97}}) {
    for (const double share : {0.2, 0.55, 0.8}) {
      Show show(3);
      show.play(1.0 + seconds + 1.5, {motion_at(1.0, name), motion_at(1.1 + share * seconds, "")});
      show.expect_standing(name);
      EXPECT_EQ(show.state().ended, 1U) << name;
      earlier += show.state().result == kLeft ? 1 : 0;
    }
  }
  EXPECT_GE(earlier, 8);
}

TEST(Motion, GivesWayToAWalk) {
  Show show(4);
  show.play(7.0, {motion_at(1.0, "bow"), walk_at(1.8, 0.15), stand_at(5.0)});
  show.expect_standing();
  EXPECT_EQ(show.state().result, kLeft);
  EXPECT_GT(show.distance_m(), 0.2);
}

// A stop, and a main controller that dies, leave the motion to the safe tail.
TEST(Motion, EndsInTheStandByItsSafeTail) {
  for (const auto& [name, seconds] :
       {std::pair{"squat", 1.23}, {"bow", 2.2}, {"kick", 2.75}, {"wave", 1.97}}) {
    for (const double share : {0.3, 0.65}) {
      Show stopped(5);
      stopped.play(1.0 + seconds + 1.5,
                   {motion_at(1.0, name), {1.1 + share * seconds, simulator::StopEvent{}}});
      stopped.expect_standing(name);
      EXPECT_EQ(stopped.state().result, kBrokenOff) << name;
      EXPECT_GT(stopped.run.message_controller().state().tail_played, 0U);

      Show dead(6);
      dead.play(1.0 + seconds + 2.5,
                {motion_at(1.0, name), {1.1 + share * seconds, simulator::MainControllerSilentFault{}}});
      dead.expect_standing(name);
      EXPECT_EQ(dead.run.message_controller().mode(), Mode::holding);
    }
  }
}

TEST(Motion, BeginsAgainAfterItsSafeTail) {
  Show show(7);
  show.play(
      9.0,
      {motion_at(1.0, "squat"), {1.5, simulator::MainControllerSilentFault{2.0}}, motion_at(5.0, "bow")});
  show.expect_standing();
  EXPECT_EQ(show.state().result, kFinished) << show.text();
  EXPECT_EQ(show.state().ended, 2U);
}

// A new version of each plug-in goes on from where the old one was.
TEST(Motion, GoesOnToTheBitWhenPluginsAreReloaded) {
  const auto end_of = [](const std::vector<std::string>& reloaded) {
    Show show(8);
    show.play(1.6, {motion_at(1.0, "kick")});
    for (const std::string& plugin : reloaded) {
      EXPECT_TRUE(
          show.run.plugins().changes().schedule(show.run.plugins().changes().prepare_reload(plugin, {})));
      show.play(show.time_s() + 0.16);
      const auto result = show.run.plugins().changes().take_result();
      EXPECT_TRUE(result && result->done) << plugin << ": " << (result ? result->text : "no answer");
    }
    show.play(4.5);
    EXPECT_EQ(show.state().result, kFinished);
    const auto positions = show.run.plant().positions();
    return std::vector<double>(positions.begin(), positions.end());
  };
  EXPECT_EQ(end_of({"trajectory", "kinematics", "stability"}), end_of({}));
}

struct Fall {
  const char* get_up;
  double direction;   // 1 onto the front, -1 onto the back
  const char* other;  // gets up from there
  const char* why_not_other;
};

class OnTheGround : public ::testing::TestWithParam<Fall> {
 protected:
  // Pushed over, and lying still.
  Show& fallen(std::uint64_t seed) {
    show_.emplace(seed);
    show_->may_fall = true;
    show_->play(4.0, {{1.0, simulator::PushEvent{"trunk", {GetParam().direction, 0.0, 0.0}, 7.0, 0.1}}});
    EXPECT_LT(height_m(), 0.15);
    EXPECT_LT(GetParam().direction * show_->run.plant().truth().trunk.linear()(2, 0), -0.9)
        << "the side it lies on";
    return *show_;
  }
  [[nodiscard]] double height_m() const { return show_->run.plant().truth().base.translation().z(); }
  std::optional<Show> show_;
};

INSTANTIATE_TEST_SUITE_P(Motions, OnTheGround,
                         ::testing::Values(Fall{"get_up_front", 1.0, "get_up_back",
                                                "it begins on the back, and the robot lies on its front"},
                                           Fall{"get_up_back", -1.0, "get_up_front",
                                                "it begins on the front, and the robot lies on its back"}),
                         [](const auto& chosen) { return chosen.param.get_up; });

TEST_P(OnTheGround, GetsUpAndWalks) {
  Show& show = fallen(1);
  show.play(4.5, {motion_at(4.0, "wave")});
  EXPECT_EQ(show.text(), "'wave' cannot begin: it begins in the stand, and the robot does not stand");
  show.play(4.7, {motion_at(4.5, GetParam().other)});
  EXPECT_EQ(show.text(), fmt::format("'{}' cannot begin: {}", GetParam().other, GetParam().why_not_other));
  show.play(20.0, {motion_at(4.7, GetParam().get_up), walk_at(16.5, 0.15)});
  EXPECT_EQ(show.state().result, kFinished) << show.text();
  EXPECT_GT(height_m(), 0.34);
  EXPECT_LT(show.run.plant().truth().trunk_tilt_rad, 0.1);
}

// The tail lets it lie, no stand is planned, and it gets up later.
TEST_P(OnTheGround, LiesStillWhenTheMainControllerFallsSilent) {
  Show& show = fallen(3);
  show.play(9.5, {motion_at(4.0, GetParam().get_up), {6.5, simulator::MainControllerSilentFault{1.0}}});
  const Eigen::Isometry3d lying = show.run.plant().truth().trunk;
  show.play(10.0);
  EXPECT_EQ(show.state().result, kBrokenOff);
  EXPECT_EQ(show.run.message_controller().mode(), Mode::holding);
  const Eigen::Isometry3d still = show.run.plant().truth().trunk;
  EXPECT_LT((still.translation() - lying.translation()).norm(), 0.02);
  EXPECT_LT(Eigen::AngleAxisd(still.linear().transpose() * lying.linear()).angle(), 0.1);
  EXPECT_EQ(show.run.message_controller().state().refused, 0U);
  show.play(23.0, {motion_at(10.0, "get_up_front")});  // from the back, it has rolled over by then
  EXPECT_EQ(show.state().result, kFinished) << show.text();
  show.expect_standing();
}

}  // namespace
}  // namespace gaitway::scenarios
