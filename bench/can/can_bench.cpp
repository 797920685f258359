// What the bus costs the simulation: exact frame length (target: at most 150 ns for 8 bytes), codecs, a bus
// event with 23 stations (target: 2 million a second without faults), a line of the log.
#include <benchmark/benchmark.h>

#include <array>
#include <random>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/can/simulated/simulated_bus.hpp"

namespace gaitway::can {
namespace {

constexpr std::size_t kFrames = 1024;

std::array<Frame, kFrames> random_frames() {
  std::mt19937 random(1);
  std::array<Frame, kFrames> frames;
  for (Frame& frame : frames) {
    frame = {static_cast<std::uint32_t>(random() & 0x7FFU), 8, {}};
    for (std::uint8_t& byte : frame.data) {
      byte = static_cast<std::uint8_t>(random());
    }
  }
  return frames;
}

void frame_length(benchmark::State& state) {
  const auto frames = random_frames();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(frame_bits(frames[i++ % kFrames]));
  }
}
BENCHMARK(frame_length);

void encode_feedback(benchmark::State& state) {
  Feedback message{.node = 3, .position = -1234, .current = 5, .channel = {100, -200}};
  for (auto _ : state) {
    benchmark::DoNotOptimize(message);
    benchmark::DoNotOptimize(encode(kFullProfile, message));
  }
}
BENCHMARK(encode_feedback);

void decode_feedback(benchmark::State& state) {
  Frame frame =
      encode(kFullProfile, Feedback{.node = 3, .position = -1234, .current = 5, .channel = {100, -200}});
  for (auto _ : state) {
    benchmark::DoNotOptimize(frame);
    benchmark::DoNotOptimize(can::decode_feedback(kFullProfile, frame));
  }
}
BENCHMARK(decode_feedback);

// 22 joints and the message controller; all of them always have a frame to send. Argument: corrupted frames
// in a thousand. No two stations send one identifier.
void bus_event(benchmark::State& state) {
  constexpr int kStations = 23;
  auto frames = random_frames();
  SimulatedBus bus;
  bus.set_random_faults({.seed = 1, .corruption = static_cast<double>(state.range(0)) * 1e-3});
  std::size_t next = 0;
  const auto offer = [&](int station, std::int64_t now_ns) {
    Frame& frame = frames[next++ % kFrames];
    frame.id = frame.id % 64U * 32U + static_cast<std::uint32_t>(station);
    bus.transmit(station, frame, now_ns);
  };
  for (int station = 0; station < kStations; ++station) {
    offer(bus.attach(), 0);
  }
  std::int64_t now_ns = 0, frames_sent = 0;
  for (auto _ : state) {
    const auto delivery = bus.advance(now_ns += 200'000);
    if (delivery) {
      offer(delivery->sender, delivery->end_ns);
      ++frames_sent;
    }
    benchmark::DoNotOptimize(delivery);
  }
  state.SetItemsProcessed(frames_sent);
  state.counters["error_frames"] = static_cast<double>(bus.statistics().error_frames);
}
BENCHMARK(bus_event)->Arg(0)->Arg(10);

void log_line(benchmark::State& state) {
  const auto frames = random_frames();
  CandumpWriter writer("/dev/null");
  std::int64_t now_ns = 0;
  std::size_t next = 0;
  for (auto _ : state) {
    writer.write(now_ns += 117'000, frames[next++ % kFrames]);
  }
}
BENCHMARK(log_line);

}  // namespace
}  // namespace gaitway::can
