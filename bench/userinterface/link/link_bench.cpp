// What the narrow link costs its processes, and how long orders take on a Unix socket and on simulated I2C.
#include <benchmark/benchmark.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <random>
#include <vector>

#include "gaitway/link/controller_end.hpp"
#include "gaitway/link/i2c_bus.hpp"
#include "gaitway/link/module_end.hpp"
#include "gaitway/link/unix_carrier.hpp"
#include "gaitway/link/worst_case.hpp"

namespace gaitway::link {
namespace {

constexpr std::array kChannels{Channel{"joints", 1500}, Channel{"estimate", 200}, Channel{"walk", 64}};
constexpr std::int64_t kMs = facts::kMillisecond_ns;
constexpr std::size_t kOrderBytes = 40;  // a velocity command

struct Ends {
  std::unique_ptr<ModuleEnd> module =
      std::make_unique<ModuleEnd>(LinkIdentity{Role::module, 1, 1, "module"}, kChannels, LinkSettings{});
  std::unique_ptr<ControllerEnd> controller = std::make_unique<ControllerEnd>(
      LinkIdentity{Role::controller, 2, 1, "controller"}, kChannels, LinkSettings{});

  void publish_all(std::int64_t now_ns) {
    static const std::vector<std::uint8_t> value(1500, 1);
    for (std::size_t i = 0; i < kChannels.size(); ++i) {
      controller->publish(i, Bytes(value).first(kChannels[i].most_bytes), now_ns);
    }
  }
  // Carries out and answers what has come.
  bool carry_out(std::int64_t now_ns) {
    const std::optional<Order> order = controller->next_order(now_ns);
    return order && controller->answer(order->id, 0, {});
  }
  bool submit(std::int64_t now_ns) {
    static const std::vector<std::uint8_t> order(kOrderBytes, 1);
    return module->submit(1, order, now_ns + facts::kSecond_ns, now_ns).refusal == Refusal::none;
  }
};

void frame(benchmark::State& state) {
  const std::vector<std::uint8_t> content(static_cast<std::size_t>(state.range(0)), 3);
  std::array<std::uint8_t, kMostFrameBytes> wire{};
  FrameDecoder decoder;
  for (auto _ : state) {
    const std::size_t size = encode_frame(content, wire);
    for (std::size_t i = 0; i < size; ++i) {
      benchmark::DoNotOptimize(decoder.take(wire[i]));
    }
  }
  state.SetBytesProcessed(state.iterations() * state.range(0));
}
BENCHMARK(frame)->Arg(32)->Arg(kMostContentBytes);

// Both ends for a millisecond of virtual time on I2C with state on all channels.
void busy_millisecond(benchmark::State& state) {
  Ends ends;
  I2cBus bus;
  std::int64_t now_ns = 0;
  for (auto _ : state) {
    ends.publish_all(now_ns);
    for (const std::int64_t end_ns = now_ns + kMs; now_ns < end_ns;) {
      pump(*ends.module, bus.master(), now_ns);
      pump(*ends.controller, bus.slave(), now_ns);
      now_ns = bus.advance(end_ns).value_or(end_ns);
    }
  }
}
BENCHMARK(busy_millisecond);

// From submit() to the outcome, both ends in one thread.
void order_over_unix_socket(benchmark::State& state) {
  std::array<int, 2> sockets{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK, 0, sockets.data()) != 0) {
    state.SkipWithError("no socket");
    return;
  }
  UnixCarrier left{process::FileDescriptor(sockets[0])}, right{process::FileDescriptor(sockets[1])};
  Ends ends;
  const auto now = [] {
    return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
  };
  const auto turn = [&] {
    pump(*ends.module, left, now());
    pump(*ends.controller, right, now());
  };
  while (!ends.module->session().open() || !ends.controller->session().open()) turn();
  for (auto _ : state) {
    while (!ends.submit(now())) turn();
    while (!ends.module->next_outcome(now())) {
      turn();
      ends.carry_out(now());
    }
  }
}
BENCHMARK(order_over_unix_socket);

// Virtual time: orders at random moments while state fills the bus. Counters in ms, and the bound of
// worst_case.hpp.
void order_over_i2c(benchmark::State& state) {
  std::vector<double> waits_ms, answers_ms;
  double state_bytes = 0.0, seconds = 0.0;
  for (auto _ : state) {
    Ends ends;
    I2cBus bus;
    std::mt19937_64 random(1);
    std::int64_t now_ns = 0, next_ns = 300 * kMs, given_ns = 0;
    while (waits_ms.size() < 10'000) {
      ends.publish_all(now_ns);
      if (given_ns == 0 && now_ns >= next_ns && ends.submit(now_ns)) given_ns = now_ns;
      pump(*ends.module, bus.master(), now_ns);
      pump(*ends.controller, bus.slave(), now_ns);
      if (ends.carry_out(now_ns)) waits_ms.push_back(static_cast<double>(now_ns - given_ns) * 1e-6);
      if (ends.module->next_outcome(now_ns)) {
        answers_ms.push_back(static_cast<double>(now_ns - given_ns) * 1e-6);
        given_ns = 0;
        next_ns = now_ns + static_cast<std::int64_t>(random() % (40 * kMs));
      }
      const std::int64_t latest_ns = given_ns == 0 && next_ns > now_ns ? next_ns : now_ns + kMs;
      now_ns = bus.advance(latest_ns).value_or(latest_ns);
    }
    for (std::size_t i = 0; i < kChannels.size(); ++i) {
      state_bytes += static_cast<double>(ends.module->state().value(i).updates * kChannels[i].most_bytes);
    }
    seconds += static_cast<double>(now_ns) * 1e-9;
  }
  std::ranges::sort(waits_ms);
  std::ranges::sort(answers_ms);
  state.counters["p50"] = waits_ms[waits_ms.size() / 2];
  state.counters["p99"] = waits_ms[waits_ms.size() * 99 / 100];
  state.counters["longest"] = waits_ms.back();
  state.counters["bound"] =
      static_cast<double>(worst_order_wait_ns(i2c_timing({}), LinkSettings{}, kOrderBytes)) * 1e-6;
  state.counters["answer_p99"] = answers_ms[answers_ms.size() * 99 / 100];
  state.counters["state_kB_per_s"] = state_bytes / seconds * 1e-3;
}
BENCHMARK(order_over_i2c)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gaitway::link
