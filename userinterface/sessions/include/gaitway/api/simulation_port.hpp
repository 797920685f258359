// What clients may ask of a simulation, and of no real robot. Implemented over the simulator's own socket in
// the module, and by a recorder in tests.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "gaitway/api/robot_port.hpp"

namespace gaitway::api {

// A force on a link of the robot.
struct LinkPush {
  std::string link;
  std::array<double, 3> force_N{};
  bool along_heading = false;  // x of the force is where the robot looks; else that of the simulator's world
  double duration_s = 0.0;
};

// None of these blocks.
class SimulationPort {
 public:
  virtual ~SimulationPort() = default;

  // The number under which take_result() tells of it; never 0, and not one of the robot's orders. Throws
  // std::invalid_argument, naming field, value and rule.
  virtual std::uint32_t push(const LinkPush& push) = 0;
  // Likewise, of an order as the simulator has names for them, `{"order": NAME, ...}`; its result's text is
  // the JSON of the answer, or why not. It waits for its answer so long.
  virtual std::uint32_t order(const std::string& json, std::int64_t patience_ns) = 0;
  virtual std::optional<OrderResult> take_result() = 0;
};

// nullptr: there is none.
struct SimulationPorts {
  SimulationPort* simulation = nullptr;
  SimulationPort* twin = nullptr;  // of a real robot, beside the simulation
};

}  // namespace gaitway::api
