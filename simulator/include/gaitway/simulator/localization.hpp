// Something in the room that sees where the robot is, as cameras at the ceiling do: rarely, late, and not
// exactly.
#pragma once

#include <cstdint>
#include <deque>
#include <random>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/simulator/plant.hpp"

namespace gaitway::simulator {

struct LocalizationOptions {
  bool is_there = false;
  std::int64_t period_ns = 100'000'000;
  std::int64_t delay_ns = 100'000'000;  // from what was seen to its being told
  double deviation_m = 0.005;           // standard deviation of each axis
  double deviation_rad = 0.01;
};

// Writes the topic `pose_measurement`.
class Localization {
 public:
  // Throws msgclient::TopicError when somebody else writes the topic.
  Localization(msgclient::Client& client, const LocalizationOptions& options, std::uint64_t seed);

  // Once a millisecond.
  void step(std::int64_t now_ns, const Plant& plant);

 private:
  LocalizationOptions options_;
  msgclient::Writer<PoseMeasurement> writer_;
  std::mt19937_64 random_;
  std::deque<PoseMeasurement> seen_;  // and not told yet
};

}  // namespace gaitway::simulator
