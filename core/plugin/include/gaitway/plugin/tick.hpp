// What a plug-in and its manager are told at each tick.
#pragma once

#include <cstdint>

namespace gaitway {

struct Tick {
  std::int64_t now_ns = 0;          // clock of the robot, virtual or real
  std::int64_t batch_start_ns = 0;  // when the batch that is being prepared will start to play
  std::uint32_t batch_sequence =
      0;                   // its sequence number = cycle number; between batches: the next one to come
  std::uint32_t tick = 0;  // ticks of 10 ms since start
  bool batch = false;      // this tick prepares a batch (every eighth)

  friend bool operator==(const Tick&, const Tick&) = default;
};

enum class Period : std::uint32_t {
  tick = 0,
  batch = 1
};  // every 10 ms, or only at ticks that prepare a batch

}  // namespace gaitway
