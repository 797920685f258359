// What people asked of a served robot, as a scenario that `gaitway run` plays again.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/scenario.hpp"

namespace gaitway::simulator {

// Notes each walk request, motion request, place to walk to and user command with the millisecond in which it
// took effect.
class CommandLog {
 public:
  // Opens what `run` tells from now on; outlived by it. Throws msgclient::TopicError.
  explicit CommandLog(Cosimulation& run);

  void on_orders(const msgcontroller::PassedOrders& orders, std::int64_t now_ns);
  // What was done to the robot or its world, in the millisecond that comes next.
  void on_applied(const ScenarioEvent& event) { events_.push_back(event); }
  // `gaitway serve` itself ends the walk: nobody may walk on, and the safe tail plays.
  void on_end(std::int64_t now_ns);
  // After each millisecond; `began_ns`: when it began. What was obeyed in it.
  void on_millisecond(std::int64_t began_ns);

  [[nodiscard]] const std::vector<ScenarioEvent>& events() const noexcept { return events_; }
  // The scenario file: the same commands in the same milliseconds, over `seconds`.
  [[nodiscard]] std::string scenario(double seconds) const;

 private:
  Cosimulation& run_;
  msgclient::StreamReader<UserCommandAnswer> answers_;
  msgclient::Reader<StopRequest> stops_;
  StopRequest stops_logged_{};
  std::uint64_t releases_logged_;
  std::vector<ScenarioEvent> events_;
};

// A scenario file of these events. `world`: the one of the start.
[[nodiscard]] std::string scenario_text(double seconds, const std::optional<world::World>& world,
                                        std::span<const ScenarioEvent> events, const urdf::RobotModel& robot);

}  // namespace gaitway::simulator
