// What one datagram costs the desk: of a client that is let in, and of somebody without the token.
#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "gaitway/stopgram/stop_desk.hpp"
#include "gaitway/stopgram/stop_sender.hpp"

namespace gaitway::stopgram {
namespace {

constexpr char kToken[] = "0123456789abcdef";
constexpr std::int64_t kMs = facts::kMillisecond_ns;

struct Desk {
  Desk() {
    for (std::uint64_t client = 1; client <= StopDesk::kClients; ++client) {
      take(Stop{client, 1, 0, 1, StopKind::stop});
    }
  }
  template <class Message>
  Bytes make(const Message& message) {
    return signed_datagram(key, message, room);
  }
  template <class Message>
  void take(const Message& message) {
    benchmark::DoNotOptimize(desk.on_datagram(make(message), peer, kMs));
    while (desk.next_stop(asked)) ++asked.stops;
    desk.obeyed(asked);
  }

  StopKey key{kToken};
  StopDesk desk{StopKey(kToken), 1};
  Peer peer;
  link::StopCounts asked;
  std::array<std::uint8_t, kMostDatagramBytes> room{};
};

void take_again(benchmark::State& state, Desk& desk, Bytes datagram) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(desk.desk.on_datagram(datagram, desk.peer, kMs));
  }
}

void greeting(benchmark::State& state) {
  Desk desk;
  take_again(state, desk, desk.make(Greeting{7, 1}));
}
BENCHMARK(greeting);

// Answered, not carried out again; all places of the desk are taken.
void repeated_stop(benchmark::State& state) {
  Desk desk;
  take_again(state, desk, desk.make(Stop{StopDesk::kClients, 1, 0, 1, StopKind::stop}));
}
BENCHMARK(repeated_stop);

// With the signing of it, as its sender does.
void new_stop(benchmark::State& state) {
  Desk desk;
  for (std::uint32_t number = 2; auto _ : state) {
    desk.take(Stop{StopDesk::kClients, 1, 0, number++, StopKind::stop});
  }
}
BENCHMARK(new_stop);

void forged_stop(benchmark::State& state) {
  Desk desk;
  desk.make(Stop{1, 1, 0, 2, StopKind::stop});
  desk.room.back() ^= 1U;
  take_again(state, desk, desk.room);
}
BENCHMARK(forged_stop);

void foreign_datagram(benchmark::State& state) {
  Desk desk;
  take_again(state, desk, std::vector<std::uint8_t>(kStopBytes, 1));
}
BENCHMARK(foreign_datagram);

}  // namespace
}  // namespace gaitway::stopgram
