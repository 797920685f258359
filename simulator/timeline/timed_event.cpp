// Events in and out of words.
#include "gaitway/timeline/timed_event.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaitway::timeline {

TimedEvent timed(const simulator::ScenarioEvent& event, const urdf::RobotModel& robot) {
  return {std::llround(event.at_s * 1e9), event.asked, simulator::action_text(event, robot)};
}

simulator::ScenarioEvent scenario_event(const TimedEvent& event, const urdf::RobotModel& robot) {
  simulator::ScenarioEvent result = simulator::parse_action("{" + event.text + "}", "time line", robot);
  result.at_s = static_cast<double>(event.at_ns) * 1e-9;
  result.asked = event.asked;
  return result;
}

std::string_view mark_of(const TimedEvent& event) noexcept {
  constexpr std::array<std::string_view, 3> kWorld{"spawn", "move", "remove"};
  const std::string_view word = std::string_view(event.text).substr(0, event.text.find(':'));
  if (word == "push" || word == "fault") return word;
  return std::ranges::find(kWorld, word) == kWorld.end() ? "command" : "world";
}

nlohmann::json to_json(std::span<const TimedEvent> events) {
  auto list = nlohmann::json::array();
  for (const TimedEvent& event : events) list.push_back({event.at_ns, event.asked, event.text});
  return list;
}

std::vector<TimedEvent> events_from(const nlohmann::json& list) {
  std::vector<TimedEvent> events;
  for (const nlohmann::json& one : list) {
    events.push_back({one.at(0).get<std::int64_t>(), one.at(1).get<bool>(), one.at(2).get<std::string>()});
  }
  return events;
}

std::vector<const TimedEvent*> without_renewals(std::span<const TimedEvent> events) {
  constexpr std::int64_t kRenewed_ns = 1'000'000'000;
  std::vector<const TimedEvent*> first_ones;
  const TimedEvent* command = nullptr;  // the last one
  for (const TimedEvent& event : events) {
    const bool is_command = mark_of(event) == "command";
    const bool is_again = is_command && command != nullptr && command->text == event.text &&
                          event.at_ns - command->at_ns <= kRenewed_ns;
    if (is_command) command = &event;
    if (!is_again) first_ones.push_back(&event);
  }
  return first_ones;
}

}  // namespace gaitway::timeline
