// The response-time analysis of the robot's bus, as it is done before each start (target: at most 1 ms).
#include <benchmark/benchmark.h>

#include <numeric>
#include <vector>

#include "gaitway/can/analysis/network_messages.hpp"
#include "gaitway/can/analysis/response_time.hpp"

namespace gaitway::can {
namespace {

const ProofAssumptions& assumptions() {
  static const ProofAssumptions kHarsh{.jitter_ns = 1'000'000, .errors = jam(2'000'000), .bit_time_ns = 1000};
  return kHarsh;
}

std::vector<NodeId> nodes() {
  std::vector<NodeId> all(22);
  std::iota(all.begin(), all.end(), NodeId{1});
  return all;
}

void prove_full_profile(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(prove(kFullProfile, nodes(), assumptions()));
  }
}
BENCHMARK(prove_full_profile)->Unit(benchmark::kMicrosecond);

void breakdown_of_full_profile(benchmark::State& state) {
  const auto messages = message_set(kFullProfile, nodes(), assumptions().jitter_ns);
  for (auto _ : state) {
    benchmark::DoNotOptimize(breakdown(messages, {.bit_time_ns = 1000, .errors = assumptions().errors}));
  }
}
BENCHMARK(breakdown_of_full_profile)->Unit(benchmark::kMicrosecond);

void best_order_of_full_profile(benchmark::State& state) {
  const auto messages = message_set(kFullProfile, nodes(), assumptions().jitter_ns);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        best_priority_order(messages, {.bit_time_ns = 1000, .errors = assumptions().errors}));
  }
}
BENCHMARK(best_order_of_full_profile)->Unit(benchmark::kMicrosecond);

void joints_that_fit(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(most_joints(kFullProfile, assumptions()));
  }
}
BENCHMARK(joints_that_fit)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace gaitway::can
