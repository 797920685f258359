// What a topic costs: write and read, small and large, and the packing of a hand-over. Target: 1 KiB in at
// most 150 ns each.
#include <benchmark/benchmark.h>

#include <memory>
#include <vector>

#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/msgclient/hand_over.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::msgclient {
namespace {

struct Topic {
  explicit Topic(std::size_t bytes)
      : descriptor{"sample", "Sample", 1, static_cast<std::uint32_t>(bytes), TopicKind::latest, 0},
        value(bytes) {}
  MemoryBlock block;
  Client client = block.local_client("bench");
  TopicDescriptor descriptor;
  std::vector<unsigned char> value;
};

void write(benchmark::State& state) {
  Topic topic(static_cast<std::size_t>(state.range(0)));
  UntypedWriter writer = topic.client.write_untyped(topic.descriptor);
  for (auto _ : state) {
    benchmark::DoNotOptimize(topic.value.data());
    benchmark::DoNotOptimize(writer.publish(topic.value.data(), 0));
  }
  state.SetBytesProcessed(state.iterations() * state.range(0));
}

void read(benchmark::State& state) {
  Topic topic(static_cast<std::size_t>(state.range(0)));
  UntypedWriter writer = topic.client.write_untyped(topic.descriptor);
  UntypedReader reader = topic.client.read_untyped(topic.descriptor);
  writer.publish(topic.value.data(), 0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(reader.read(topic.value.data()));
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * state.range(0));
}

BENCHMARK(write)
    ->Arg(64)
    ->Arg(1024)
    ->Arg(sizeof(JointStates))
    ->Arg(sizeof(MotionPlan))
    ->Arg(sizeof(JointPlan));
BENCHMARK(read)
    ->Arg(64)
    ->Arg(1024)
    ->Arg(sizeof(JointStates))
    ->Arg(sizeof(MotionPlan))
    ->Arg(sizeof(JointPlan));

std::unique_ptr<HandOver> full_hand_over() {
  auto hand_over = std::make_unique<HandOver>();
  hand_over->sequence = 1;
  hand_over->joint_count = 22;
  hand_over->point_count = 148;
  hand_over->trim.channel_count = kTrimChannels;
  return hand_over;
}

void hand_over_encode(benchmark::State& state) {
  const auto hand_over = full_hand_over();
  std::vector<std::uint32_t> words(kMaxHandOverWords);
  for (auto _ : state) {
    benchmark::DoNotOptimize(encode(*hand_over, words));
    benchmark::ClobberMemory();
  }
}
BENCHMARK(hand_over_encode);

void hand_over_decode(benchmark::State& state) {
  const auto hand_over = full_hand_over();
  std::vector<std::uint32_t> words(kMaxHandOverWords);
  words.resize(encode(*hand_over, words));
  for (auto _ : state) {
    benchmark::DoNotOptimize(decode(words, *hand_over));
    benchmark::ClobberMemory();
  }
}
BENCHMARK(hand_over_decode);

void hand_over_post_and_take(benchmark::State& state) {
  const auto hand_over = full_hand_over();
  const auto received = full_hand_over();
  MemoryBlock block;
  EmiAdapter emi(block);
  std::int64_t now_ns = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(emi.host().post(*hand_over, now_ns));
    now_ns += 80'000'000;
    benchmark::DoNotOptimize(emi.message().take_hand_over(*received, now_ns));
  }
}
BENCHMARK(hand_over_post_and_take);

void crc_of_10_kB(benchmark::State& state) {
  const std::vector<std::uint32_t> words(2500, 0x12345678u);
  for (auto _ : state) {
    benchmark::DoNotOptimize(crc32(words));
  }
}
BENCHMARK(crc_of_10_kB);

}  // namespace
}  // namespace gaitway::msgclient
