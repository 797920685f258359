// Something in the room that sees where the robot is, as cameras at the ceiling do: rarely, late, and not
// exactly.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <span>

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

// Upright boxes on the ground around each of them, as something that looks down sees them.
[[nodiscard]] Obstacles boxes_around(std::span<const world::Solid> solids);

// Writes the topic `pose_measurement`, and `obstacles` as soon as something has been put into the world that
// the robot's map does not have, where nobody else writes it.
class Localization {
 public:
  // Throws msgclient::TopicError when somebody else writes the topic.
  Localization(msgclient::Client& client, const LocalizationOptions& options, std::uint64_t seed);

  // Once a millisecond.
  void step(std::int64_t now_ns, const Plant& plant);

 private:
  void see_robot(std::int64_t now_ns, const Plant& plant);
  void see_obstacles(std::int64_t now_ns, const Plant& plant);

  msgclient::Client& client_;
  LocalizationOptions options_;
  msgclient::Writer<PoseMeasurement> writer_;
  std::mt19937_64 random_;
  std::deque<PoseMeasurement> seen_;  // and not told yet
  std::optional<msgclient::Writer<Obstacles>> obstacles_;
  Obstacles told_{};
  bool others_see_obstacles_ = false;
};

}  // namespace gaitway::simulator
