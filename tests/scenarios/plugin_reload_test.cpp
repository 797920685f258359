// Plug-ins are replaced while the robot walks, and nothing of it is to be seen in the joints.
#include <gmock/gmock.h>

#include <array>
#include <string>
#include <string_view>

#include "simulated_run.hpp"

namespace gaitway::scenarios {
namespace {

using testing::HasSubstr;

constexpr double kFirstReload_s = 2.0;
#ifdef GAITWAY_SANITIZED
constexpr int kReloads = 20;
#else
constexpr int kReloads = 100;
#endif

// A walk with turns; plug-ins named in `reloaded` are replaced by turns, one in each batch.
class ReloadedRun : public SimulatedRun {
 public:
  ReloadedRun() : SimulatedRun(1) { apply(walk_at(0.0, 0.15)); }
  void walk_until(double end_s) {
    while (time_s() < end_s && !metrics().fell) {
      cosimulation.advance_millisecond();
      if (const auto result = cosimulation.plugins().changes().take_result()) {
        done += result->done ? 1 : 0;
        last_text = result->text;
        changing = false;
      }
    }
  }
  // At the next batch edge.
  void reload(const std::string& name, const std::string& library = {}) {
    auto change = cosimulation.plugins().changes().prepare_reload(name, library);
    changing = cosimulation.plugins().changes().schedule(std::move(change));
    ASSERT_TRUE(changing);
  }

  int done = 0;
  bool changing = false;
  std::string last_text;
};

double end_of_run_s(int reloads) {
  return kFirstReload_s + 0.08 * (reloads + 2);
}

std::uint64_t undisturbed_digest() {
  static const std::uint64_t digest = [] {
    ReloadedRun run;
    run.walk_until(end_of_run_s(kReloads));
    run.recorder.finish();
    return run.recorder.digest();
  }();
  return digest;
}

class Reload : public testing::TestWithParam<std::string_view> {};

TEST_P(Reload, OverAndOverWhileWalkingMakesNoDifferenceToTheJoints) {
  ReloadedRun run;
  run.walk_until(kFirstReload_s);
  for (int i = 0; i < kReloads; ++i) {
    run.reload(std::string(GetParam()));
    run.walk_until(kFirstReload_s + 0.08 * (i + 1));
    ASSERT_EQ(run.done, i + 1) << run.last_text;
  }
  run.walk_until(end_of_run_s(kReloads));
  run.recorder.finish();
  EXPECT_FALSE(run.metrics().fell);
  EXPECT_EQ(run.recorder.digest(), undisturbed_digest())
      << "every frame and joint state is as without reloads";
}
INSTANTIATE_TEST_SUITE_P(Plugins, Reload, testing::Values("trajectory", "kinematics", "stability", "zmp"),
                         [](const auto& instance) { return std::string(instance.param); });

// Fallbacks take its place while it is away, whatever it is; afterwards the robot walks (again).
class StoppedAndStarted : public testing::TestWithParam<std::string_view> {};

TEST_P(StoppedAndStarted, RobotStaysUpAndWalksAfterwards) {
  const std::string name(GetParam());
  ReloadedRun run;
  run.walk_until(4.0);
  core::PluginManager& plugins = run.cosimulation.plugins();
  ASSERT_TRUE(plugins.changes().schedule(plugins.changes().prepare_stop(name)));
  run.walk_until(4.3);
  ASSERT_EQ(run.done, 1) << run.last_text;
  EXPECT_THROW((void)plugins.changes().prepare_stop(name), core::PluginError) << "it is stopped already";
  run.walk_until(9.0);
  ASSERT_FALSE(run.metrics().fell) << "fell at " << run.metrics().fell_at_s;
  ASSERT_TRUE(plugins.changes().schedule(plugins.changes().prepare_start(name)));
  run.walk_until(9.3);
  ASSERT_EQ(run.done, 2) << run.last_text;
  EXPECT_THROW((void)plugins.changes().prepare_start(name), core::PluginError) << "it is not stopped";
  run.walk_until(11.0);
  const auto place = [&] { return run.cosimulation.plant().truth().base.translation().head<2>().eval(); };
  const Eigen::Vector2d before = place();
  run.walk_until(17.0);
  EXPECT_FALSE(run.metrics().fell) << "fell at " << run.metrics().fell_at_s;
  EXPECT_GT((place() - before).norm(), 0.5) << "of 0.9 m in these 6 s";
}
INSTANTIATE_TEST_SUITE_P(Plugins, StoppedAndStarted,
                         testing::Values("trajectory", "kinematics", "stability", "zmp"),
                         [](const auto& instance) { return std::string(instance.param); });

}  // namespace
}  // namespace gaitway::scenarios
