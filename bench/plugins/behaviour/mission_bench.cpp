// What one tick of a mission costs: 200 nodes with leaves over the robot's topics, of which many begin, end
// and walk, and what is told of the tree. Processor time of one thread. `mission_bench [TICKS]`.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "gaitway/behaviour_leaves/leaves.hpp"
#include "gaitway/behaviour_leaves/mission_runner.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::behaviour_leaves {
namespace {

std::int64_t processor_ns() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

// Parts of 10 nodes, all visited in each tick: tags looked for, ways, walks, motions.
std::string mission_of(int nodes) {
  std::string text = R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><ParallelAll max_failures="-1">)";
  for (int i = 1; i + 10 <= nodes; i += 10) {
    text += fmt::format(
        "<KeepRunningUntilFailure><ReactiveFallback><Sequence><Fallen/><GetUp/></Sequence>"
        "<ReactiveSequence><TagIsNear id=\"{0}\" within=\"3 m\"/><Upright/><WalkToTag id=\"{0}\"/>"
        "</ReactiveSequence><AlwaysSuccess/></ReactiveFallback></KeepRunningUntilFailure>",
        i % 30);
  }
  return text + "</ParallelAll></BehaviorTree></root>";
}

struct Silent final : MissionRunner::Listener {
  void on_line(bool, const char*) noexcept override {}
};

void measure(int ticks) {
  const auto robot = std::make_shared<Robot>();
  behaviour::Registry registry;
  register_leaves(registry, robot);
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "mission_bench.xml";
  std::ofstream(file) << mission_of(200);
  Silent listener;
  MissionRunner runner(registry, *robot, MissionDesk::Where::in_step, listener);
  runner.load(file.string());
  std::filesystem::remove(file);

  Estimate estimate{};
  FootstepState footsteps{};
  NavigationState navigation{};
  MotionState motion{};
  SeenTargets targets{};
  targets.count = kMaxTargets;
  const auto told = std::make_unique<BehaviourState>();
  const auto nodes = std::make_unique<BehaviourNodes>();
  std::vector<std::int64_t> cost_ns;
  cost_ns.reserve(static_cast<std::size_t>(ticks));
  for (int tick = 1; tick <= ticks; ++tick) {
    const std::int64_t now_ns = tick * facts::kCycle_ns;
    for (std::uint32_t i = 0; i < kMaxTargets; ++i) {  // seen by turns
      targets.id[i] = i;
      targets.seen_ns[i] = (tick + static_cast<int>(i)) % 40 < 20 ? now_ns : 0;
      targets.position[i][0] = 1.0;
    }
    robot->situation = {.now_ns = now_ns,
                        .estimate = &estimate,
                        .footsteps = &footsteps,
                        .navigation = &navigation,
                        .motion = &motion,
                        .command = nullptr,
                        .targets = &targets,
                        .vision = nullptr,
                        .network = nullptr};
    const std::int64_t before = processor_ns();
    runner.step(true, true);
    runner.tell(*told);
    runner.tell(*nodes);
    cost_ns.push_back(processor_ns() - before);
    navigation.answered = robot->orders.way_number();
  }
  std::ranges::sort(cost_ns);
  const auto at = [&](double share) {
    const auto place = static_cast<std::size_t>(share * static_cast<double>(cost_ns.size()));
    return 1e-3 * static_cast<double>(cost_ns[std::min(cost_ns.size() - 1, place)]);
  };
  fmt::print(
      "{} nodes, {:.1f} transitions a tick: p50 {:.1f} us, p99 {:.1f} us, p99.9 {:.1f} us, worst {:.1f} us\n",
      told->node_count, static_cast<double>(told->transitions) / ticks, at(0.5), at(0.99), at(0.999),
      at(1.0));
}

}  // namespace
}  // namespace gaitway::behaviour_leaves

int main(int argc, char** argv) {
  constexpr int kTicks = 100'000;
  gaitway::behaviour_leaves::measure(argc > 1 ? std::max(1, std::atoi(argv[1])) : kTicks);
}
