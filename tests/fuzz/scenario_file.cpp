// Scenarios as users write them (simulator/scenario.hpp). Whatever the text: it is refused with
// urdf::RobotError and nothing else, or gives events in the order of time, all within the limits that the
// robot's command has.
#include "gaitway/msgcontroller/command_arbiter.hpp"
#include "gaitway/simulator/scenario.hpp"

#include <cmath>
#include <cstdint>
#include <span>
#include <variant>

#include "fuzz_input.hpp"
#include "memory_file.hpp"
#include "robot.hpp"

namespace gaitway::fuzz {
namespace {

bool is_probability(double value) {
  return value >= 0.0 && value <= 1.0;
}

void check_bus_fault(const simulator::ScenarioEvent& event) {
  if (const auto* const loss = std::get_if<simulator::LoseFramesFault>(&event.action)) {
    require(is_probability(loss->probability), "a probability is one");
  } else if (const auto* const disturbance = std::get_if<simulator::DisturbBusFault>(&event.action)) {
    require(is_probability(disturbance->corruption) && is_probability(disturbance->omission) &&
                is_probability(disturbance->duplicate),
            "a probability is one");
  } else if (const auto* const foreign = std::get_if<simulator::ForeignFrameFault>(&event.action)) {
    require(can::is_valid(foreign->frame), "a foreign frame is one that can be sent");
  } else if (const auto* const restart = std::get_if<simulator::JointRestartsFault>(&event.action)) {
    require(shipped_robot().joint_index(restart->joint) >= 0, "a joint that restarts is one");
  }
}

void check(const simulator::ScenarioEvent& event) {
  require(event.at_s >= 0.0 && std::isfinite(event.at_s), "events happen at a time");
  const std::string text = simulator::action_text(event, shipped_robot());
  require(simulator::action_text(simulator::parse_action("{" + text + "}", "log", shipped_robot()),
                                 shipped_robot()) == text,
          "a log's words read back the same");
  if (const auto* const walk = std::get_if<simulator::WalkEvent>(&event.action)) {
    require(walk->velocity_m_per_s.norm() <= msgcontroller::kLargestWalkSpeed_m_per_s &&
                std::abs(walk->turn_rate_rad_per_s) <= msgcontroller::kLargestTurnRate_rad_per_s,
            "no walk is faster than allowed");
  } else if (const auto* const push = std::get_if<simulator::PushEvent>(&event.action)) {
    require(push->duration_s > 0.0 && std::isfinite(push->impulse_Ns) && push->direction.norm() > 0.0,
            "a push is a force");
    require(shipped_robot().link_index(push->body) >= 0, "a push has a link");
  }
  check_bus_fault(event);
}

}  // namespace

void scenario_file(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(Input(bytes).rest_as_text());
  simulator::Scenario scenario;
  try {
    scenario = simulator::load_scenario(file.path(), shipped_robot());
  } catch (const urdf::RobotError&) {
    return;
  }
  require(scenario.seconds > 0.0 && std::isfinite(scenario.seconds), "a run has a length");
  double last_s = 0.0;
  for (const simulator::ScenarioEvent& event : scenario.events) {
    check(event);
    require(event.at_s >= last_s, "events stand in the order of time");
    last_s = event.at_s;
  }
}

}  // namespace gaitway::fuzz
