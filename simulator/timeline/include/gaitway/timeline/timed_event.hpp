// What happened on the time line, as copies of the simulation hand it on: an instant, and a scenario's words.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/simulator/scenario_event.hpp"

namespace gaitway::timeline {

struct TimedEvent {
  std::int64_t at_ns = 0;  // before the millisecond that begins then
  bool asked = false;      // as ScenarioEvent has it
  std::string text;        // simulator::action_text()
};

[[nodiscard]] TimedEvent timed(const simulator::ScenarioEvent& event, const urdf::RobotModel& robot);
// Throws input::InputError for words that no scenario has.
[[nodiscard]] simulator::ScenarioEvent scenario_event(const TimedEvent& event, const urdf::RobotModel& robot);
// Of its first word: command, push, fault or world.
[[nodiscard]] std::string_view mark_of(const TimedEvent& event) noexcept;

[[nodiscard]] nlohmann::json to_json(std::span<const TimedEvent> events);
[[nodiscard]] std::vector<TimedEvent> events_from(const nlohmann::json& list);

// For pictures of the line: of a command that is only said again, as a velocity that is held is ten times a
// second, the first alone.
[[nodiscard]] std::vector<const TimedEvent*> without_renewals(std::span<const TimedEvent> events);

}  // namespace gaitway::timeline
