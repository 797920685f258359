// A robot that walks by what its eyes have seen, past a box that no map knows, and whose eyes fail on the
// way: the fault is said by its name, the robot stays up, and it touches nothing that it knew of.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fault_trial.hpp"
#include "simulated_run.hpp"
#include "urdf/broken_robot.hpp"

namespace gaitway::scenarios {
namespace {

using simulator::CameraFault;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr double kAsked_s = 1.5, kFault_s = 4.0, kMost_s = 30.0;
const Eigen::Vector3d kBox_m(0.2, 0.3, 0.25);
const Eigen::Vector3d kBoxAt_m(1.15, 0.04, 0.125);

world::World room() {
  world::World room;
  room.name = "room";
  const auto surface = [](double repeat_m, std::uint64_t seed) {
    return world::Surface{.kind = world::Surface::Kind::noise,
                          .colours = {{{0.2, 0.18, 0.15}, {0.85, 0.8, 0.7}}},
                          .repeat_m = repeat_m,
                          .seed = seed,
                          .image = {}};
  };
  room.surfaces = {surface(0.9, 3), surface(0.5, 4)};
  world::Solid box;
  box.name = "box";
  box.size_m = kBox_m;
  box.surface = 1;
  box.pose.translation() = kBoxAt_m;
  room.solids.push_back(box);
  return room;
}

struct Eyes {
  std::string library = "libgaitway_plugin_vision.so";
  std::string isolation = "none";
  std::string parameters{};
};

class SeeingRun {
 public:
  explicit SeeingRun(const Eyes& eyes = {})
      : run_(humanoid22(), options(eyes)),
        recorder_(run_, {}, false),
        obstacles_(run_.client().read<Obstacles>("obstacles")),
        state_(run_.client().read<VisionState>("vision_state")) {
    run_.observe(&recorder_);
  }

  // Up to an instant, or until it has walked past the box or has fallen.
  void walk_until(double end_s) {
    while (time_s() < end_s && !recorder_.metrics().fell && !is_past_box()) advance();
  }
  void begin(const CameraFault& fault) { apply({time_s(), fault}); }

  [[nodiscard]] double time_s() const { return static_cast<double>(run_.now_ns()) * 1e-9; }
  [[nodiscard]] bool is_past_box() const {
    return run_.plant().truth().base.translation().x() > kBoxAt_m.x() + 0.5 * kBox_m.x() + 0.25;
  }
  // Told of the box that stands there.
  [[nodiscard]] bool knows_box() {
    const auto told = std::make_unique<Obstacles>();
    obstacles_.read(*told);
    for (std::uint32_t i = 0; i < told->count; ++i) {
      const Eigen::Vector2d at_m(told->place[i][0], told->place[i][1]);
      if ((at_m - kBoxAt_m.head<2>()).norm() < 0.12) return true;
    }
    return false;
  }
  [[nodiscard]] VisionState state() {
    VisionState now{};
    state_.read(now);
    return now;
  }
  [[nodiscard]] std::vector<std::string> said(std::string_view by = "vision") const {
    std::vector<std::string> lines;
    const core::EventLog& events = run_.main_controller().events();
    for (std::uint64_t i = events.first(); i < events.total(); ++i) {
      if (events[i].source() == by) lines.emplace_back(events[i].text());
    }
    return lines;
  }
  void expect_unharmed() const {
    EXPECT_FALSE(recorder_.metrics().fell) << "fell at " << recorder_.metrics().fell_at_s;
    EXPECT_EQ(recorder_.contacts().total(), 0U) << "it knew of that box";
  }
  void expect_past_box() const {
    expect_unharmed();
    EXPECT_TRUE(is_past_box()) << "what it remembers is enough for the way";
  }
  [[nodiscard]] std::uint64_t digest() {
    recorder_.finish();
    return recorder_.digest();
  }
  [[nodiscard]] core::PluginManager& plugins() { return run_.plugins(); }

 private:
  void advance() {
    if (!asked_ && time_s() >= kAsked_s) {
      asked_ = true;
      apply(walk_to_at(time_s(), 2.2, 0.0, 0.0));
    }
    run_.advance_millisecond();
  }
  void apply(const simulator::ScenarioEvent& event) {
    recorder_.on_event(event, run_.now_ns());
    run_.apply(event);
  }
  static simulator::CosimulationOptions options(const Eyes& eyes) {
    std::string text = "plugins:\n";
    for (const std::string name : {"zmp", "trajectory", "stability", "kinematics"}) {
      text += fmt::format("  - name: {0}\n    library: libgaitway_plugin_{0}.so\n", name);
    }
    text +=
        "  - name: navigation\n    library: libgaitway_plugin_navigation.so\n"
        "    parameters: {plans_in_step: true}\n";
    text += fmt::format("  - name: vision\n    library: {}\n    isolation: {}\n    parameters: {{{}}}\n",
                        eyes.library, eyes.isolation, eyes.parameters);
    if (eyes.isolation == "process") text += "    answer: next_step\n    budget: 60 ms\n";
    simulator::CosimulationOptions result;
    result.plant.seed = 2;
    result.plant.world = room();
    result.camera.shadow_px = 0;  // drawn in half of the time
    result.main_controller.plugins = core::parse_configuration(text, "seeing.yaml");
    result.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
    return result;
  }

  simulator::Cosimulation run_;
  tools::RunRecorder recorder_;
  msgclient::Reader<Obstacles> obstacles_;
  msgclient::Reader<VisionState> state_;
  bool asked_ = false;
};

struct FaultCase {
  const char* name;
  CameraFault fault;
  std::uint32_t number;
  const char* words;
};
namespace faults = vision_state::fault;
using How = CameraFault::How;
using Camera = CameraFault::Camera;
const FaultCase kFaultCases[]{
    {"dead", {.how = How::dead, .camera = Camera::left}, faults::left_dead, "left camera shows nothing"},
    {"dark", {.how = How::dark, .camera = Camera::right}, faults::right_dark, "right picture is dark"},
    {"over_exposed",
     {.how = How::over_exposed, .camera = Camera::left},
     faults::left_bright,
     "left picture is over-exposed"},
    {"exchanged", {.how = How::exchanged}, faults::cameras_exchanged, "left and right are exchanged"},
    {"turned", {.how = How::turned, .camera = Camera::right}, faults::cameras_misaligned, "turned"},
    {"dropped", {.how = How::dropped}, faults::no_pictures, "no pictures come"},
    {"late", {.how = How::late}, faults::late_pictures, "pictures come too late"},
    {"frozen", {.how = How::frozen}, faults::frozen_pictures, "the same picture comes again"}};

class CameraFaults : public testing::TestWithParam<FaultCase> {};

TEST_P(CameraFaults, OnTheWayPastWhatWasSeen) {
  const FaultCase& one = GetParam();
  SeeingRun run;
  run.walk_until(kFault_s);
  ASSERT_TRUE(run.knows_box());
  ASSERT_EQ(run.state().fault, faults::none);
  run.begin(one.fault);
  run.walk_until(kFault_s + 1.5);
  EXPECT_EQ(run.state().fault, one.number);
  EXPECT_THAT(run.said(), Contains(HasSubstr(one.words)));
  EXPECT_TRUE(run.knows_box());
  run.walk_until(kMost_s);
  run.expect_past_box();
}

INSTANTIATE_TEST_SUITE_P(Each, CameraFaults, testing::ValuesIn(kFaultCases),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(FailingEyes, SeeAgainWhenThePicturesAreGoodAgain) {
  for (const CameraFault::How how : {CameraFault::How::dropped, CameraFault::How::turned}) {
    SeeingRun run;
    run.walk_until(kFault_s);
    run.begin({.how = how, .camera = CameraFault::Camera::right, .duration_s = 1.0});
    run.walk_until(kFault_s + 2.5);
    EXPECT_EQ(run.state().state, vision_state::state::sees);
    ASSERT_GE(run.said().size(), 2U) << "the fault, and that it is over";
    EXPECT_THAT(run.said().back(), HasSubstr("the cameras see again"));
    run.expect_unharmed();
  }
}

TEST(FailingEyes, OneSeedGivesOneDigest) {
  const auto digest = [] {
    SeeingRun run;
    run.walk_until(kAsked_s + 1.0);
    run.begin({.how = How::dark, .camera = Camera::right, .duration_s = 0.3});
    run.walk_until(kAsked_s + 2.0);
    return run.digest();
  };
  EXPECT_EQ(digest(), digest());
}

// What it has learnt goes over to its successor.
TEST(FailingEyes, AreReplacedOnTheWay) {
  SeeingRun run;
  run.walk_until(kFault_s);
  ASSERT_TRUE(run.knows_box());
  auto& changes = run.plugins().changes();
  ASSERT_TRUE(changes.schedule(changes.prepare_reload("vision", {})));
  run.walk_until(kFault_s + 0.3);
  const auto result = changes.take_result();
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->done) << result->text;
  EXPECT_TRUE(run.knows_box());
  run.walk_until(kMost_s);
  EXPECT_EQ(run.state().state, vision_state::state::sees);
  run.expect_past_box();
}

struct Sabotage {
  const char* name;
  const char* how;
  double duration_s;
  const char* words;
  bool comes_back;
};
const Sabotage kSabotages[]{
    {"CrashOnce", "segfault", 0.03, "was ended by SIGSEGV", true},
    {"CrashForGood", "segfault", 60.0, "out of service", false},
    {"HangOnce", "loop", 0.03, "did not answer within", true},
};

class CrashingEyes : public testing::TestWithParam<Sabotage> {};

// Their process is nobody else's: no batch waits for it, whatever becomes of it.
TEST_P(CrashingEyes, OnTheWay) {
  const Sabotage& one = GetParam();
  SeeingRun run({.library = GAITWAY_SABOTEURS "/vision.so",
                 .isolation = "process",
                 .parameters = fmt::format("sabotage: {}, sabotage_at: {} s, sabotage_for: {} s", one.how,
                                           kFault_s, one.duration_s)});
  run.walk_until(kFault_s - 0.1);
  ASSERT_TRUE(run.knows_box());
  run.walk_until(kFault_s + 2.0);
  EXPECT_THAT(run.said("vision"), Contains(HasSubstr(one.words)));
  EXPECT_THAT(run.said("main_controller"), Not(Contains(HasSubstr("not handed over"))));
  EXPECT_TRUE(run.knows_box());
  EXPECT_EQ(run.state().picture_ns > static_cast<std::int64_t>(1e9 * (kFault_s + 1.5)), one.comes_back);
  run.walk_until(kMost_s);
  run.expect_past_box();
}

INSTANTIATE_TEST_SUITE_P(Each, CrashingEyes, testing::ValuesIn(kSabotages),
                         [](const auto& one) { return std::string(one.param.name); });
TEST(FailingEyes, OfARobotWithoutACameraItIsSaidThatItHasNone) {
  const urdf::test::BrokenRobot blind;  // its folder has no camera.yaml
  const urdf::RobotModel robot = urdf::load_robot(blind.folder());
  const std::filesystem::path source = GAITWAY_SOURCE_DIR;
  simulator::CosimulationOptions options;
  options.main_controller.plugins = core::read_configuration(source / "core/config/eyes.yaml");
  options.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
  simulator::Cosimulation run(robot, options);
  while (run.now_ns() < 500'000'000) run.advance_millisecond();
  const core::Event* const said =
      first_event(run.main_controller().events(), "vision", core::EventKind::warning);
  ASSERT_NE(said, nullptr);
  EXPECT_THAT(std::string(said->text()), HasSubstr("camera.yaml is missing"));
}

}  // namespace
}  // namespace gaitway::scenarios
