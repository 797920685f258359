// Reads scenarios strictly: what isn't understood is refused with file, line, field, value and rule.
#include "gaitway/simulator/scenario.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgcontroller/command_arbiter.hpp"

namespace gaitway::simulator {
namespace {

using input::YamlValue;
using msgcontroller::kLargestTurnRate_rad_per_s;
using msgcontroller::kLargestWalkSpeed_m_per_s;

std::optional<world::WorldChoice> read_world_choice(const YamlValue& root) {
  const auto seed = root.find("world_seed");
  const auto world = root.find("world");
  if (!world) {
    if (seed) seed->refuse("needs a world", "Add 'world: NAME', or leave it out");
    return std::nullopt;
  }
  world::WorldChoice choice{
      .name = world->text(), .random_seed = {}, .written_in = world->file(), .line = world->line()};
  if (choice.name.empty()) world->refuse("must be a file, or the name of a shipped world", "Name one");
  if (seed) {
    choice.random_seed = static_cast<std::uint64_t>(seed->integer(0, std::numeric_limits<int>::max()));
  }
  return choice;
}

}  // namespace

Scenario load_scenario(const std::filesystem::path& file, const urdf::RobotModel& robot) {
  constexpr std::array<std::string_view, 6> kKeys{"seconds",    "to_the_end", "world",
                                                  "world_seed", "conditions", "events"};
  const YamlValue root = YamlValue::read(file);
  root.require_map(kKeys);
  Scenario scenario;
  scenario.seconds = root.at("seconds").number({0.001, kLongestRun_s, "s"});
  if (const auto to_the_end = root.find("to_the_end")) {
    if (to_the_end->text() != "true") to_the_end->refuse("must be true", "Leave it out to end after a fall");
    scenario.to_the_end = true;
  }
  if (const auto conditions = root.find("conditions")) scenario.conditions = read_conditions(*conditions);
  scenario.world = read_world_choice(root);
  if (const auto events = root.find("events")) {
    for (const YamlValue& event : events->items()) {
      scenario.events.push_back(read_event(event, robot));
      if (scenario.events.back().at_s >= scenario.seconds) {
        event.at("at_s").refuse(
            fmt::format("must be before the end of the run at {:g} s, or it never happens", scenario.seconds),
            "Give a longer 'seconds', or remove the event");
      }
    }
  }
  std::ranges::stable_sort(scenario.events, {}, &ScenarioEvent::at_s);
  return scenario;
}

Scenario walk_scenario(double forward_m_per_s, double left_m_per_s, double turn_rate_rad_per_s,
                       double seconds) {
  constexpr double kStanding_s = 1.0;
  const Eigen::Vector2d velocity(forward_m_per_s, left_m_per_s);
  if (!(velocity.norm() <= kLargestWalkSpeed_m_per_s &&
        std::abs(turn_rate_rad_per_s) <= kLargestTurnRate_rad_per_s)) {
    throw urdf::RobotError(
        fmt::format("walk command {}, {} m/s and {} rad/s: at most {} m/s and {} rad/s may be commanded. "
                    "Choose a lower speed.",
                    forward_m_per_s, left_m_per_s, turn_rate_rad_per_s, kLargestWalkSpeed_m_per_s,
                    kLargestTurnRate_rad_per_s));
  }
  Scenario scenario{.seconds = seconds, .conditions = {}, .world = {}, .events = {}};
  scenario.events.push_back(
      {.at_s = kStanding_s,
       .action = WalkEvent{.velocity_m_per_s = velocity, .turn_rate_rad_per_s = turn_rate_rad_per_s}});
  return scenario;
}

}  // namespace gaitway::simulator
