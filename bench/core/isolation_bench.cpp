// What a process of its own adds to a plug-in's step, beside bare round trips between two processes: one
// right after the other, and paced, with both sides idle for a while before each.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <time.h>

#include <string>

#include "echo_process.hpp"
#include "gaitway/manager/plugin_manager.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/plugin/cycle.hpp"
#include "rivals.hpp"

namespace gaitway::core {
namespace {

constexpr double kMost_us = 60.0;
constexpr double kMostOfFutex = 2.0;
constexpr std::int64_t kPause_ns = 1'000'000;
constexpr int kBurst = 20;

enum : std::size_t { kInProcess, kIsolated, kFutex, kSpinning, kWays };

// One relay under a manager, with a memory block of its own.
class RelayManager {
 public:
  explicit RelayManager(const std::string& isolation)
      : manager_(configuration(isolation), options(), client_) {}
  void step() noexcept {
    failed_ += manager_.step(tick_at(now_ns_));
    now_ns_ += facts::kSlot_ns;
  }
  [[nodiscard]] int failed() const noexcept { return failed_; }

 private:
  static Configuration configuration(const std::string& isolation) {
    return parse_configuration(
        fmt::format("plugins:\n  - {{name: it, library: relay.so, isolation: {}}}\n", isolation),
        "bench.yaml");
  }
  static PluginManagerOptions options() {
    PluginManagerOptions options;
    options.plugin_path = {GAITWAY_TEST_PLUGINS};
    return options;
  }

  msgclient::MemoryBlock block_;
  msgclient::Client client_ = block_.local_client("bench");
  PluginManager manager_;
  std::int64_t now_ns_ = kTickPhase_ns;
  int failed_ = 0;
};

class Contest {
 public:
  void run(std::size_t rival) {
    rivals_.time(rival, [&] {
      switch (rival) {
        case kInProcess:
          return in_process_.step();
        case kIsolated:
          return isolated_.step();
        case kFutex:
          return futex_.round_trip();
        default:
          return spinning_.round_trip();
      }
    });
  }
  void report(benchmark::State& state) const {
    if (in_process_.failed() + isolated_.failed() > 0) {
      state.SkipWithError("a step failed: nothing was measured");
      return;
    }
    const double here = rivals_.percentile_us(kInProcess);
    const double added = rivals_.percentile_us(kIsolated) - here;
    const double futex = rivals_.percentile_us(kFutex);
    state.counters["added_p50_us"] = added;
    state.counters["added_p99_us"] = rivals_.percentile_us(kIsolated, 0.99) - here;
    state.counters["futex_p50_us"] = futex;
    state.counters["futex_p99_us"] = rivals_.percentile_us(kFutex, 0.99);
    state.counters["spin_p50_us"] = rivals_.percentile_us(kSpinning);
    state.counters["spin_p99_us"] = rivals_.percentile_us(kSpinning, 0.99);
    state.counters["ratio"] = added / futex;
    state.counters["ratio_spin"] = added / rivals_.percentile_us(kSpinning);
    judge(state, added <= kMost_us && added <= kMostOfFutex * futex,
          "added p50 at most 60 us and 2 x a bare futex round trip");
  }

 private:
  EchoProcess futex_{EchoWait::futex}, spinning_{EchoWait::spin_then_futex};  // fork before all else
  RelayManager in_process_{"none"}, isolated_{"process"};
  Rivals rivals_{kWays};
};

void added_delay_back_to_back(benchmark::State& state) {
  Contest contest;
  for (auto iteration : state) {
    for (std::size_t rival = 0; rival < kWays; ++rival) {
      for (int i = 0; i < kBurst; ++i) {
        contest.run(rival);
      }
    }
  }
  contest.report(state);
}
BENCHMARK(added_delay_back_to_back)->Iterations(1000)->UseRealTime()->Unit(benchmark::kMillisecond);

void added_delay_paced(benchmark::State& state) {
  Contest contest;
  for (auto iteration : state) {
    for (std::size_t rival = 0; rival < kWays; ++rival) {
      const timespec pause{0, kPause_ns};
      clock_nanosleep(CLOCK_MONOTONIC, 0, &pause, nullptr);
      contest.run(rival);
    }
  }
  contest.report(state);
}
BENCHMARK(added_delay_paced)->Iterations(2000)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gaitway::core
