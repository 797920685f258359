// What one tick of a behaviour tree costs: 200 nodes that are all visited, a mixed tree of 200 in which
// something changes at every tick, and the largest trees. Processor time of one thread.
// `behaviour_bench [TICKS]`.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "deep_tree.hpp"
#include "gaitway/behaviour/read.hpp"
#include "gaitway/behaviour/tree.hpp"

namespace gaitway::behaviour {
namespace {

std::int64_t processor_ns() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::int64_t{1'000'000'000} * time.tv_sec + time.tv_nsec;
}

// Runs for `ticks` ticks, then succeeds.
class Works final : public Action {
 public:
  Outcome on_start(Call& call) noexcept override {
    left_ = call.get<std::int64_t>(0).value_or(1);
    return on_running(call);
  }
  Outcome on_running(Call&) noexcept override { return left_-- > 0 ? Outcome::running : Outcome::success; }
  Halt on_halt(Call&) noexcept override { return Halt::ended; }

 private:
  std::int64_t left_ = 0;
};

// True but for one ask in `turns`.
class Turns final : public Condition {
 public:
  bool holds(Call& call) noexcept override { return ++asked_ % call.get<std::int64_t>(0).value_or(2) != 0; }

 private:
  std::int64_t asked_ = 0;
};

Registry make_registry() {
  Registry registry;
  const auto whole = [](const char* name) {
    return std::vector<PortSpec>{{.name = name, .type = {.kind = ValueKind::integer, .lowest = 1.0}}};
  };
  registry.add_action({.id = "Works", .ports = whole("ticks")}, [] { return std::make_unique<Works>(); });
  registry.add_condition({.id = "Turns", .ports = whole("turns")}, [] { return std::make_unique<Turns>(); });
  return registry;
}

std::string file_of(const std::string& nodes) {
  return "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">" + nodes + "</BehaviorTree></root>";
}

// Every node is visited at every tick: conditions that hold, in reactive sequences.
std::string all_visited(std::size_t nodes) {
  std::string text = "<ReactiveSequence>";
  for (std::size_t i = 1; i + 4 <= nodes; i += 4) {
    text +=
        "<ReactiveSequence><Turns "
        "turns=\"1000000000\"/><Inverter><AlwaysFailure/></Inverter></ReactiveSequence>";
  }
  return text + "<Works ticks=\"1000000000\"/></ReactiveSequence>";
}

// Parts of 13 nodes that begin, end, fail and are halted at different ticks.
std::string mixed(std::size_t nodes) {
  std::string text = "<ParallelAll max_failures=\"-1\">";
  for (std::size_t i = 1; i + 13 <= nodes + 1; i += 13) {
    text += fmt::format(
        "<KeepRunningUntilFailure><ForceSuccess><ReactiveFallback><Sequence><Turns turns=\"{}\"/><Works "
        "ticks=\"{}\"/>"
        "<SetBlackboard value=\"done\" output_key=\"k{}\"/></Sequence><Timeout msec=\"{}\"><Works "
        "ticks=\"50\"/></Timeout>"
        "<Switch2 variable=\"{{k{}}}\" case_1=\"done\" "
        "case_2=\"open\"><AlwaysSuccess/><AlwaysFailure/><AlwaysSuccess/></Switch2>"
        "</ReactiveFallback></ForceSuccess></KeepRunningUntilFailure>",
        2 + i % 7, 1 + i % 5, i, 20 + i % 90, i);
  }
  return text + "</ParallelAll>";
}

void measure(const char* what, const std::string& file, int ticks) {
  const Registry registry = make_registry();
  const std::int64_t begun = processor_ns();
  Description description = parse_tree(file, "bench.xml", registry);
  const double read_ms = 1e-6 * static_cast<double>(processor_ns() - begun);
  const std::size_t count = description.nodes.size();
  Tree tree(std::move(description), registry);
  std::vector<std::int64_t> cost_ns;
  cost_ns.reserve(static_cast<std::size_t>(ticks));
  std::size_t changes = 0;
  for (int tick = 0; tick < ticks; ++tick) {
    const std::int64_t before = processor_ns();
    (void)tree.tick(tick * std::int64_t{10'000'000});
    cost_ns.push_back(processor_ns() - before);
    changes += tree.transitions().size();
  }
  std::ranges::sort(cost_ns);
  const auto at = [&](double share) {
    return 1e-3 *
           static_cast<double>(cost_ns[std::min(
               cost_ns.size() - 1, static_cast<std::size_t>(share * static_cast<double>(cost_ns.size())))]);
  };
  fmt::print("{:<22} {:>6} {:>9.1f} {:>8.2f} {:>8.2f} {:>8.2f} {:>9.1f} {:>9.1f}\n", what, count, read_ms,
             at(0.5), at(0.99), at(0.999), at(1.0), static_cast<double>(changes) / ticks);
}

}  // namespace
}  // namespace gaitway::behaviour

int main(int argc, char** argv) {
  using namespace gaitway::behaviour;
  constexpr int kTicks = 100'000;
  const int ticks = argc > 1 ? std::max(1, std::atoi(argv[1])) : kTicks;
  fmt::print("{:<22} {:>6} {:>9} {:>8} {:>8} {:>8} {:>9} {:>9}\n", "", "nodes", "read ms", "p50 us", "p99 us",
             "p99.9 us", "worst us", "changes");
  measure("all visited", file_of(all_visited(200)), ticks);
  measure("mixed", file_of(mixed(200)), ticks);
  measure("largest, all visited", file_of(all_visited(kMostNodes)), std::max(1, ticks / 50));
  measure("largest, mixed", file_of(mixed(kMostNodes)), std::max(1, ticks / 50));
  measure("deepest", test::deep_file(kMostDepth, "<Turns turns=\"3\"/>"), std::max(1, ticks / 10));
}
