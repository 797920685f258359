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
constexpr int kReloads = 100;

// A walk with turns; plug-ins named in `reloaded` are replaced by turns, one in each batch.
class ReloadedRun : public SimulatedRun {
 public:
  ReloadedRun() : SimulatedRun(1) { apply(walk_at(0.0, 0.15)); }
  void walk_until(double end_s) {
    while (time_s() < end_s && !metrics().fell) {
      cosimulation.advance_millisecond();
      if (const auto result = cosimulation.plugins().take_result()) {
        done += result->done ? 1 : 0;
        last_text = result->text;
        changing = false;
      }
    }
  }
  // At the next batch edge.
  void reload(const std::string& name, const std::string& library = {}) {
    auto change = cosimulation.plugins().prepare_reload(name, library);
    changing = cosimulation.plugins().schedule(std::move(change));
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

TEST_P(Reload, AHundredTimesWhileWalkingMakesNoDifferenceToTheJoints) {
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

}  // namespace
}  // namespace gaitway::scenarios
