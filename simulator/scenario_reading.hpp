// What the readers of a scenario's events share.
#pragma once

#include <string>
#include <vector>

#include "gaitway/input/yaml_value.hpp"
#include "gaitway/simulator/scenario_event.hpp"

namespace gaitway::simulator {

inline constexpr input::Range kEventDuration{0.001, kLongestRun_s, "s"};

using Action = decltype(ScenarioEvent::action);

// One of the robot's names; `what` it names. All of these throw input::InputError.
[[nodiscard]] std::string read_name(const input::YamlValue& value, const urdf::RobotModel& robot,
                                    const char* what, const std::vector<std::string>& known);
// A joint, or the message controller.
[[nodiscard]] std::string read_node(const input::YamlValue& value, const urdf::RobotModel& robot,
                                    bool or_message_controller);
void require_true(const input::YamlValue& value);

[[nodiscard]] Action read_fault(const input::YamlValue& value, const urdf::RobotModel& robot);

}  // namespace gaitway::simulator
